#include "core/scene_file/clicks.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/double_double.h"
#include "core/geometry/finite.h"
#include "core/geometry/transform.h"
#include "core/scene_file/json_text.h"
#include "core/scene_file/scene_fields.h"
#include "core/scene_file/strict_json.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::scene_file {

// ---- what a click is made of, see json_fields.h ---------------------------------------------------------------

template <class Fields, Is<ClickPoint> T>
void describe(Fields &json, T &point)
{
    for (std::size_t i = 0; i < kMethodKeys.size(); ++i)
        json.nullable(kMethodKeys[i], point[i]);
}

template <class Fields, Is<ClickedObject> T>
void describe(Fields &json, T &object)
{
    json.required("index", object.index, Count{0, std::numeric_limits<int>::max()});
    json.required("name", object.name);
    describe(json, object.point);
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
    json.nullable("object", click.object);
    json.required("scene", click.scene);
}

namespace {

using Json = nlohmann::ordered_json;

template <class Space>
std::optional<glm::dvec3> coordinatesOf(const Result<Point<Space>> &point)
{
    return point ? std::optional(point->coordinates()) : std::nullopt;
}

template <class Space>
ClickPoint pointOf(const TwoWays<Space> &answers)
{
    return {coordinatesOf(answers.formula), coordinatesOf(answers.matrix), coordinatesOf(answers.matrixInFloat)};
}

std::optional<ClickedObject> objectOf(const Pick &pick, const Scene &scene)
{
    if (!pick.hit || !pick.object || *pick.object >= scene.objects.size())
        return std::nullopt;
    const SceneObject &object = scene.objects[*pick.object];
    const glm::dmat4 placement = worldFromObject(object.transform);
    const auto inObject = [&](const Result<WorldPoint> &point) {
        return point ? objectFromWorld(placement, *point) : Result<ObjectPoint>(point.error());
    };
    const TwoWays<WorldSpace> &world = pick.point.world;
    return ClickedObject{
        *pick.object, object.name,
        pointOf(TwoWays<ObjectSpace>{inObject(world.formula), inObject(world.matrix), inObject(world.matrixInFloat)})};
}

/// The picture of a click as a scene file has it, whatever rules of the window made it.
SceneFile sceneOf(const Pick &pick, const Scene &scene)
{
    SceneFile file = sceneFileFrom(scene, pick.geometry, {});
    file.viewport = pick.geometry.viewport;
    file.aspectFromViewport = false;
    file.ui = {};
    return file;
}

} // namespace

Result<ObjectPoint> objectFromWorld(const glm::dmat4 &worldFromObject, const WorldPoint &world)
{
    if (std::isinf(conditionNumber(worldFromObject)))
        return Error{ErrorCode::SingularMatrix};
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(worldFromObject));
    DoubleDouble3 p;
    for (int i = 0; i < 3; ++i) { // the inverse's own error goes with the square of each step
        glm::dvec3 left;
        for (int row = 0; row < 3; ++row) {
            const DoubleDouble3 entries{worldFromObject[0][row], worldFromObject[1][row], worldFromObject[2][row]};
            left[row] = (DoubleDouble(world[row]) - worldFromObject[3][row] - dot(entries, p)).value;
        }
        const glm::dvec3 step = inverse * left;
        for (int k = 0; k < 3; ++k)
            p[std::size_t(k)] = p[std::size_t(k)] + DoubleDouble(step[k]);
    }
    const glm::dvec3 point(p[0].value, p[1].value, p[2].value);
    if (!isFinite(point))
        return Error{ErrorCode::PointAtInfinity};
    return ObjectPoint(point);
}

Click clickOf(const Pick &pick, const Scene &scene)
{
    Click click{pick.widget, pick.devicePixel,      pick.window,         pick.hit, {},
                {},          objectOf(pick, scene), sceneOf(pick, scene)};
    click.eye = {pointOf(pick.point.eye), pointOf(pick.rayNear.eye), pointOf(pick.rayFar.eye)};
    click.world = {pointOf(pick.point.world), pointOf(pick.rayNear.world), pointOf(pick.rayFar.world)};
    return click;
}

Result<std::string, SceneFileError> clicksText(const std::vector<Click> &clicks)
{
    Json array = Json::array();
    for (const Click &click : clicks)
        array.push_back(FieldWriter::write(click, Plain{}, nullptr));
    return readableJson(array);
}

Result<SceneOrClicks, SceneFileError> parseSceneOrClicks(std::string_view text, const std::string &name)
{
    const Result<Json, SceneFileError> json = parseStrictJson(text);
    JsonNode::FirstError error;
    SceneOrClicks found;
    if (!json) {
        error = json.error();
    } else {
        const JsonNode root(*json, error);
        const bool isClick = json->is_object() && json->contains("scene") && !json->contains("unprojector");
        if (json->is_array() || isClick) {
            std::vector<Click> clicks(isClick ? 1 : json->size());
            for (std::size_t i = 0; i < clicks.size() && !error; ++i)
                static_cast<void>(isClick ? FieldReader::read(root, clicks[i], Plain{})
                                          : FieldReader::read(root.element(i), clicks[i], Plain{}));
            found = std::move(clicks);
        } else {
            SceneFile scene;
            static_cast<void>(FieldReader::read(root, scene, Plain{}));
            found = std::move(scene);
        }
    }
    if (!error)
        return found;
    error->file = name;
    return *error;
}

} // namespace unprojector::scene_file
