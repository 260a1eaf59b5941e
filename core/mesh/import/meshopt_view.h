#pragma once

#include "core/mesh/import/gltf_file.h"

#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh::reader {

inline constexpr const char *kMeshoptExtension = "EXT_meshopt_compression";

/// Returns whether the program is built with meshoptimizer.
bool hasMeshopt();

/// Unpacks and filters the bytes of a buffer view.
/// @param packing  its EXT_meshopt_compression
/// @param bytes  the packed bytes
/// Throws Damage if the bytes are damaged, or contradict the view or the extension.
/// @pre hasMeshopt()
std::vector<std::uint8_t> unpackedView(const Json &view, const Json &packing, std::span<const std::uint8_t> bytes);

} // namespace unprojector::mesh::reader
