#pragma once

#include <filesystem>
#include <vector>

namespace unprojector::mesh_import {

/// The files beside it that a model file names, whether importModel reads them or not: libraries of materials, all pictures
/// in these, buffers. For whoever writes a file and must not destroy one of them. The model is not imported; of an OBJ, all
/// is read once.
/// @return those that are there; none where the model cannot be read. Safe to call from any thread
std::vector<std::filesystem::path> namedFiles(const std::filesystem::path &modelFile);

} // namespace unprojector::mesh_import
