#pragma once

#include "core/mesh/import/gltf_file.h"

#include <cstdint>
#include <set>

namespace unprojector::mesh::reader {

/// Unpacks the primitives packed by KHR_draco_mesh_compression, and gives them accessors as if the
/// file had the data unpacked.
/// @param meshes  the numbers of the shown meshes
/// Throws Damage if the data are damaged or contradict the file; base::Error if the
/// program is built without Draco and the file has no fallback.
void unpackDraco(GltfFile &file, const std::set<std::uint64_t> &meshes);

} // namespace unprojector::mesh::reader
