#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/base/system_error.h"
#include "core/scene_file/scene_file.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace unprojector::scene_file {
using namespace geometry;
using namespace base;
namespace {

SceneFileError failed(const std::filesystem::path &file, SceneFileErrorCode code, std::string detail = {})
{
    SceneFileError error;
    error.code = code;
    error.file = utf8FromPath(file);
    error.detail = std::move(detail);
    return error;
}

SceneFileError failed(const std::filesystem::path &file, const FileError &error)
{
    switch (error.code) {
    case FileErrorCode::IsDirectory: return failed(file, SceneFileErrorCode::IsDirectory);
    case FileErrorCode::ChangedMeanwhile: return failed(file, SceneFileErrorCode::ChangedMeanwhile);
    case FileErrorCode::IsReadOnly:
    case FileErrorCode::NotAFile:
    case FileErrorCode::NoFolder:
    case FileErrorCode::System: break;
    }
    return failed(file, SceneFileErrorCode::NotWritable, fileErrorText(error));
}

} // namespace

Result<std::string, SceneFileError> readSceneText(const std::filesystem::path &file)
{
    std::error_code system;
    const std::filesystem::file_status status = std::filesystem::status(file, system);
    if (status.type() == std::filesystem::file_type::not_found)
        return failed(file, SceneFileErrorCode::NotFound);
    if (std::filesystem::is_directory(status))
        return failed(file, SceneFileErrorCode::IsDirectory);
    // Opening a named pipe waits for a writer, perhaps for ever. A pipe inherited by this program
    // is open already.
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) && !isOwnDescriptor(file))
        return failed(file, SceneFileErrorCode::NotAFile);
    const auto notReadable = [&file] {
        return failed(file, SceneFileErrorCode::NotReadable, errno != 0 ? base::systemErrorText(errno) : std::string());
    };
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return notReadable();

    std::string text;
    std::array<char, 65536> block;
    do { // one block beyond the limit is enough to know that the file is too large
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    } while (stream && text.size() <= kMostSceneBytes);
    if (stream.bad())
        return notReadable();
    return text;
}

Result<SceneFile, SceneFileError> readSceneFile(const std::filesystem::path &file)
{
    const Result<std::string, SceneFileError> text = readSceneText(file);
    if (!text)
        return text.error();
    return parseScene(*text, utf8FromPath(file));
}

Result<FileStamp, SceneFileError> writeSceneFile(const std::filesystem::path &file, const SceneFile &scene,
                                                 const std::optional<FileStamp> &onlyIf)
{
    const Result<std::string, SceneFileError> text = sceneText(scene);
    if (!text) {
        SceneFileError error = text.error();
        error.file = utf8FromPath(file);
        return error;
    }
    if (text->size() > kMostSceneBytes) {
        SceneFileError error = failed(file, SceneFileErrorCode::TooLarge);
        error.limit = double(kMostSceneBytes);
        return error;
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].file.empty() || !isSameFile(objectFile(scene.objects[i], file), file))
            continue;
        SceneFileError error = failed(file, SceneFileErrorCode::IsOwnModel);
        error.keyPath = "objects[" + std::to_string(i) + "].file";
        return error;
    }
    if (const Written written = replaceFile(file, *text, onlyIf); !written)
        return failed(file, written.error());
    return stampOfContents(*text);
}

} // namespace unprojector::scene_file
