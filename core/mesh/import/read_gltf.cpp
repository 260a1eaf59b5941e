#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"
#include "core/mesh/import/gltf_corners.h"
#include "core/mesh/import/gltf_draco.h"
#include "core/mesh/import/gltf_extensions.h"
#include "core/mesh/import/gltf_file.h"
#include "core/mesh/import/gltf_instances.h"
#include "core/mesh/import/gltf_materials.h"
#include "core/mesh/import/gltf_nodes.h"
#include "core/mesh/import/gltf_pose.h"
#include "core/mesh/import/gltf_values.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace unprojector::mesh::reader {
using namespace geometry;
using namespace base;

namespace {

/// The vertex limit: nodes may repeat a mesh, so a small file could ask for any amount of memory.
constexpr std::size_t kMostVertices = std::size_t{1} << 26;
/// The limit of counting, which prevents overflow.
constexpr std::size_t kMostCounted = std::size_t{1} << 62;
constexpr std::size_t kVerticesInTask = 1 << 16;

/// The vertices and elements of one material, in double until all are known.
struct Group {
    Mesh mesh;
    std::vector<glm::dvec3> positions;
    struct Part {
        std::size_t begin;  ///< in `positions`
        std::size_t number; ///< the number of its first vertex among all shown vertices
    };
    std::vector<Part> parts;

    std::vector<std::uint32_t> vertexNumbers() const
    {
        std::vector<std::uint32_t> numbers(positions.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::size_t end = i + 1 < parts.size() ? parts[i + 1].begin : numbers.size();
            for (std::size_t v = parts[i].begin; v < end; ++v)
                numbers[v] = static_cast<std::uint32_t>(parts[i].number + v - parts[i].begin);
        }
        return numbers;
    }

    /// The bounding box of the used vertices.
    Box box() const
    {
        if (mesh.indices.empty())
            return {};
        glm::dvec3 lowest = positions[mesh.indices.front()], highest = lowest;
        for (const std::uint32_t vertex : mesh.indices) {
            lowest = glm::min(lowest, positions[vertex]);
            highest = glm::max(highest, positions[vertex]);
        }
        Box box;
        box.add(lowest);
        box.add(highest);
        return box;
    }
};

class GltfReader {
public:
    explicit GltfReader(const Source &source) : m_file(source, m_model.notes), m_materials(m_file, m_model) {}

    Model read()
    {
        checkExtensions(m_file, m_model.notes);
        const GltfNodes nodes(m_file, m_model.notes);
        GltfSkins skins(m_file, nodes);
        if (m_file.array("meshes").empty())
            failEmpty();
        std::set<std::uint64_t> shown;
        nodes.visit([&](const Json &node, const PreciseMatrix &) {
            m_totalVertices = std::min(m_totalVertices + vertexCountOf(node), kMostCounted);
            if (GltfFile::find(node, "mesh"))
                shown.insert(GltfFile::number(node, "mesh", 0));
        });
        if (m_totalVertices > kMostVertices)
            failMalformed(
                tr("the nodes show %1 vertices, of which at most %2 can be read", m_totalVertices, kMostVertices));
        unpackDraco(m_file, shown);
        m_hidden = nodes.visit(
            [&](const Json &node, const PreciseMatrix &worldFromNode) { addNode(node, worldFromNode, skins); });
        m_elsewhere = nodes.meshesElsewhere();
        noteWhatIsLeftOut();
        return finished();
    }

private:
    /// The key for merging: meshes of one material and with the same attributes become one.
    struct Key {
        std::uint64_t material;
        bool hasNormals, hasColors, hasTexcoords, arePoints;
        // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a 0 in what the compiler writes
        // here
        auto operator<=>(const Key &) const = default;
    };

    /// Called with a primitive's attributes and vertex count; returns the transform of its
    /// vertices.
    using PoseOf = std::function<GltfPose(const Json &attributes, std::size_t vertexCount)>;

    const Json &primitivesOf(const Json &mesh) const
    {
        const Json *primitives = GltfFile::find(mesh, "primitives");
        if (!primitives || !primitives->is_array())
            failMalformed(tr("a mesh has no primitives"));
        return *primitives;
    }

    std::size_t vertexCountOf(const Json &node) const
    {
        if (!GltfFile::find(node, "mesh"))
            return 0;
        std::size_t count = 0;
        for (const Json &primitive : primitivesOf(m_file.reference(node, "mesh", "meshes"))) {
            const Json *attributes = GltfFile::find(primitive, "attributes");
            if (attributes && GltfFile::find(*attributes, "POSITION"))
                count += static_cast<std::size_t>(
                    GltfFile::number(m_file.reference(*attributes, "POSITION", "accessors"), "count", 0));
            if (GltfFile::find(primitive, "indices"))
                count += static_cast<std::size_t>(
                    GltfFile::number(m_file.reference(primitive, "indices", "accessors"), "count", 0) / 3);
        }
        // Instances take time even without vertices.
        const auto factor = [](std::size_t number) { return std::clamp(number, std::size_t{1}, 2 * kMostVertices); };
        return factor(count) * factor(instanceCount(m_file, node));
    }

    void addNode(const Json &node, const PreciseMatrix &worldFromNode, GltfSkins &skins)
    {
        if (!GltfFile::find(node, "mesh"))
            return;
        const Json &mesh = m_file.reference(node, "mesh", "meshes");
        const Json &weights =
            GltfFile::find(node, "weights") ? GltfFile::array(node, "weights") : GltfFile::array(mesh, "weights");
        const bool hasSkin = GltfFile::find(node, "skin");
        bool isPosed = false;
        for (const PreciseMatrix &nodeFromInstance : nodeFromInstances(m_file, node)) {
            const PoseOf poseOf = [&](const Json &attributes, std::size_t vertexCount) {
                if (!hasSkin || !GltfPose::isSkinned(attributes))
                    return GltfPose(worldFromNode * nodeFromInstance);
                isPosed = true;
                return GltfPose(m_file, skins.worldFromMeshByJoint(node), attributes, vertexCount);
            };
            for (const Json &primitive : primitivesOf(mesh))
                addPrimitive(primitive, weights, poseOf);
            if (isPosed)
                break; // a skin ignores the node's transform, so all instances coincide
        }
        m_posed += isPosed ? 1u : 0u;
        m_unusedSkins += hasSkin && !isPosed ? 1u : 0u;
    }

    /// An attribute of a primitive: as many values as it has positions.
    std::optional<GltfValues> attribute(const Json &attributes, const char *name, std::size_t vertexCount)
    {
        if (!GltfFile::find(attributes, name))
            return std::nullopt;
        GltfValues values(m_file, m_file.reference(attributes, name, "accessors"));
        if (values.count() != vertexCount)
            failMalformed(
                tr("the attribute %1 of a mesh has %2 values for %3 vertices", name, values.count(), vertexCount));
        return values;
    }

    /// Three numbers for each vertex, including the weighted morph targets.
    std::vector<glm::dvec3> vectors(const Json &primitive, const char *name, const GltfValues &values,
                                    const Json &weights)
    {
        if (values.components() != 3)
            failMalformed(tr("the attribute %1 of a mesh has not three numbers each", name));
        std::vector<glm::dvec3> list;
        fillInParallel(list, values.count(), {}, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                list[v] = values.vectorAt(v);
        });
        const Json &targets = GltfFile::array(primitive, "targets");
        for (std::size_t t = 0; t < std::min(targets.size(), weights.size()); ++t) {
            const double weight = GltfFile::real(weights[t]);
            const std::optional<GltfValues> moved =
                weight == 0.0 ? std::nullopt : attribute(targets[t], name, list.size());
            if (!moved)
                continue;
            if (moved->components() != 3)
                failMalformed(tr("the morph target %1 of a mesh has not three numbers each", name));
            for (std::size_t v = 0; v < list.size(); ++v)
                list[v] += weight * moved->vectorAt(v);
        }
        return list;
    }

    Group &groupFor(const Material &material, const Key &key)
    {
        const auto [found, isNew] = m_groupNumbers.try_emplace(key, m_groups.size());
        if (isNew) {
            Mesh mesh;
            mesh.kind = key.arePoints ? Mesh::Kind::Points : Mesh::Kind::Triangles;
            mesh.texture = key.hasTexcoords ? material.texture : -1;
            mesh.baseColor = material.baseColorOf(mesh.kind, key.hasColors);
            m_groups.push_back({std::move(mesh), {}, {}});
        }
        return m_groups[found->second];
    }

    void addPrimitive(const Json &primitive, const Json &weights, const PoseOf &poseOf)
    {
        const Json *attributes = GltfFile::find(primitive, "attributes");
        if (!attributes || !attributes->is_object())
            failMalformed(tr("a mesh primitive has no attributes"));
        const std::uint64_t mode = GltfFile::number(primitive, "mode", GltfCorners::Triangles);
        if (mode > GltfCorners::TriangleFan)
            failMalformed(tr("a mesh primitive has the mode %1, which does not exist", mode));
        if (!GltfFile::find(*attributes, "POSITION")) {
            addNote(m_model.notes, 1, marked("%1 part of a mesh has no positions and is not shown"),
                    marked("%1 parts of meshes have no positions and are not shown"));
            return;
        }
        const GltfValues positions(m_file, m_file.reference(*attributes, "POSITION", "accessors"));
        std::optional<GltfValues> indices;
        if (GltfFile::find(primitive, "indices")) {
            indices.emplace(m_file, m_file.reference(primitive, "indices", "accessors"));
            if (!indices->areIntegers() || indices->components() != 1)
                failMalformed(tr("the indices of a mesh are not integers"));
        }
        const GltfCorners corners(mode, indices ? indices->count() : positions.count());
        const bool arePoints = mode == GltfCorners::Points;
        m_leftCorners += corners.leftOver();
        if (!corners.areTriangles() && !arePoints) {
            m_lineCount += corners.otherCount();
            return;
        }
        const GltfMaterial material = m_materials.of(primitive);
        const std::optional<GltfValues> normals = attribute(*attributes, "NORMAL", positions.count());
        const std::optional<GltfValues> colors = attribute(*attributes, "COLOR_0", positions.count());
        const std::string texcoordName = "TEXCOORD_" + std::to_string(material.texcoordSet);
        const std::optional<GltfValues> texcoords =
            material.texture < 0 ? std::nullopt : attribute(*attributes, texcoordName.c_str(), positions.count());
        Group &group = groupFor(material, {GltfFile::number(primitive, "material", ~std::uint64_t{0}),
                                           normals.has_value(), colors.has_value(), texcoords.has_value(), arePoints});

        const GltfPose pose = poseOf(*attributes, positions.count());
        const std::size_t first = group.positions.size();
        addPositions(vectors(primitive, "POSITION", positions, weights), pose, group);
        if (normals)
            addNormals(vectors(primitive, "NORMAL", *normals, weights), pose, group.mesh);
        if (colors)
            addColors(*colors, group.mesh);
        if (texcoords)
            addTexcoords(*texcoords, material, group.mesh);
        const auto vertexOf = [&](std::size_t corner) {
            return indices ? static_cast<std::uint64_t>(indices->integerAt(corner, 0)) : corner;
        };
        if (arePoints) {
            for (std::size_t point = 0; point < corners.otherCount(); ++point)
                addElement({vertexOf(point)}, first, positions.count(), group.mesh);
            return;
        }
        if (indices && mode == GltfCorners::Triangles && !pose.isMirrored()
            && addTriangles(*indices, 3 * corners.triangleCount(), first, positions.count(), group.mesh))
            return;
        for (std::size_t t = 0; t < corners.triangleCount(); ++t) {
            const auto [a, b, c] = corners.ofTriangle(t);
            const std::uint64_t last = vertexOf(pose.isMirrored() ? b : c),
                                middle = vertexOf(pose.isMirrored() ? c : b);
            addElement({vertexOf(a), middle, last}, first, positions.count(), group.mesh);
        }
    }

    /// Adds all triangles of a list.
    /// @return false, and adds none, if one refers to a missing vertex
    static bool addTriangles(const GltfValues &corners, std::size_t cornerCount, std::size_t first, std::size_t count,
                             Mesh &mesh)
    {
        const std::size_t before = mesh.indices.size();
        std::atomic<bool> areWhole{true};
        fillInParallel(mesh.indices, before + cornerCount, {}, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto vertex = static_cast<std::uint64_t>(corners.integerAt(i - before, 0));
                if (vertex >= count)
                    areWhole = false;
                mesh.indices[i] = static_cast<std::uint32_t>(first + vertex);
            }
        });
        if (!areWhole)
            mesh.indices.resize(before);
        return areWhole;
    }

    /// Adds a triangle or a point, unless it refers to a missing vertex.
    void addElement(std::initializer_list<std::uint64_t> vertices, std::size_t first, std::size_t count, Mesh &mesh)
    {
        if (std::any_of(vertices.begin(), vertices.end(), [count](std::uint64_t vertex) { return vertex >= count; })) {
            ++m_brokenCount;
            return;
        }
        for (const std::uint64_t vertex : vertices)
            mesh.indices.push_back(static_cast<std::uint32_t>(first + vertex));
    }

    void addPositions(std::vector<glm::dvec3> positions, const GltfPose &pose, Group &group)
    {
        const auto report = [&](double share) {
            m_file.source().progress.report(
                (static_cast<double>(m_doneVertices) + share * static_cast<double>(positions.size()))
                / static_cast<double>(std::max<std::size_t>(m_totalVertices, 1)));
        };
        inParallelRanges(positions.size(), kVerticesInTask, report, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                positions[v] = pose.position(v, positions[v]);
                if (!isFinite(positions[v]))
                    failNotFinite(m_doneVertices + v);
            }
        });
        group.parts.push_back({group.positions.size(), m_doneVertices});
        m_doneVertices += positions.size();
        if (group.positions.empty())
            group.positions = std::move(positions);
        else
            group.positions.insert(group.positions.end(), positions.begin(), positions.end());
    }

    static void addNormals(const std::vector<glm::dvec3> &normals, const GltfPose &pose, Mesh &mesh)
    {
        const std::size_t first = mesh.normals.size();
        fillInParallel(mesh.normals, first + normals.size(), {}, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                mesh.normals[v] = glm::vec3(pose.normal(v - first, normals[v - first]));
        });
    }

    static void addColors(const GltfValues &colors, Mesh &mesh)
    {
        if (colors.components() < 3)
            failMalformed(tr("the colours of a mesh have not three or four numbers each"));
        for (std::size_t v = 0; v < colors.count(); ++v)
            mesh.colors.emplace_back(byteFromShare(colors.at(v, 0)), byteFromShare(colors.at(v, 1)),
                                     byteFromShare(colors.at(v, 2)),
                                     colors.components() > 3 ? byteFromShare(colors.at(v, 3)) : std::uint8_t{255});
    }

    static void addTexcoords(const GltfValues &texcoords, const GltfMaterial &material, Mesh &mesh)
    {
        if (texcoords.components() != 2)
            failMalformed(tr("the texture coordinates of a mesh have not two numbers each"));
        for (std::size_t v = 0; v < texcoords.count(); ++v) {
            const glm::dvec3 uv =
                material.textureFromTexcoord * glm::dvec3(texcoords.at(v, 0), texcoords.at(v, 1), 1.0);
            // glTF counts v from the top.
            mesh.texcoords.emplace_back(static_cast<float>(uv.x), static_cast<float>(1.0 - uv.y));
        }
    }

    void noteWhatIsLeftOut()
    {
        std::vector<Note> &notes = m_model.notes;
        addNote(notes, m_elsewhere, marked("%1 mesh is not in the scene that the file opens with and is not shown"),
                marked("%1 meshes are not in the scene that the file opens with and are not shown"));
        addNote(notes, m_brokenCount,
                marked("%1 face refers to vertices that the file does not have and cannot be shown"),
                marked("%1 faces refer to vertices that the file does not have and cannot be shown"));
        addNote(notes, m_leftCorners,
                marked("%1 corner at the end of a part of a mesh makes no whole triangle and is not used"),
                marked("%1 corners at the ends of parts of meshes make no whole triangles and are not used"));
        addNote(notes, m_posed, marked("%1 mesh has a skin: it is shown where the file's nodes have its joints"),
                marked("%1 meshes have skins: they are shown where the file's nodes have their joints"));
        noteParts(notes, m_unusedSkins, "skin");
        addNote(notes, m_hidden, marked("%1 mesh is hidden by the file (KHR_node_visibility) and is not shown"),
                marked("%1 meshes are hidden by the file (KHR_node_visibility) and are not shown"));
        noteParts(notes, m_file.array("animations").size(), "animation");
    }

    /// Lists the points in order, one per vertex.
    static void listPoints(Group &group)
    {
        const std::vector<std::uint32_t> vertices = std::exchange(group.mesh.indices, {});
        const auto gather = [&vertices](auto &values) {
            if (values.empty())
                return;
            std::remove_reference_t<decltype(values)> gathered;
            gathered.reserve(vertices.size());
            for (const std::uint32_t vertex : vertices)
                gathered.push_back(values[vertex]);
            values = std::move(gathered);
        };
        gather(group.positions);
        gather(group.mesh.vertexNumbers);
        gather(group.mesh.normals);
        gather(group.mesh.colors);
        gather(group.mesh.texcoords);
    }

    [[noreturn]] void failForNothing() const
    {
        if (m_brokenCount > 0)
            failUnsupported(tr("it has no vertices of the numbers that its faces refer to"));
        if (m_lineCount > 0)
            failUnsupported(tr("it holds lines only, and lines are not shown here: %1", m_lineCount));
        if (m_hidden > 0)
            failUnsupported(tr("the file hides all nodes that have meshes"));
        if (m_elsewhere == m_file.array("meshes").size())
            failUnsupported(
                tr("no mesh is in the scene that the file opens with; meshes in the file: %1", m_elsewhere));
        failEmpty();
    }

    /// Finishes the model. Points are shown if there are no triangles.
    Model finished()
    {
        const bool hasTriangles = std::any_of(m_groups.begin(), m_groups.end(), [](const Group &group) {
            return group.mesh.kind == Mesh::Kind::Triangles && !group.mesh.indices.empty();
        });
        Box all;
        std::vector<Box> boxes;
        for (Group &group : m_groups) {
            if (group.mesh.kind == Mesh::Kind::Points && hasTriangles) {
                m_lineCount += group.mesh.indices.size();
                group.mesh.indices.clear();
            }
            boxes.push_back(group.box());
            all.add(boxes.back());
        }
        noteLines(m_model.notes, m_lineCount);
        if (all.isEmpty())
            failForNothing();
        for (std::size_t i = 0; i < m_groups.size(); ++i) {
            Group &group = m_groups[i];
            if (group.mesh.indices.empty())
                continue;
            const glm::dvec3 origin = originOf(boxes[i], originFor(all));
            const bool isOnly = m_groups.size() == 1 && group.mesh.kind == Mesh::Kind::Triangles;
            if (!isOnly)
                group.mesh.vertexNumbers = group.vertexNumbers();
            if (group.mesh.kind == Mesh::Kind::Points)
                listPoints(group);
            setPositions(group.mesh, origin, group.positions);
            m_model.meshes.push_back(std::move(group.mesh));
        }
        m_model.fileVertices = m_doneVertices;
        m_model.otherFiles = m_file.bufferFiles();
        return std::move(m_model);
    }

    /// The origin of a mesh: the model's common one, unless the mesh is so far from it that it
    /// would lose digits.
    static glm::dvec3 originOf(const Box &box, const glm::dvec3 &common)
    {
        constexpr double kFar = 1024.0;
        const glm::dvec3 way = box.center() - common;
        return glm::length(way) > kFar * box.diagonal() ? originFor(box) : common;
    }

    Model m_model;
    GltfFile m_file;
    GltfMaterials m_materials;
    std::map<Key, std::size_t> m_groupNumbers;
    std::vector<Group> m_groups;
    std::size_t m_totalVertices = 0;
    std::size_t m_doneVertices = 0;
    std::size_t m_brokenCount = 0;
    std::size_t m_leftCorners = 0;
    std::size_t m_lineCount = 0; ///< including points beside triangles
    std::size_t m_posed = 0;     ///< nodes whose meshes are posed by joints
    std::size_t m_unusedSkins = 0;
    std::size_t m_elsewhere = 0; ///< meshes outside the scene
    std::size_t m_hidden = 0;    ///< nodes with meshes that the file hides
};

} // namespace

Model readGltf(const Source &source)
{
    return GltfReader(source).read();
}

} // namespace unprojector::mesh::reader
