#include "core/scene_file/pick_json.h"

#include "core/geometry/angle.h"

#include <cmath>

namespace unprojector::scene_file {
using namespace geometry;
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const glm::dvec3 &v)
{
    return Json::array({v.x, v.y, v.z});
}

template <class Space>
Json toJson(const Result<Point<Space>> &point)
{
    return point ? toJson(point->coordinates()) : Json(nullptr);
}

template <class Space>
Json toJson(const Answers<Space> &point)
{
    Json json = Json::object();
    for (const Method method : kMethods)
        json[keyOf(method)] = toJson(point[method]);
    return json;
}

Json windowJson(const char *type, const ProjectionWindow &w)
{
    return {{"type", type}, {"left", w.left},         {"right", w.right},    {"bottom", w.bottom},
            {"top", w.top}, {"near", w.nearDistance}, {"far", w.farDistance}};
}

Json toJson(const Projection &projection)
{
    struct Visitor {
        Json operator()(const Frustum &p) const { return windowJson("frustum", projectionWindow(p)); }
        Json operator()(const Perspective &p) const { return windowJson("frustum", projectionWindow(p)); }
        Json operator()(const Ortho &p) const { return windowJson("ortho", projectionWindow(p)); }
        Json operator()(const Oblique &p) const
        {
            Json json = windowJson("oblique", projectionWindow(p));
            json["theta"] = degreesFromRadians(p.thetaRadians);
            json["phi"] = degreesFromRadians(p.phiRadians);
            return json;
        }
    };
    return std::visit(Visitor{}, projection);
}

} // namespace

Json toJson(const Picture &g)
{
    Json json = {
        {"window",
         {{"width", logicalFromDevice(g.surface, g.surface.widthPixels)},
          {"height", logicalFromDevice(g.surface, g.surface.heightPixels)},
          {"devicePixelRatio", g.surface.devicePixelRatio}}},
        {"viewport",
         {{"x", g.viewport.x}, {"y", g.viewport.y}, {"width", g.viewport.width}, {"height", g.viewport.height}}},
    };
    if (g.depthRange != DepthRange{})
        json["depthRange"] = {g.depthRange.atNear, g.depthRange.atFar};
    json["projection"] = toJson(g.projection());
    json["view"] = {{"eye", toJson(g.camera().eye.coordinates())},
                    {"center", toJson(g.camera().center.coordinates())},
                    {"up", toJson(g.camera().up)}};
    return json;
}

Json toJson(const Pick &pick)
{
    Json json = {
        {"widget", {pick.widget.x, pick.widget.y}},
        {"devicePixel", {pick.devicePixel.i, pick.devicePixel.j}},
        {"window", toJson(pick.window.coordinates())},
        {"hit", pick.hit},
    };
    if (pick.hit) {
        json["eye"] = toJson(pick.point.eye);
        json["world"] = toJson(pick.point.world);
    } else {
        json["eye"] = {{"near", toJson(pick.rayNear.eye)}, {"far", toJson(pick.rayFar.eye)}};
        json["world"] = {{"near", toJson(pick.rayNear.world)}, {"far", toJson(pick.rayFar.world)}};
    }
    json["scene"] = toJson(pick.geometry);
    return json;
}

} // namespace unprojector::scene_file
