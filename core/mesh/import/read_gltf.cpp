#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"
#include "core/mesh/import/gltf_corners.h"
#include "core/mesh/import/gltf_draco.h"
#include "core/mesh/import/gltf_extensions.h"
#include "core/mesh/import/gltf_file.h"
#include "core/mesh/import/gltf_materials.h"
#include "core/mesh/import/gltf_nodes.h"
#include "core/mesh/import/gltf_values.h"
#include "core/mesh/import/mesh_normals.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
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
#include <span>
#include <string>
#include <string_view>
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

constexpr const char *kInstanceAttributes[] = {"TRANSLATION", "ROTATION", "SCALE"};

/// The extension's attributes, or null if the node has none that transform an instance.
const Json *instanceAttributes(const Json &node)
{
    const Json *instancing = extensionOf(node, "EXT_mesh_gpu_instancing");
    const Json *attributes = instancing ? GltfFile::find(*instancing, "attributes") : nullptr;
    for (const char *name : kInstanceAttributes) {
        if (attributes && GltfFile::find(*attributes, name))
            return attributes;
    }
    return nullptr;
}

std::optional<GltfValues> instanceValues(GltfFile &file, const Json &attributes, const char *name,
                                         std::size_t components, std::size_t count)
{
    if (!GltfFile::find(attributes, name))
        return std::nullopt;
    GltfValues list(file, file.reference(attributes, name, "accessors"));
    if (list.components() != components || list.count() != count)
        failMalformed(tr("the attribute %1 of instances does not have %2 numbers for each of %3 instances", name,
                         components, count));
    return list;
}

/// The number of times that a node shows its mesh: by EXT_mesh_gpu_instancing, else one.
std::size_t instanceCount(const GltfFile &file, const Json &node)
{
    const Json *attributes = instanceAttributes(node);
    for (const char *name : kInstanceAttributes) {
        if (attributes && GltfFile::find(*attributes, name))
            return static_cast<std::size_t>(
                GltfFile::number(file.reference(*attributes, name, "accessors"), "count", 0));
    }
    return 1;
}

/// nodeFromInstance of each instance: the extension's translation * rotation * scale. One identity
/// without the extension.
std::vector<PreciseMatrix> nodeFromInstances(GltfFile &file, const Json &node)
{
    const Json *attributes = instanceAttributes(node);
    if (!attributes)
        return {PreciseMatrix(glm::dmat4(1.0))};
    const std::size_t count = instanceCount(file, node);
    const auto translations = instanceValues(file, *attributes, "TRANSLATION", 3, count);
    const auto rotations = instanceValues(file, *attributes, "ROTATION", 4, count);
    const auto scales = instanceValues(file, *attributes, "SCALE", 3, count);
    std::vector<PreciseMatrix> instances;
    instances.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        Placement placement;
        if (translations)
            placement.translation = translations->vectorAt(i);
        if (rotations)
            placement.rotation =
                glm::dquat(rotations->at(i, 3), rotations->at(i, 0), rotations->at(i, 1), rotations->at(i, 2));
        if (scales)
            placement.scale = scales->vectorAt(i);
        if (!placement.isRotationUnit())
            failMalformed(tr("the rotation of instance %1 has the length %2; it must be 1", i,
                             shortestText(glm::length(placement.rotation))));
        instances.push_back(placement.matrix());
    }
    return instances;
}

constexpr std::size_t kJointsInSet = 4;

std::string numbered(const char *name, std::size_t number)
{
    return name + std::to_string(number);
}

GltfValues fourEach(GltfFile &file, const Json &attributes, const std::string &name, std::size_t vertexCount)
{
    GltfValues values(file, file.reference(attributes, name.c_str(), "accessors"));
    if (values.count() != vertexCount)
        failMalformed(
            tr("the attribute %1 of a mesh has %2 values for %3 vertices", name, values.count(), vertexCount));
    if (values.components() != kJointsInSet)
        failMalformed(tr("the attribute %1 of a mesh has not four numbers each", name));
    return values;
}

/// The skins of a glTF file, posed by the nodes of their joints.
class GltfSkins {
public:
    GltfSkins(GltfFile &file, const GltfNodes &nodes) : m_file(file), m_nodes(nodes) {}

    /// worldFromJoint * jointFromMesh for every joint of a node's skin; jointFromMesh is the
    /// inverse bind matrix. The span is valid as long as this object.
    /// Throws Damage.
    std::span<const glm::dmat4> worldFromMeshByJoint(const Json &node)
    {
        const Json &skin = m_file.reference(node, "skin", "skins");
        const auto [known, isNew] = m_read.try_emplace(GltfFile::number(node, "skin", 0));
        if (isNew)
            known->second = read(skin);
        return known->second;
    }

private:
    std::vector<glm::dmat4> read(const Json &skin) const
    {
        const std::vector<std::size_t> joints = m_nodes.nodeList(skin, "joints");
        if (joints.empty())
            failMalformed(tr("a skin has no joints"));
        std::vector<PreciseMatrix> worldFromJoint;
        std::vector<glm::dmat4> worldFromMesh;
        for (const std::size_t joint : joints) {
            worldFromJoint.push_back(m_nodes.worldFromNode(joint));
            worldFromMesh.push_back(worldFromJoint.back().rounded());
        }
        if (!GltfFile::find(skin, "inverseBindMatrices"))
            return worldFromMesh;
        const GltfValues inverse(m_file, m_file.reference(skin, "inverseBindMatrices", "accessors"));
        if (inverse.components() != 16 || inverse.count() < joints.size())
            failMalformed(tr("a skin of %1 joints has %2 inverse bind matrices", joints.size(), inverse.count()));
        for (std::size_t joint = 0; joint < joints.size(); ++joint) {
            glm::dmat4 jointFromMesh(1.0);
            for (int i = 0; i < 16; ++i)
                jointFromMesh[i / 4][i % 4] = inverse.at(joint, static_cast<std::size_t>(i));
            const std::string lastRow = wrongLastRow(jointFromMesh);
            if (!lastRow.empty())
                failMalformed(
                    tr("the inverse bind matrix %1 of a skin has the last row %2; it must be 0 0 0 1", joint, lastRow));
            worldFromMesh[joint] = (worldFromJoint[joint] * PreciseMatrix(withLastRow(jointFromMesh))).rounded();
        }
        return worldFromMesh;
    }

    GltfFile &m_file;
    const GltfNodes &m_nodes;
    std::map<std::uint64_t, std::vector<glm::dmat4>> m_read; ///< by skin
};

/// The transform of a primitive's vertices: one matrix for all, or a blend of joint matrices for
/// each.
class GltfPose {
public:
    explicit GltfPose(const PreciseMatrix &worldFromMesh)
        : m_precise(worldFromMesh), m_worldFromMesh(worldFromMesh.rounded()),
          m_normalMatrix(normalMatrix(m_worldFromMesh)), m_isIdentity(m_worldFromMesh == glm::dmat4(1.0)),
          m_isMirrored(glm::determinant(glm::dmat3(m_worldFromMesh)) < 0.0)
    {
    }
    /// A vertex becomes the sum of weight * worldFromMesh of a joint * vertex, divided by the sum
    /// of the weights. The transform of the node that holds the mesh is ignored (glTF 2.0, section
    /// 3.7.3, Skins).
    /// @param worldFromMeshByJoint  must outlive the pose
    /// @param attributes  of the primitive: JOINTS_0 and WEIGHTS_0, and those with higher numbers
    GltfPose(GltfFile &file, std::span<const glm::dmat4> worldFromMeshByJoint, const Json &attributes,
             std::size_t vertexCount)
        : m_byJoint(worldFromMeshByJoint)
    {
        for (std::size_t set = 0;; ++set) {
            const std::string joints = numbered("JOINTS_", set), weights = numbered("WEIGHTS_", set);
            const bool hasJoints = GltfFile::find(attributes, joints.c_str());
            const bool hasWeights = GltfFile::find(attributes, weights.c_str());
            if (!hasJoints && !hasWeights)
                break;
            if (!hasJoints || !hasWeights)
                failMalformed(
                    tr("a mesh has %1 without %2", hasJoints ? joints : weights, hasJoints ? weights : joints));
            m_joints.push_back(fourEach(file, attributes, joints, vertexCount));
            m_weights.push_back(fourEach(file, attributes, weights, vertexCount));
            if (!m_joints.back().areIntegers())
                failMalformed(tr("the joints of a mesh are not integers"));
        }
        // All joints of a valid skin agree.
        const auto mirrored = std::count_if(m_byJoint.begin(), m_byJoint.end(), [](const glm::dmat4 &worldFromMesh) {
            return glm::determinant(glm::dmat3(worldFromMesh)) < 0.0;
        });
        m_isMirrored = 2 * static_cast<std::size_t>(mirrored) > m_byJoint.size();
    }
    /// Returns whether joints move a primitive's vertices.
    static bool isSkinned(const Json &attributes)
    {
        return GltfFile::find(attributes, "JOINTS_0") || GltfFile::find(attributes, "WEIGHTS_0");
    }

    /// The vertex's position in world space. Throws Damage if it refers to a joint
    /// that the skin does not have.
    glm::dvec3 position(std::size_t vertex, const glm::dvec3 &inMesh) const
    {
        if (m_isIdentity)
            return inMesh;
        const glm::dmat4 blend = m_byJoint.empty() ? glm::dmat4() : blended(vertex);
        const glm::dmat4 &m = m_byJoint.empty() ? m_worldFromMesh : blend;
        const glm::dvec3 world(m * glm::dvec4(inMesh, 1.0));
        constexpr double kCancelled = 0x1p-4; // more cancellation than this is worth the time
        const auto isCancelled = [&](int axis) {
            const double terms = std::abs(m[0][axis] * inMesh.x) + std::abs(m[1][axis] * inMesh.y)
                                 + std::abs(m[2][axis] * inMesh.z) + std::abs(m[3][axis]);
            return std::abs(world[axis]) < kCancelled * terms;
        };
        if (!m_byJoint.empty() || !(isCancelled(0) || isCancelled(1) || isCancelled(2)))
            return world;
        const DoubleDouble3 precise = m_precise.at(inMesh);
        return {precise[0].value, precise[1].value, precise[2].value};
    }
    /// The normal in world space, of length 1, or zero if it has no direction.
    glm::dvec3 normal(std::size_t vertex, const glm::dvec3 &inMesh) const
    {
        const glm::dvec3 turned = (m_byJoint.empty() ? m_normalMatrix : normalMatrix(blended(vertex))) * inMesh;
        const double length = glm::length(turned);
        return length > 0.0 ? turned / length : glm::dvec3(0.0);
    }
    /// Returns whether the transform reverses the winding of triangles.
    bool isMirrored() const { return m_isMirrored; }

private:
    /// The transform of normals, up to their length.
    static glm::dmat3 normalMatrix(const glm::dmat4 &worldFromMesh)
    {
        const glm::dmat3 linear(worldFromMesh);
        // The cofactor matrix: inverse transpose times determinant. It stays finite for a flat scale.
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        return glm::determinant(linear) < 0.0 ? -cofactors : cofactors;
    }
    glm::dmat4 blended(std::size_t vertex) const
    {
        const auto jointOf = [&](std::size_t set, std::size_t k) -> const glm::dmat4 & {
            const auto joint = static_cast<std::uint64_t>(m_joints[set].integerAt(vertex, k));
            if (joint >= m_byJoint.size())
                failMalformed(
                    tr("vertex %1 of a mesh names joint %2, its skin has %3", vertex, joint, m_byJoint.size()));
            return m_byJoint[static_cast<std::size_t>(joint)];
        };
        glm::dmat4 sum(0.0);
        double total = 0.0;
        for (std::size_t set = 0; set < m_weights.size(); ++set) {
            for (std::size_t k = 0; k < kJointsInSet; ++k) {
                const double weight = m_weights[set].at(vertex, k);
                if (weight == 0.0)
                    continue;
                if (!(weight > 0.0) || std::isinf(weight))
                    failMalformed(tr("vertex %1 of a mesh has the joint weight %2; it must be 0 or greater", vertex,
                                     shortestText(weight)));
                sum += weight * jointOf(set, k);
                total += weight;
            }
        }
        // A vertex that no joint holds follows the first joint that it names, as in other programs.
        return total > 0.0 ? sum / total : jointOf(0, 0);
    }

    std::span<const glm::dmat4> m_byJoint; ///< empty without a skin
    std::vector<GltfValues> m_joints, m_weights;
    PreciseMatrix m_precise{glm::dmat4(1.0)};
    glm::dmat4 m_worldFromMesh{1.0};
    glm::dmat3 m_normalMatrix{1.0};
    bool m_isIdentity = false;
    bool m_isMirrored = false;
};

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
        const GltfShown shown = nodes.shown();
        std::set<std::uint64_t> meshes;
        for (const GltfShown::Node &each : shown.nodes) {
            const Json &node = m_file.array("nodes")[each.number];
            m_totalVertices = std::min(m_totalVertices + vertexCountOf(node), kMostCounted);
            meshes.insert(GltfFile::number(node, "mesh", 0));
        }
        if (m_totalVertices > kMostVertices)
            failMalformed(
                tr("the nodes show %1 vertices, of which at most %2 can be read", m_totalVertices, kMostVertices));
        for (const std::uint64_t number : meshes) {
            for (Json &primitive : m_file.root()["meshes"][static_cast<std::size_t>(number)]["primitives"]) {
                if (extensionOf(primitive, kDracoExtension))
                    unpackDraco(m_file, primitive);
            }
        }
        for (const GltfShown::Node &node : shown.nodes)
            addNode(m_file.array("nodes")[node.number], node.worldFromNode, skins);
        m_hidden = shown.hidden;
        m_elsewhere = shown.meshesElsewhere;
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
        group.positions = gathered(group.positions, vertices);
        gatherVertices(group.mesh, vertices);
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
