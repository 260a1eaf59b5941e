#include "core/cli/commands/import_error_text.h"

#include "core/files/path_text.h"
#include "core/text/translation.h"

namespace unprojector::cli {
using namespace files;
using text::tr;

std::string importErrorText(const ImportError &error)
{
    std::string file = utf8FromPath(error.file);
    switch (error.code) {
    case ImportErrorCode::NotFound: return tr("%1: there is no such file", file);
    case ImportErrorCode::IsDirectory: return tr("%1: is a folder; give a model file in it", file);
    case ImportErrorCode::NotReadable:
        return tr(error.detail.empty() ? "%1: cannot be read" : "%1: cannot be read (%2)", file, error.detail);
    case ImportErrorCode::EmptyFile: return tr("%1: is empty", file);
    case ImportErrorCode::UnknownFormat:
        return tr(error.detail.empty()
                      ? "%1: is no model that can be read here; give OBJ, STL, PLY, OFF, glTF or GLB"
                      : "%1: is no model that can be read here; give OBJ, STL, PLY, OFF, glTF or GLB; %2",
                  file, error.detail);
    case ImportErrorCode::Malformed: return tr("%1: is damaged: %2", file, error.detail);
    case ImportErrorCode::Unsupported: return tr("%1: cannot be shown: %2", file, error.detail);
    case ImportErrorCode::NoTriangles:
        return tr(error.detail.empty() ? "%1: holds neither triangles nor points" : "%1: cannot be shown: %2", file,
                  error.detail);
    case ImportErrorCode::NotFinite:
        return tr(error.detail.empty() ? "%1: vertex %2 is NaN, infinite, or beyond 3.4e38"
                                       : "%1: vertex %2 is NaN, infinite, or beyond 3.4e38: %3",
                  file, error.index, error.detail);
    case ImportErrorCode::Cancelled: return tr("%1: reading was stopped", file);
    case ImportErrorCode::OutOfMemory: return tr("%1: is too large for the memory of this computer", file);
    }
    return file;
}

} // namespace unprojector::cli
