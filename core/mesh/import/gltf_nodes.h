#pragma once

#include "core/geometry/precise_matrix.h"
#include "core/mesh/import/gltf_file.h"

#include <glm/ext/quaternion_double.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace unprojector::mesh::reader {

/// The nodes that a glTF file shows: those of the scene that it opens with, or all where it has no scene.
/// Throws Failure (Malformed) where they form no tree.
class GltfNodes {
public:
    /// @param notes  gets one where the file has no scene, or where its scene lists a node twice or beside its parent
    GltfNodes(const GltfFile &file, std::vector<ModelNote> &notes);

    /// Calls `visit` with every node and its worldFromNode, parents first, in the file's order; not with nodes that the
    /// file hides (KHR_node_visibility), nor with those below them.
    /// @return how many nodes with meshes are hidden
    std::size_t
    visit(const std::function<void(const Json &node, const geometry::PreciseMatrix &worldFromNode)> &visit) const;

    /// How many meshes no node of the scene has, shown or hidden.
    std::size_t meshesElsewhere() const;

    /// Of any node, shown or not.
    geometry::PreciseMatrix worldFromNode(std::size_t node) const;
    /// The nodes that an object's array refers to.
    std::vector<std::size_t> nodeList(const Json &object, const char *key) const;

private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    geometry::PreciseMatrix parentFromNode(std::size_t node) const;
    /// @param listed  the nodes that the scene lists; some programs list nodes below others too
    void setRoots(const std::vector<std::size_t> &listed, std::vector<ModelNote> &notes);
    /// The node above all that a node is below; kNone where there is a circle instead.
    std::size_t topOf(std::size_t node) const;

    const GltfFile &m_file;
    std::vector<std::size_t> m_roots;
    std::vector<std::size_t> m_parents; ///< kNone where there is none
};

/// What places a node or an instance.
struct Placement {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};

    /// But for the few digits that some programs write.
    bool isRotationUnit() const;
    /// The glTF key of the first part that is not neutral; null where the placement is the identity.
    const char *firstThatMoves() const;
    /// translation * rotation * scale, of the rotation made a unit.
    geometry::PreciseMatrix matrix() const;
};

/// The last row of a matrix that is not affine, as text; empty where it is 0 0 0 1, but for rounding.
std::string wrongLastRow(const glm::dmat4 &matrix);
/// A matrix with 0 0 0 1 as its last row.
glm::dmat4 withLastRow(glm::dmat4 matrix);

} // namespace unprojector::mesh::reader
