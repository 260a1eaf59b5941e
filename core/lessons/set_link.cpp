#include "core/lessons/set_link.h"

#include "core/scene_file/scene_error_text.h"
#include "core/scene_file/scene_file.h"

#include <nlohmann/json.hpp>

namespace unprojector::lessons {
namespace {

/// "projection.left"
std::string firstPath(const nlohmann::ordered_json &object)
{
    const auto first = object.begin();
    const bool goesOn = first.value().is_object() && !first.value().empty();
    return first.key() + (goesOn ? "." + firstPath(first.value()) : "");
}

} // namespace

Result<SceneSettings, LessonError> settingsWith(const Scene &scene, const Picture &picture,
                                                const text::JsonValue &change)
{
    using namespace scene_file;
    const auto failed = [](SceneFileError error) {
        error.file = "set";
        return LessonError{sceneErrorText(error)};
    };
    SceneFile file = sceneFileFrom(scene, picture, {});
    file.extra = {}; // so that those of the change are seen
    if (change.json().contains("point"))
        file.point.reset(); // coordinates alone would be of the space in which the user gave the last one
    const Result<SceneFile, SceneFileError> next = changed(file, change, "set");
    if (!next)
        return failed(next.error());
    if (!next->extra.json().empty())
        return LessonError{"set: there is no " + firstPath(next->extra.json())};
    const Result<Scene, SceneFileError> made = sceneFromFile(*next, {}, scene.objects);
    if (!made)
        return failed(made.error());
    SceneSettings settings = *made;
    settings.fileKeys = scene.fileKeys;
    return settings;
}

} // namespace unprojector::lessons
