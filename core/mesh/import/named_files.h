#pragma once

#include <filesystem>
#include <vector>

namespace unprojector::mesh {

/// The existing files that a model file names, whether importModel reads them or not: material
/// libraries, the images that these name, buffers. Writers call it so that they never overwrite
/// one. Scans the model file once without importing it.
/// @return empty if the model cannot be read. Safe to call from any thread
std::vector<std::filesystem::path> namedFiles(const std::filesystem::path &modelFile);

} // namespace unprojector::mesh
