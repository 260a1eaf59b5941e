#pragma once

#include "core/mesh/import/gltf_file.h"

#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh::reader {

inline constexpr const char *kMeshoptExtension = "EXT_meshopt_compression";

/// Whether the program is built with meshoptimizer.
bool hasMeshopt();

/// The bytes of a buffer view, unpacked and filtered.
/// @param packing  its EXT_meshopt_compression
/// @param bytes  those that the extension names
/// Throws Failure (Malformed) where they are damaged, or are not as the view and the extension have them.
/// @pre hasMeshopt()
std::vector<std::uint8_t> unpackedView(const Json &view, const Json &packing, std::span<const std::uint8_t> bytes);

} // namespace unprojector::mesh::reader
