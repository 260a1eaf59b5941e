#pragma once

#include "core/mesh/import/gltf_nodes.h"
#include "core/mesh/import/gltf_values.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace unprojector::mesh::reader {

/// The skins of a glTF file, posed by the nodes of their joints.
class GltfSkins {
public:
    GltfSkins(GltfFile &file, const GltfNodes &nodes) : m_file(file), m_nodes(nodes) {}

    /// worldFromJoint * jointFromMesh for every joint of a node's skin; jointFromMesh is the
    /// inverse bind matrix. The span is valid as long as this object.
    /// Throws Damage.
    std::span<const glm::dmat4> worldFromMeshByJoint(const Json &node);

private:
    std::vector<glm::dmat4> read(const Json &skin) const;

    GltfFile &m_file;
    const GltfNodes &m_nodes;
    std::map<std::uint64_t, std::vector<glm::dmat4>> m_read; ///< by skin
};

/// The transform of a primitive's vertices: one matrix for all, or a blend of joint matrices for
/// each.
class GltfPose {
public:
    explicit GltfPose(const geometry::PreciseMatrix &worldFromMesh);
    /// A vertex becomes the sum of weight * worldFromMesh of a joint * vertex, divided by the sum
    /// of the weights. The transform of the node that holds the mesh is ignored (glTF 2.0, section
    /// 3.7.3, Skins).
    /// @param worldFromMeshByJoint  must outlive the pose
    /// @param attributes  of the primitive: JOINTS_0 and WEIGHTS_0, and those with higher numbers
    GltfPose(GltfFile &file, std::span<const glm::dmat4> worldFromMeshByJoint, const Json &attributes,
             std::size_t vertexCount);
    /// Returns whether joints move a primitive's vertices.
    static bool isSkinned(const Json &attributes);

    /// The vertex's position in world space. Throws Damage if it refers to a joint
    /// that the skin does not have.
    glm::dvec3 position(std::size_t vertex, const glm::dvec3 &inMesh) const;
    /// The normal in world space, of length 1, or zero if it has no direction.
    glm::dvec3 normal(std::size_t vertex, const glm::dvec3 &inMesh) const;
    /// Returns whether the transform reverses the winding of triangles.
    bool isMirrored() const { return m_isMirrored; }

private:
    /// The transform of normals, up to their length.
    static glm::dmat3 normalMatrix(const glm::dmat4 &worldFromMesh);
    glm::dmat4 blended(std::size_t vertex) const;

    std::span<const glm::dmat4> m_byJoint; ///< empty without a skin
    std::vector<GltfValues> m_joints, m_weights;
    geometry::PreciseMatrix m_precise{glm::dmat4(1.0)};
    glm::dmat4 m_worldFromMesh{1.0};
    glm::dmat3 m_normalMatrix{1.0};
    bool m_isIdentity = false;
    bool m_isMirrored = false;
};

} // namespace unprojector::mesh::reader
