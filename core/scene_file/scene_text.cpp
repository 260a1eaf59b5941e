#include "core/base/number_text.h"
#include "core/scene_file/scene_fields.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace unprojector::scene_file {
using namespace base;

std::string tooLargeText(std::size_t mostBytes)
{
    return tr("a scene may have at most %1; keep the landmarks in a file of their own (File > Export Landmarks), "
              "then remove them from the scene",
              tr("%1 MiB", shortestText(double(mostBytes) / (1 << 20))));
}

Expected<Json, Error> parsedJson(std::string_view text, const std::string &name, std::size_t mostBytes)
{
    if (text.size() > mostBytes)
        return Error{tooLargeText(mostBytes), {}, name};
    return parseJson(text, name);
}

SceneOrError parseScene(std::string_view text, const std::string &name, std::size_t mostBytes)
{
    const auto json = parsedJson(text, name, mostBytes);
    return json ? valueOfJson<Room, SceneFile>(*json, text, name) : json.error();
}

SceneOrError changed(const SceneFile &scene, const JsonValue &change, const std::string &name)
{
    Json document = jsonOfValue<Room>(scene);
    document.merge_patch(change.json());
    return valueOfJson<Room, SceneFile>(document, {}, name);
}

Expected<std::string, Error> sceneText(const SceneFile &scene)
{
    return readableJson(jsonOfValue<Room>(scene));
}

bool isSceneText(std::string_view text)
{
    Error place;
    return setPlace(place, text, {{"unprojector"}});
}

bool isSceneFile(const std::filesystem::path &file)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        return false;
    std::ifstream stream(file, std::ios::binary);
    // Reads only the start first: a model of gigabytes need not be read whole to see that it is no
    // scene.
    constexpr std::size_t kStart = 64;
    std::string text(kStart, '\0');
    const auto read = [&](std::size_t from) {
        stream.read(text.data() + from, static_cast<std::streamsize>(text.size() - from));
        text.resize(from + static_cast<std::size_t>(stream.gcount()));
    };
    read(0);
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first != std::string::npos && text[first] != '{')
        return false;
    if (text.size() == kStart) {
        // The key stands near the start of this program's scenes; a model with data inside is not read whole.
        constexpr std::uintmax_t kEnough = std::uintmax_t{8} << 20;
        const auto size = std::filesystem::file_size(file, error);
        text.resize(std::max<std::size_t>(kStart, error ? 0 : std::min(size, kEnough)));
        read(kStart);
    }
    return isSceneText(text);
}

} // namespace unprojector::scene_file
