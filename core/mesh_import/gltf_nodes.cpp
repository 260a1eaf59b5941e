#include "core/mesh_import/gltf_nodes.h"

#include "core/text/translation.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <string>

namespace unprojector::mesh_import::mesh_reader {
using text::tr;

namespace {

constexpr std::size_t kDeepestNode = 512;

[[noreturn]] void failNoTree()
{
    failMalformed(tr("the nodes form a circle or are nested too deeply"));
}

/// An array of so many numbers, or null.
const Json *numbers(const Json &node, const char *key, std::size_t count)
{
    const Json *found = GltfFile::find(node, key);
    if (found && (!found->is_array() || found->size() != count))
        failMalformed(tr("\"%1\" of a node has not %2 numbers", key, count));
    return found;
}

glm::dmat4 parentFromNode(const Json &node)
{
    const auto at = [](const Json *list, std::size_t place) { return GltfFile::real((*list)[place]); };
    glm::dmat4 matrix(1.0);
    if (const Json *given = numbers(node, "matrix", 16)) {
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = at(given, static_cast<std::size_t>(i));
        return matrix;
    }
    if (const Json *moved = numbers(node, "translation", 3))
        matrix = glm::translate(matrix, {at(moved, 0), at(moved, 1), at(moved, 2)});
    if (const Json *turned = numbers(node, "rotation", 4))
        matrix *= glm::mat4_cast(glm::dquat(at(turned, 3), at(turned, 0), at(turned, 1), at(turned, 2)));
    if (const Json *scaled = numbers(node, "scale", 3))
        matrix = glm::scale(matrix, {at(scaled, 0), at(scaled, 1), at(scaled, 2)});
    return matrix;
}

} // namespace

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

GltfNodes::GltfNodes(const GltfFile &file, std::vector<ModelNote> &notes) : m_file(file)
{
    const Json &nodes = m_file.array("nodes");
    std::vector<bool> isChild(nodes.size(), false);
    for (const Json &node : nodes) {
        for (const std::size_t child : nodeList(node, "children")) {
            if (isChild[child])
                failMalformed(tr("node %1 has two parents", child));
            isChild[child] = true;
        }
    }
    const Json &scenes = m_file.array("scenes");
    if (GltfFile::find(m_file.root(), "scene")) {
        m_roots = nodeList(m_file.reference(m_file.root(), "scene", "scenes"), "nodes");
        return;
    }
    if (!scenes.empty()) {
        m_roots = nodeList(scenes[0], "nodes");
        return;
    }
    notes.push_back({ModelNote::Kind::SceneMissing, 0, {}});
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (!isChild[n])
            m_roots.push_back(n);
    }
    if (m_roots.empty() && !nodes.empty())
        failNoTree();
}

void GltfNodes::visit(const std::function<void(const Json &node, const glm::dmat4 &worldFromNode)> &visit) const
{
    struct Waiting {
        std::size_t node, depth;
        glm::dmat4 worldFromParent;
    };
    std::vector<Waiting> waiting;
    const auto add = [&waiting](const std::vector<std::size_t> &list, std::size_t depth, const glm::dmat4 &parent) {
        for (auto node = list.rbegin(); node != list.rend(); ++node)
            waiting.push_back({*node, depth, parent});
    };
    add(m_roots, 1, glm::dmat4(1.0));
    while (!waiting.empty()) {
        const Waiting next = waiting.back();
        waiting.pop_back();
        if (next.depth > kDeepestNode)
            failNoTree();
        const Json &node = m_file.array("nodes")[next.node];
        const glm::dmat4 worldFromNode = next.worldFromParent * parentFromNode(node);
        visit(node, worldFromNode);
        add(nodeList(node, "children"), next.depth + 1, worldFromNode);
    }
}

} // namespace unprojector::mesh_import::mesh_reader
