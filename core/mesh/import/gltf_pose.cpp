#include "core/mesh/import/gltf_pose.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace unprojector::mesh::reader {
using namespace geometry;
using base::tr;

namespace {

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

} // namespace

std::span<const glm::dmat4> GltfSkins::worldFromMeshByJoint(const Json &node)
{
    const Json &skin = m_file.reference(node, "skin", "skins");
    const auto [known, isNew] = m_read.try_emplace(GltfFile::number(node, "skin", 0));
    if (isNew)
        known->second = read(skin);
    return known->second;
}

std::vector<glm::dmat4> GltfSkins::read(const Json &skin) const
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

GltfPose::GltfPose(const PreciseMatrix &worldFromMesh)
    : m_precise(worldFromMesh), m_worldFromMesh(worldFromMesh.rounded()), m_normalMatrix(normalMatrix(m_worldFromMesh)),
      m_isIdentity(m_worldFromMesh == glm::dmat4(1.0)),
      m_isMirrored(glm::determinant(glm::dmat3(m_worldFromMesh)) < 0.0)
{
}

GltfPose::GltfPose(GltfFile &file, std::span<const glm::dmat4> worldFromMeshByJoint, const Json &attributes,
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
            failMalformed(tr("a mesh has %1 without %2", hasJoints ? joints : weights, hasJoints ? weights : joints));
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

bool GltfPose::isSkinned(const Json &attributes)
{
    return GltfFile::find(attributes, "JOINTS_0") || GltfFile::find(attributes, "WEIGHTS_0");
}

glm::dvec3 GltfPose::position(std::size_t vertex, const glm::dvec3 &inMesh) const
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

glm::dmat4 GltfPose::blended(std::size_t vertex) const
{
    const auto jointOf = [&](std::size_t set, std::size_t k) -> const glm::dmat4 & {
        const auto joint = static_cast<std::uint64_t>(m_joints[set].integerAt(vertex, k));
        if (joint >= m_byJoint.size())
            failMalformed(tr("vertex %1 of a mesh names joint %2, its skin has %3", vertex, joint, m_byJoint.size()));
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
                                 base::shortestText(weight)));
            sum += weight * jointOf(set, k);
            total += weight;
        }
    }
    // A vertex that no joint holds follows the first joint that it names, as in other programs.
    return total > 0.0 ? sum / total : jointOf(0, 0);
}

glm::dvec3 GltfPose::normal(std::size_t vertex, const glm::dvec3 &inMesh) const
{
    const glm::dvec3 turned = (m_byJoint.empty() ? m_normalMatrix : normalMatrix(blended(vertex))) * inMesh;
    const double length = glm::length(turned);
    return length > 0.0 ? turned / length : glm::dvec3(0.0);
}

glm::dmat3 GltfPose::normalMatrix(const glm::dmat4 &worldFromMesh)
{
    const glm::dmat3 linear(worldFromMesh);
    // The cofactor matrix: inverse transpose times determinant. It stays finite for a flat scale.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    return glm::determinant(linear) < 0.0 ? -cofactors : cofactors;
}

} // namespace unprojector::mesh::reader
