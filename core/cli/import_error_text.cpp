#include "core/cli/import_error_text.h"

#include "core/files/path_text.h"

namespace unprojector::cli {
using namespace files;

std::string importErrorText(const ImportError &error)
{
    std::string file = utf8FromPath(error.file);
    switch (error.code) {
    case ImportErrorCode::NotFound: return file + ": there is no such file";
    case ImportErrorCode::IsDirectory: return file + ": is a folder; give a model file in it";
    case ImportErrorCode::NotReadable:
        return file + ": cannot be read" + (error.detail.empty() ? std::string() : " (" + error.detail + ')');
    case ImportErrorCode::EmptyFile: return file + ": is empty";
    case ImportErrorCode::UnknownFormat:
        return file + ": is no model that can be read here; give OBJ, STL, PLY, OFF, glTF or GLB"
               + (error.detail.empty() ? std::string() : "; " + error.detail);
    case ImportErrorCode::Malformed: return file + ": is damaged: " + error.detail;
    case ImportErrorCode::Unsupported: return file + ": cannot be shown: " + error.detail;
    case ImportErrorCode::NoTriangles: return file + ": holds neither triangles nor points";
    case ImportErrorCode::NotFinite:
        return file + ": vertex " + std::to_string(error.index) + " is NaN, infinite, or beyond 3.4e38"
               + (error.detail.empty() ? std::string() : ": " + error.detail);
    case ImportErrorCode::Cancelled: return file + ": reading was stopped";
    case ImportErrorCode::OutOfMemory: return file + ": is too large for the memory of this computer";
    }
    return file;
}

} // namespace unprojector::cli
