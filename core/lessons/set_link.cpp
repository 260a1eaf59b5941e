#include "core/lessons/set_link.h"

#include "core/scene_file/scene_file.h"

#include <nlohmann/json.hpp>

namespace unprojector::lessons {
using namespace scene_file;
using namespace geometry;
using namespace scene;

namespace {

/// The path of the first key: "projection.left".
std::string firstPath(const nlohmann::ordered_json &object)
{
    const auto first = object.begin();
    const bool goesOn = first.value().is_object() && !first.value().empty();
    return first.key() + (goesOn ? "." + firstPath(first.value()) : "");
}

} // namespace

base::Expected<SceneSettings, base::Error> settingsWith(const Scene &scene, const Setup &setup,
                                                        const base::JsonValue &change)
{
    const auto failed = [](base::Error error) {
        error.file = "set";
        return error;
    };
    SceneFile file = sceneFileFrom(scene, setup, {});
    file.extra = {}; // so that the change's extra keys show
    if (change.json().contains("point"))
        file.point.reset(); // coordinates alone would use the space of the user's last point
    const scene_file::SceneOrError next = changed(file, change, "set");
    if (!next)
        return failed(next.error());
    if (!next->extra.json().empty())
        return failed({"there is no " + firstPath(next->extra.json())});
    const base::Expected<Scene, base::Error> made = sceneFromFile(*next, {}, scene.objects);
    if (!made)
        return failed(made.error());
    // Settings that the change does not name stay the same to the last bit, with the matrices that
    // they came from.
    SceneSettings settings = scene;
    const auto speaksOf = [&change](const char *key) { return change.json().contains(key); };
    if (speaksOf("projection")) {
        if (made->projection.matrix()) {
            settings.projection = made->projection;
            settings.isDepthRangeTurned = made->isDepthRangeTurned;
        } else {
            settings.projection = *made->projection;
        }
    }
    if (speaksOf("view") && made->camera.matrix())
        settings.camera = made->camera;
    else if (speaksOf("view"))
        settings.camera = *made->camera;
    if (speaksOf("depthRange"))
        settings.depthRange = made->depthRange;
    if (speaksOf("clipPlanes")) {
        settings.clipPlanes = made->clipPlanes;
        settings.clipPlanesOff = made->clipPlanesOff;
    }
    if (speaksOf("point"))
        settings.givenPoint = made->givenPoint;
    if (speaksOf("ui")) {
        settings.viewport = made->viewport;
        settings.projectionFollowsViewport = made->projectionFollowsViewport;
        settings.clipDistancesFitObjects = made->clipDistancesFitObjects;
    }
    return settings;
}

} // namespace unprojector::lessons
