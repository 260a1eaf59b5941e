#pragma once

#include "core/mesh_import/gltf_file.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace unprojector::mesh_import::mesh_reader {

/// The nodes that a glTF file shows: those of the scene that it opens with, or all where it has no scene.
/// Throws Failure (Malformed) where they form no tree.
class GltfNodes {
public:
    /// @param notes  gets one where the file has no scene
    GltfNodes(const GltfFile &file, std::vector<ModelNote> &notes);

    /// Calls `visit` with every node and its worldFromNode, parents first, in the file's order.
    void visit(const std::function<void(const Json &node, const glm::dmat4 &worldFromNode)> &visit) const;

private:
    std::vector<std::size_t> nodeList(const Json &object, const char *key) const;

    const GltfFile &m_file;
    std::vector<std::size_t> m_roots;
};

} // namespace unprojector::mesh_import::mesh_reader
