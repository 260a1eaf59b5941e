#pragma once

#include "core/mesh/import/gltf_file.h"

namespace unprojector::mesh::reader {

inline constexpr const char *kDracoExtension = "KHR_draco_mesh_compression";

/// Returns whether the program is built with Draco.
bool hasDraco();

/// Unpacks a primitive packed by KHR_draco_mesh_compression, and gives it accessors as if the file
/// had the data unpacked.
/// Throws Damage if the data are damaged or contradict the file; base::Error if the
/// program is built without Draco and the file has no fallback.
void unpackDraco(GltfFile &file, Json &primitive);

} // namespace unprojector::mesh::reader
