#pragma once

#include "core/geometry/precise_matrix.h"
#include "core/mesh/import/gltf_file.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <vector>

namespace unprojector::mesh::reader {

/// The number of times that a node shows its mesh: by EXT_mesh_gpu_instancing, else one.
/// Throws Damage; so does nodeFromInstances.
std::size_t instanceCount(const GltfFile &file, const Json &node);

/// nodeFromInstance of each instance: the extension's translation * rotation * scale. One identity
/// without the extension.
std::vector<geometry::PreciseMatrix> nodeFromInstances(GltfFile &file, const Json &node);

} // namespace unprojector::mesh::reader
