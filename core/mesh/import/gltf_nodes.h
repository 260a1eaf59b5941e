#pragma once

#include "core/geometry/precise_matrix.h"
#include "core/mesh/import/gltf_file.h"

#include <glm/ext/quaternion_double.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace unprojector::mesh::reader {

/// The nodes with meshes of a scene: parents first, in the file's order.
struct GltfShown {
    struct Node {
        std::size_t number;
        geometry::PreciseMatrix worldFromNode;
    };
    std::vector<Node> nodes;
    std::size_t hidden = 0;          ///< nodes with meshes that are hidden, or below a hidden one (KHR_node_visibility)
    std::size_t meshesElsewhere = 0; ///< meshes that no node of the scene uses, shown or hidden
};

/// The nodes that a glTF file shows: the nodes of its default scene, or all if it has no scene.
/// Throws Damage if they form no tree.
class GltfNodes {
public:
    /// @param notes  gets one if the file has no scene, or if its scene lists a node twice or
    ///         beside its ancestor
    GltfNodes(const GltfFile &file, std::vector<base::Note> &notes);

    GltfShown shown() const;

    /// The transform of any node, shown or not.
    geometry::PreciseMatrix worldFromNode(std::size_t node) const;
    /// The nodes that an object's array refers to.
    std::vector<std::size_t> nodeList(const Json &object, const char *key) const;

private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    geometry::PreciseMatrix parentFromNode(std::size_t node) const;
    /// @param listed  the nodes that the scene lists; some programs also list descendants of others,
    ///         or children of a node without a transform, which they leave out
    void setRoots(const std::vector<std::size_t> &listed, std::vector<base::Note> &notes);
    /// Returns whether a node moves or hides its children.
    bool changesChildren(std::size_t node) const;

    const GltfFile &m_file;
    std::vector<std::size_t> m_roots;
    std::vector<std::size_t> m_parents; ///< kNone for roots
};

/// The translation, rotation and scale of a node or an instance.
struct Placement {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};

    /// Returns whether the rotation has length 1, within the few digits that some programs write.
    bool isRotationUnit() const;
    /// The glTF key of the first part that is not neutral; null if the placement is the identity.
    const char *firstThatMoves() const;
    /// translation * rotation * scale, with the rotation normalized.
    geometry::PreciseMatrix matrix() const;
};

/// The last row of a matrix that is not affine, as text; empty if it is 0 0 0 1 within rounding.
std::string wrongLastRow(const glm::dmat4 &matrix);
/// The matrix with 0 0 0 1 as its last row.
glm::dmat4 withLastRow(glm::dmat4 matrix);

} // namespace unprojector::mesh::reader
