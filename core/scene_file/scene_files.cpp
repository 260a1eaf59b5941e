#include "core/files/path_text.h"
#include "core/scene_file/scene_file.h"

#include <array>
#include <fstream>
#include <system_error>

namespace unprojector::scene_file {
using namespace files;

Result<SceneFile, SceneFileError> readSceneFile(const std::filesystem::path &file)
{
    const auto failed = [&file](SceneFileErrorCode code, std::string detail = {}) {
        SceneFileError error;
        error.code = code;
        error.file = utf8FromPath(file);
        error.detail = std::move(detail);
        return error;
    };
    std::error_code system;
    const std::filesystem::file_status status = std::filesystem::status(file, system);
    if (status.type() == std::filesystem::file_type::not_found)
        return failed(SceneFileErrorCode::NotFound);
    if (std::filesystem::is_directory(status))
        return failed(SceneFileErrorCode::IsDirectory);
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return failed(SceneFileErrorCode::NotReadable, system ? system.message() : std::string());

    std::string text;
    std::array<char, 65536> block;
    do { // A block more than there may be is enough to know that the file is too large, whatever it is.
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    } while (stream && text.size() <= kMostSceneBytes);
    if (stream.bad())
        return failed(SceneFileErrorCode::NotReadable);
    return parseScene(text, utf8FromPath(file));
}

Result<std::monostate, SceneFileError> writeSceneFile(const std::filesystem::path &file, const SceneFile &scene)
{
    const auto failed = [&file](SceneFileError error) {
        error.file = utf8FromPath(file);
        return error;
    };
    const Result<std::string, SceneFileError> text = sceneText(scene);
    if (!text)
        return failed(text.error());

    SceneFileError error;
    error.code = SceneFileErrorCode::NotWritable;
    std::error_code system;
    // Of a link it is the file it points to that is replaced.
    std::filesystem::path target = std::filesystem::weakly_canonical(file, system);
    if (system)
        target = file;
    if (std::filesystem::is_directory(target, system)) {
        error.code = SceneFileErrorCode::IsDirectory;
        return failed(error);
    }
    std::filesystem::path fresh = target;
    fresh += ".new";
    {
        std::ofstream stream(fresh, std::ios::binary | std::ios::trunc);
        stream.write(text->data(), static_cast<std::streamsize>(text->size()));
        stream.close();
        if (!stream) {
            std::filesystem::remove(fresh, system);
            return failed(error);
        }
    }
    if (const auto status = std::filesystem::status(target, system); std::filesystem::exists(status))
        std::filesystem::permissions(fresh, status.permissions(), system);
    std::filesystem::rename(fresh, target, system);
    if (system) {
        error.detail = system.message();
        std::filesystem::remove(fresh, system);
        return failed(error);
    }
    return std::monostate{};
}

} // namespace unprojector::scene_file
