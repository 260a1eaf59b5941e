#pragma once

#include "core/geometry/result.h"
#include "core/mesh/mesh.h"

#include <functional>
#include <memory>
#include <string>

namespace unprojector::mesh {

/// Why a model file could not be opened.
enum class ImportErrorCode {
    NotFound, ///< no such file
    IsDirectory,
    NotReadable,   ///< exists, but cannot be read
    EmptyFile,     ///< no bytes
    UnknownFormat, ///< the suffix is not one of OBJ, STL, PLY, OFF, glTF, GLB
    Malformed,     ///< detail: what the parser says, with a line number where it has one
    Unsupported,   ///< in order, but needs what is not supported; detail: what
    NoTriangles,   ///< readable, but nothing to show; detail: why, where there is more to say
    NotFinite,     ///< a vertex holds NaN or infinity; index: the vertex, counted from 0
    Cancelled,     ///< the progress callback said stop
    OutOfMemory,
};

struct ImportError {
    ImportErrorCode code;
    std::filesystem::path file;
    std::string detail; ///< UTF-8
    std::size_t index = 0;
};

/// Called from the importing thread with a share done in [0, 1], never falling; returning false cancels.
using ImportProgress = std::function<bool(double share)>;

/// Reads a model file: OBJ, STL, PLY, OFF (ASCII and binary), glTF and GLB.
///
/// Node transforms are applied, polygons are cut into triangles where they stand, missing normals made for meshes that
/// are not very large. Vertices without any faces are points. What is left out or not as in the file is in the model's
/// notes. The file's own vertex order and coordinates are kept as they are: no unit or axis conversion.
///
/// Safe to call from any thread; several imports may run at once.
/// @param progress  may be empty
/// @return its textures are still encoded
geometry::Result<std::shared_ptr<Model>, ImportError> importModel(const std::filesystem::path &file,
                                                                  const ImportProgress &progress);

} // namespace unprojector::mesh
