#pragma once

#include "core/base/error.h"
#include "core/base/expected.h"
#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <filesystem>
#include <memory>

namespace unprojector::mesh {

/// Why a model was not read to the end.
base::Error stoppedReading(const std::filesystem::path &file);
base::Error tooLargeForMemory(const std::filesystem::path &file);

/// Imports a model file: OBJ, STL, PLY, OFF (ASCII and binary), glTF and GLB.
///
/// Applies node transforms, triangulates polygons, and computes missing normals for meshes that are
/// not very large. Vertices without faces become points. The model's notes list everything dropped
/// or changed. The file's vertex order and coordinates are kept: no unit or axis conversion.
///
/// Safe to call from any thread; several imports may run at once.
/// @param progress  may be empty
/// @return a model with textures still encoded
base::Expected<std::shared_ptr<Model>, base::Error> importModel(const std::filesystem::path &file,
                                                                const base::Progress &progress);

} // namespace unprojector::mesh
