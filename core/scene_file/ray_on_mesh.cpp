#include "core/scene_file/ray_on_mesh.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace unprojector::scene_file {
using namespace geometry;
using namespace ray;
using base::Json, base::jsonNumber; // a number that is not finite is written as null
namespace {

Json list(const glm::dvec3 &v)
{
    return Json::array({jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.z)});
}

void addPlace(Json &json, const WorldPoint &world, double distance)
{
    json["world"] = list(world.coordinates());
    json["distance"] = jsonNumber(distance);
}

} // namespace

Json jsonOf(const RayOnMesh &ray)
{
    Json json = Json::object();
    json["hit"] = ray.hit.has_value();
    const auto addPixelEdge = [&] {
        if (!ray.edge)
            return;
        json["pixelEdge"]["object"] = ray.edge->object ? Json(ray.edgeObject) : Json();
        json["pixelEdge"]["behind"] = ray.hit && ray.edge->object ? jsonNumber(ray.edge->behind) : Json();
    };
    if (!ray.hit) {
        addPixelEdge();
        return json;
    }
    const SceneHit &hit = *ray.hit;
    const std::optional<TriangleDetail> &triangle = hit.triangle;
    json["object"] = ray.object;
    json["triangle"] = triangle ? Json(triangle->triangle) : Json();
    json["barycentric"] = triangle ? list(triangle->barycentric) : Json();
    json["world"] = list(hit.world.coordinates());
    json["objectPoint"] = list(hit.objectPoint.coordinates());
    json["normal"] = triangle ? list(triangle->normal.coordinates()) : Json();
    json["distance"] = jsonNumber(hit.distance);
    json["vertex"]["id"] = hit.vertex.id;
    addPlace(json["vertex"], hit.vertex.world, hit.vertex.distance);
    json["edge"] = nullptr;
    if (triangle) {
        json["edge"]["ids"] = Json::array({triangle->edge.ids[0], triangle->edge.ids[1]});
        addPlace(json["edge"], triangle->edge.world, triangle->edge.distance);
    }
    json["uncertainty"] = list(hit.uncertainty.coordinates());
    addPixelEdge();
    return json;
}

} // namespace unprojector::scene_file
