#include "core/mesh/import/import_error_text.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"

namespace unprojector::mesh {
using base::tr;

std::string importErrorText(const ImportError &error)
{
    return base::utf8FromPath(error.file) + ": " + reasonText(error);
}

std::string reasonText(const ImportError &error)
{
    const bool isPlain = error.detail.empty();
    switch (error.code) {
    case ImportErrorCode::NotFound: return tr("there is no such file; check the name and the folder");
    case ImportErrorCode::IsDirectory: return tr("this is a folder; give a model file in it");
    case ImportErrorCode::NotReadable:
        return tr(isPlain ? "the file cannot be read; check its permissions"
                          : "the file cannot be read; check its permissions (%1)",
                  error.detail);
    case ImportErrorCode::EmptyFile: return tr("the file is empty");
    case ImportErrorCode::UnknownFormat:
        return tr(
            isPlain ? "this is not a model that can be read here; give OBJ, STL, PLY, OFF, glTF or GLB. For a camera, "
                      "use 'unproject scene' or Paste Camera"
                    : "this is not a model that can be read here; give OBJ, STL, PLY, OFF, glTF or GLB; %1",
            error.detail);
    case ImportErrorCode::Malformed: return tr("the file is damaged: %1", error.detail);
    case ImportErrorCode::Unsupported: return tr("the file cannot be shown: %1", error.detail);
    case ImportErrorCode::NoTriangles:
        return tr(isPlain ? "the file holds neither triangles nor points" : "the file cannot be shown: %1",
                  error.detail);
    case ImportErrorCode::NotFinite:
        return tr(isPlain ? "vertex %1 is NaN, infinite, or beyond 3.4e38"
                          : "vertex %1 is NaN, infinite, or beyond 3.4e38: %2",
                  error.index, error.detail);
    case ImportErrorCode::Cancelled: return tr("reading was stopped");
    case ImportErrorCode::OutOfMemory: return tr("the file is too large for the memory of this computer");
    }
    return {};
}

} // namespace unprojector::mesh
