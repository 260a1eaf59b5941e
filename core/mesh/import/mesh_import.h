#pragma once

#include "core/geometry/result.h"
#include "core/mesh/mesh.h"

#include <functional>
#include <memory>
#include <string>

namespace unprojector::mesh {

/// The reason why a model file could not be imported.
enum class ImportErrorCode {
    NotFound, ///< no such file
    IsDirectory,
    NotReadable,   ///< exists, but cannot be read
    EmptyFile,     ///< no bytes
    UnknownFormat, ///< the suffix is not one of OBJ, STL, PLY, OFF, glTF, GLB
    Malformed,     ///< detail: the parser's message, with a line number if it has one
    Unsupported,   ///< valid, but needs an unsupported feature; detail: which
    NoTriangles,   ///< readable, but nothing to show; detail: the reason, if known
    NotFinite,     ///< a vertex holds NaN or infinity; index: the vertex, counted from 0
    Cancelled,     ///< the progress callback cancelled
    OutOfMemory,
};

struct ImportError {
    ImportErrorCode code;
    std::filesystem::path file;
    std::string detail; ///< UTF-8
    std::size_t index = 0;
};

/// Called from the importing thread with the share done in [0, 1], which never decreases; returning
/// false cancels.
using ImportProgress = std::function<bool(double share)>;

/// Imports a model file: OBJ, STL, PLY, OFF (ASCII and binary), glTF and GLB.
///
/// Applies node transforms, triangulates polygons, and computes missing normals for meshes that are
/// not very large. Vertices without faces become points. The model's notes list everything dropped
/// or changed. The file's vertex order and coordinates are kept: no unit or axis conversion.
///
/// Safe to call from any thread; several imports may run at once.
/// @param progress  may be empty
/// @return a model with textures still encoded
geometry::Result<std::shared_ptr<Model>, ImportError> importModel(const std::filesystem::path &file,
                                                                  const ImportProgress &progress);

} // namespace unprojector::mesh
