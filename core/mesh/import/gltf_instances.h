#pragma once

#include "core/geometry/precise_matrix.h"
#include "core/mesh/import/gltf_file.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <vector>

namespace unprojector::mesh::reader {

/// How often a node shows its mesh: as often as EXT_mesh_gpu_instancing says, or once.
/// Throws Failure (Malformed), as the next one does.
std::size_t instanceCount(const GltfFile &file, const Json &node);

/// nodeFromInstance of each: the extension's translation * rotation * scale. One identity without it.
std::vector<geometry::PreciseMatrix> nodeFromInstances(GltfFile &file, const Json &node);

} // namespace unprojector::mesh::reader
