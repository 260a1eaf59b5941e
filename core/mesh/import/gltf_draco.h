#pragma once

#include "core/mesh/import/gltf_file.h"

#include <cstdint>
#include <set>

namespace unprojector::mesh::reader {

/// Gives the primitives that KHR_draco_mesh_compression packs accessors of the unpacked data, as if the file had them.
/// @param meshes  numbers of those that are shown
/// Throws Failure: Malformed where the data are damaged or are not as the file has them; Unsupported where the program is
/// built without Draco and nothing stands in for them.
void unpackDraco(GltfFile &file, const std::set<std::uint64_t> &meshes);

} // namespace unprojector::mesh::reader
