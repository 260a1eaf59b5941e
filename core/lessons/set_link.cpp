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
    const auto text = sceneText(sceneFileFrom(scene, picture, {}));
    if (!text)
        return failed(text.error());
    const nlohmann::ordered_json &patch = change.json();
    nlohmann::ordered_json document = nlohmann::ordered_json::parse(*text);
    if (patch.contains("point"))
        document.erase("point"); // coordinates alone would be of the space in which the user gave the last one
    document.merge_patch(patch);
    const Result<SceneFile, SceneFileError> file = parseScene(document.dump(), "set");
    if (!file)
        return failed(file.error());
    if (!file->extra.json().empty())
        return LessonError{"set: there is no " + firstPath(file->extra.json())};
    const Result<Scene, SceneFileError> made = sceneFromFile(*file, {}, scene.objects);
    if (!made)
        return failed(made.error());

    SceneSettings settings = scene;
    if (patch.contains("projection")) {
        settings.projection = made->projection;
        settings.given = made->given;
    }
    if (patch.contains("view")) {
        settings.camera = made->camera;
        settings.givenView = made->givenView;
    }
    if (patch.contains("depthRange"))
        settings.depthRange = made->depthRange;
    if (patch.contains("clipPlanes")) {
        settings.clipPlanes = made->clipPlanes;
        settings.clipPlanesOff = made->clipPlanesOff;
    }
    if (patch.contains("point"))
        settings.givenPoint = made->givenPoint;
    if (patch.contains("ui")) {
        settings.viewport = made->viewport;
        settings.projectionFollowsViewport = made->projectionFollowsViewport;
        settings.clipDistancesFitObjects = made->clipDistancesFitObjects;
    }
    return settings;
}

} // namespace unprojector::lessons
