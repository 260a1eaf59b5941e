#include "core/scene_file/clicks.h"

#include "core/base/translation.h"
#include "core/geometry/transform.h"
#include "core/scene_file/scene_fields.h"
#include "core/unproject/object_from_world.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace unprojector::scene_file {
using namespace geometry;
using namespace scene;
using namespace unproject;

// ---- the fields of a click, see json_fields.h ----

template <class Fields, Is<ClickPoint> T>
void describe(Fields &json, T &point)
{
    for (std::size_t i = 0; i < kMethods.size(); ++i)
        json.nullable(keyOf(kMethods[i]), point[i]);
}

template <class Fields, Is<ClickUncertainty> T>
void describe(Fields &json, T &uncertainty)
{
    json.required("eye", uncertainty.eye);
    json.required("world", uncertainty.world);
}

template <class Fields, Is<ClickedObject> T>
void describe(Fields &json, T &object)
{
    json.required("index", object.index, Whole{0, std::numeric_limits<int>::max()});
    json.required("name", object.name);
    describe(json, object.point);
}

template <class Fields, Is<RayOnMesh> T>
void describe(Fields &json, T &ray)
{
    if constexpr (!Fields::kReads) // values derived from a click are recomputed
        json.set(jsonOf(ray));
}

template <class Fields, Is<Click> T>
void describe(Fields &json, T &click)
{
    const auto describePlace = [&click](auto &fields, auto &place) {
        if (click.hit)
            return describe(fields, place.surface);
        fields.required("near", place.rayNear);
        fields.required("far", place.rayFar);
    };
    json.optional("widget", click.widget);
    json.optional("devicePixel", click.devicePixel);
    json.required("window", click.window);
    json.optional("hit", click.hit);
    json.optional("eye", click.eye, describePlace);
    json.optional("world", click.world, describePlace);
    json.optional("uncertainty", click.uncertainty);
    json.nullable("object", click.object);
    json.optional("rayOnMesh", click.rayOnMesh);
    json.required("scene", click.scene);
}

/// One click, or a list of them; only read.
struct GivenClicks {
    std::vector<Click> clicks;
};

template <class Fields, Is<GivenClicks> T>
void describe(Fields &json, T &given)
{
    if (json.json().is_array())
        json.value(given.clicks);
    else
        json.value(given.clicks.emplace_back());
}

namespace {

template <class Space>
ClickPoint pointOf(const Answers<Space> &answers)
{
    ClickPoint point;
    for (std::size_t i = 0; i < kMethods.size(); ++i) {
        if (const Result<Point<Space>> &answer = answers[kMethods[i]])
            point[i] = answer->coordinates();
    }
    return point;
}

std::optional<ClickedObject> objectOf(const Pick &pick, const Scene &scene)
{
    if (!pick.object || *pick.object >= scene.objects.size())
        return std::nullopt;
    const SceneObject &object = scene.objects[*pick.object];
    const PreciseMatrix placement = preciseWorldFromObject(object.transform);
    return ClickedObject{*pick.object, object.name, pointOf(Answers<ObjectSpace>::of([&](Method method) {
                             return objectPointOf(pick, method, placement);
                         }))};
}

/// The setup of a click as a scene file, without the window's rules that made it.
SceneFile sceneOf(const Pick &pick, const Scene &scene)
{
    Scene own = scene;
    own.depthRange = pick.setup.depthRange; // in single precision, as OpenGL had it
    own.fileKeys = {};
    for (SceneObject &object : own.objects)
        object.extra = {};
    SceneFile file = sceneFileFrom(own, pick.setup, {});
    file.viewport = pick.setup.viewport;
    file.aspectFromViewport = false;
    file.ui = {};
    if (hasAspectOf(pick.setup.projection(), pick.setup.viewport))
        file.ui.projectionFollowsViewport = false; // though the file may leave the aspect out
    // Landmarks and the followed point do not affect the computation.
    file.landmarks = {};
    file.point.reset();
    return file;
}

} // namespace

Click clickOf(const Pick &pick, const Scene &scene, std::optional<RayOnMesh> ray)
{
    Click click{pick.widget, pick.devicePixel, pick.window,           pick.hit(),     {},
                {},          std::nullopt,     objectOf(pick, scene), std::move(ray), sceneOf(pick, scene)};
    if (pick.hit())
        click.uncertainty = ClickUncertainty{pick.uncertainty.eye.coordinates(), pick.uncertainty.world.coordinates()};
    click.eye = {pointOf(pick.point.eye), pointOf(pick.rayNear.eye), pointOf(pick.rayFar.eye)};
    click.world = {pointOf(pick.point.world), pointOf(pick.rayNear.world), pointOf(pick.rayFar.world)};
    return click;
}

base::Expected<std::string, base::Error> clicksText(const std::vector<Click> &clicks)
{
    return base::readableJson(base::jsonOfValue<Room>(clicks));
}

base::Expected<SceneOrClicks, base::Error> parseSceneOrClicks(std::string_view text, const std::string &name)
{
    const auto json = parsedJson(text, name);
    if (!json)
        return json.error();
    if (!json->is_array() && !(json->is_object() && json->contains("scene") && !json->contains("unprojector"))) {
        auto scene = base::valueOfJson<Room, SceneFile>(*json, text, name);
        if (!scene)
            return scene.error();
        return SceneOrClicks(std::move(scene).value());
    }
    auto given = base::valueOfJson<Room, GivenClicks>(*json, text, name);
    if (!given)
        return given.error();
    return SceneOrClicks(std::move(given).value().clicks);
}

SceneOrError oneScene(const SceneOrClicks &given, const std::string &name)
{
    if (const auto *scene = std::get_if<SceneFile>(&given))
        return *scene;
    const auto &clicks = std::get<std::vector<Click>>(given);
    if (clicks.empty())
        return base::Error{.text = base::tr("it has no click and so no scene; give a scene file"), .file = name};
    const auto first = sceneText(clicks.front().scene);
    const bool isOne = std::all_of(clicks.begin() + 1, clicks.end(), [&first](const Click &click) {
        const auto other = sceneText(click.scene);
        return first && other && *first == *other;
    });
    if (!isOne)
        return base::Error{.text = base::tr("its clicks have different scenes; give one click, or the scene of one"),
                           .file = name};
    return clicks.front().scene;
}

} // namespace unprojector::scene_file
