#include "core/mesh/import/gltf_nodes.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/mesh/import/gltf_extensions.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace unprojector::mesh::reader {
using namespace geometry;
using base::marked;
using base::tr;

namespace {

constexpr std::size_t kDeepestNode = 512;

[[noreturn]] void failNoTree()
{
    failMalformed(tr("the nodes form a circle or are nested too deeply"));
}

/// A node in a message: its index, and its name if it has one.
std::string nameOf(std::size_t number, const Json &node)
{
    const Json *name = GltfFile::find(node, "name");
    return std::to_string(number)
           + (name && name->is_string() ? " \"" + name->get<std::string>() + '"' : std::string());
}

/// An array of the given length; null if the node has none.
const Json *numbers(const Json &node, const char *key, std::size_t count)
{
    const Json *found = GltfFile::find(node, key);
    if (found && found->is_null())
        return nullptr;
    if (found && (!found->is_array() || found->size() != count))
        failMalformed(tr("\"%1\" of a node has not %2 numbers", key, count));
    return found;
}

/// Returns whether a node and all its descendants are hidden.
bool isHidden(const Json &node)
{
    const Json *visibility = extensionOf(node, "KHR_node_visibility");
    const Json *visible = visibility ? GltfFile::find(*visibility, "visible") : nullptr;
    return visible && *visible == false;
}

} // namespace

bool Placement::isRotationUnit() const
{
    constexpr double kFewDigits = 0.01;
    return std::abs(glm::length(rotation) - 1.0) <= kFewDigits;
}

const char *Placement::firstThatMoves() const
{
    if (translation != glm::dvec3(0.0))
        return "translation";
    if (rotation.x != 0.0 || rotation.y != 0.0 || rotation.z != 0.0)
        return "rotation";
    return scale != glm::dvec3(1.0) ? "scale" : nullptr;
}

PreciseMatrix Placement::matrix() const
{
    const DoubleDouble x(rotation.x), y(rotation.y), z(rotation.z), w(rotation.w);
    const DoubleDouble k = 2.0 / (x * x + y * y + z * z + w * w);
    PreciseMatrix turned(glm::dmat4(1.0));
    turned.columns[0] = {1.0 - k * (y * y + z * z), k * (x * y + w * z), k * (x * z - w * y), 0.0};
    turned.columns[1] = {k * (x * y - w * z), 1.0 - k * (x * x + z * z), k * (y * z + w * x), 0.0};
    turned.columns[2] = {k * (x * z + w * y), k * (y * z - w * x), 1.0 - k * (x * x + y * y), 0.0};
    const glm::dmat4 identity(1.0);
    return PreciseMatrix(glm::translate(identity, translation)) * turned * PreciseMatrix(glm::scale(identity, scale));
}

std::string wrongLastRow(const glm::dmat4 &matrix)
{
    constexpr double kRounding = 1e-6; // of single precision
    const glm::dvec4 row(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
    std::string text;
    bool isRight = true;
    for (int i = 0; i < 4; ++i) {
        isRight = isRight && std::abs(row[i] - (i == 3 ? 1.0 : 0.0)) <= kRounding;
        text += (i > 0 ? " " : "") + base::shortestText(row[i]);
    }
    return isRight ? std::string() : text;
}

glm::dmat4 withLastRow(glm::dmat4 matrix)
{
    for (int i = 0; i < 4; ++i)
        matrix[i][3] = i == 3 ? 1.0 : 0.0;
    return matrix;
}

PreciseMatrix GltfNodes::parentFromNode(std::size_t number) const
{
    const Json &node = m_file.array("nodes")[number];
    const auto at = [](const Json *list, std::size_t index) { return GltfFile::real((*list)[index]); };
    const auto vector = [&at](const Json *list) { return glm::dvec3(at(list, 0), at(list, 1), at(list, 2)); };
    glm::dmat4 matrix(1.0);
    if (const Json *given = numbers(node, "matrix", 16)) {
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = at(given, static_cast<std::size_t>(i));
        const std::string lastRow = wrongLastRow(matrix);
        if (!lastRow.empty())
            failMalformed(
                tr("the matrix of node %1 has the last row %2; it must be 0 0 0 1", nameOf(number, node), lastRow));
        matrix = withLastRow(matrix);
    }
    Placement placement;
    if (const Json *moved = numbers(node, "translation", 3))
        placement.translation = vector(moved);
    if (const Json *turned = numbers(node, "rotation", 4))
        placement.rotation = glm::dquat(at(turned, 3), at(turned, 0), at(turned, 1), at(turned, 2));
    if (const Json *scaled = numbers(node, "scale", 3))
        placement.scale = vector(scaled);
    if (!placement.isRotationUnit())
        failMalformed(tr("the rotation of node %1 has the length %2; it must be 1", nameOf(number, node),
                         base::shortestText(glm::length(placement.rotation))));
    if (matrix == glm::dmat4(1.0))
        return placement.matrix();
    if (const char *other = placement.firstThatMoves())
        failMalformed(
            tr("node %1 has both \"matrix\" and \"%2\", of which it may have one only", nameOf(number, node), other));
    return PreciseMatrix(matrix);
}

PreciseMatrix GltfNodes::worldFromNode(std::size_t node) const
{
    PreciseMatrix worldFromNode = parentFromNode(node);
    std::size_t depth = 1;
    for (std::size_t parent = m_parents[node]; parent != kNone; parent = m_parents[parent]) {
        if (++depth > kDeepestNode)
            failNoTree();
        worldFromNode = parentFromNode(parent) * worldFromNode;
    }
    return worldFromNode;
}

std::vector<std::size_t> GltfNodes::nodeList(const Json &object, const char *key) const
{
    std::vector<std::size_t> list;
    const std::size_t count = m_file.array("nodes").size();
    for (const Json &entry : GltfFile::array(object, key)) {
        if (!entry.is_number_unsigned() || entry.get<std::uint64_t>() >= count)
            failMalformed(tr("\"%1\" refers to a node that the file does not have", key));
        list.push_back(entry.get<std::size_t>());
    }
    return list;
}

GltfNodes::GltfNodes(const GltfFile &file, std::vector<base::Note> &notes) : m_file(file)
{
    const Json &nodes = m_file.array("nodes");
    m_parents.assign(nodes.size(), kNone);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        for (const std::size_t child : nodeList(nodes[n], "children")) {
            if (m_parents[child] != kNone)
                failMalformed(tr("node %1 has two parents", child));
            m_parents[child] = n;
        }
    }
    const Json &scenes = m_file.array("scenes");
    const bool isChosen = GltfFile::find(m_file.root(), "scene");
    if (isChosen || !scenes.empty()) {
        const Json &scene = isChosen ? m_file.reference(m_file.root(), "scene", "scenes") : scenes[0];
        setRoots(nodeList(scene, "nodes"), notes);
        return;
    }
    notes.push_back({marked("the file has no scene: all its nodes are shown")});
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (m_parents[n] == kNone)
            m_roots.push_back(n);
    }
    if (m_roots.empty() && !nodes.empty())
        failNoTree();
}

void GltfNodes::setRoots(const std::vector<std::size_t> &listed, std::vector<base::Note> &notes)
{
    const auto nameAt = [this](std::size_t node) { return nameOf(node, m_file.array("nodes")[node]); };
    std::vector<bool> areListed(m_parents.size()), areRoots(m_parents.size());
    for (const std::size_t node : listed)
        areListed[node] = true;
    for (const std::size_t node : listed) {
        std::size_t root = node, above = node, depth = 0;
        bool isMoved = false; // by the nodes above the root
        for (std::size_t parent = m_parents[node]; parent != kNone; parent = m_parents[parent]) {
            if (++depth > kDeepestNode)
                failNoTree();
            isMoved = !areListed[parent] && (isMoved || changesChildren(parent));
            root = areListed[parent] ? parent : root;
            above = parent;
        }
        if (isMoved)
            failMalformed(tr("the scene lists node %1, but not node %2 that it is below; list node %2 instead",
                             nameAt(node), above));
        if (node == root && !areRoots[node])
            m_roots.push_back(node);
        areRoots[node] = node == root;
    }
    base::addNote(notes, listed.size() - m_roots.size(),
                  marked("the scene lists %1 node twice or beside its parent: it is shown once"),
                  marked("the scene lists %1 nodes twice or beside their parents: each is shown once"));
}

bool GltfNodes::changesChildren(std::size_t node) const
{
    return isHidden(m_file.array("nodes")[node]) || parentFromNode(node).rounded() != glm::dmat4(1.0);
}

GltfShown GltfNodes::shown() const
{
    struct Waiting {
        std::size_t node, depth;
        bool isBelowHidden;
        PreciseMatrix worldFromParent;
    };
    std::vector<Waiting> waiting;
    const auto add = [&waiting](const std::vector<std::size_t> &list, std::size_t depth, bool isBelowHidden,
                                const PreciseMatrix &parent) {
        for (auto node = list.rbegin(); node != list.rend(); ++node)
            waiting.push_back({*node, depth, isBelowHidden, parent});
    };
    GltfShown shown;
    std::vector<bool> isUsed(m_file.array("meshes").size());
    add(m_roots, 1, false, PreciseMatrix(glm::dmat4(1.0)));
    while (!waiting.empty()) {
        const Waiting next = waiting.back();
        waiting.pop_back();
        if (next.depth > kDeepestNode)
            failNoTree();
        const Json &node = m_file.array("nodes")[next.node];
        const PreciseMatrix worldFromNode = next.worldFromParent * parentFromNode(next.node);
        const bool isNowHidden = next.isBelowHidden || isHidden(node);
        if (GltfFile::find(node, "mesh")) {
            const std::uint64_t mesh = GltfFile::number(node, "mesh", 0);
            if (mesh < isUsed.size())
                isUsed[static_cast<std::size_t>(mesh)] = true;
            if (isNowHidden)
                ++shown.hidden;
            else
                shown.nodes.push_back({next.node, worldFromNode});
        }
        add(nodeList(node, "children"), next.depth + 1, isNowHidden, worldFromNode);
    }
    shown.meshesElsewhere = static_cast<std::size_t>(std::ranges::count(isUsed, false));
    return shown;
}

} // namespace unprojector::mesh::reader
