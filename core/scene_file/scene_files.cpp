#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/base/system_error.h"
#include "core/base/translation.h"
#include "core/scene_file/scene_file.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace unprojector::scene_file {
using namespace base;

Error notReadable(const std::string &name, int reason)
{
    return {.text = tr("the file cannot be read") + (reason != 0 ? tr(" (%1)", systemErrorText(reason)) : ""),
            .file = name,
            .kind = Error::Kind::File};
}

Expected<std::string, Error> readSceneText(const std::filesystem::path &file)
{
    const auto failed = [&file](std::string text, Error::Kind kind = Error::Kind::File) {
        return Error{.text = std::move(text), .file = utf8FromPath(file), .kind = kind};
    };
    std::error_code system;
    const std::filesystem::file_status status = std::filesystem::status(file, system);
    if (status.type() == std::filesystem::file_type::not_found)
        return failed(tr("there is no such file"), Error::Kind::NoFile);
    if (std::filesystem::is_directory(status))
        return failed(tr("this is a folder, not a scene file"));
    // Opening a named pipe waits for a writer, perhaps for ever. A pipe inherited by this program
    // is open already.
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) && !isOwnDescriptor(file))
        return failed(tr("this is a pipe or a device, not a scene file"));
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return notReadable(utf8FromPath(file), errno);

    std::string text;
    std::array<char, 65536> block;
    do { // one block beyond the limit is enough to know that the file is too large
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    } while (stream && text.size() <= kMostSceneBytes);
    if (stream.bad())
        return notReadable(utf8FromPath(file), errno);
    return text;
}

SceneOrError readSceneFile(const std::filesystem::path &file)
{
    const Expected<std::string, Error> text = readSceneText(file);
    if (!text)
        return text.error();
    return parseScene(*text, utf8FromPath(file));
}

Expected<FileStamp, Error> writeSceneFile(const std::filesystem::path &file, const SceneFile &scene,
                                          const std::optional<FileStamp> &onlyIf)
{
    const auto failed = [&file](Error error) {
        error.file = utf8FromPath(file);
        return error;
    };
    const Expected<std::string, Error> text = sceneText(scene);
    if (!text)
        return failed(text.error());
    if (text->size() > kMostSceneBytes)
        return failed({tooLargeText(kMostSceneBytes)});
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (!scene.objects[i].file.empty() && isSameFile(objectFile(scene.objects[i], file), file))
            return failed({tr("the scene shows this model and would overwrite it; give another name"),
                           "objects[" + std::to_string(i) + "].file"});
    }
    if (const Done written = replaceFile(file, *text, onlyIf); !written)
        return failed(written.error());
    return stampOfContents(*text);
}

} // namespace unprojector::scene_file
