#include "core/ray/placed_landmark.h"

#include "core/base/json.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <variant>

namespace unprojector::ray {
using namespace geometry;
using namespace landmarks;
namespace {

/// The key of a landmark's other data.
constexpr const char *kEdgeKey = "pixelEdge";

OnEdge edgeOf(const TriangleDetail &triangle)
{
    OnEdge edge{triangle.edge.ids, 0.0};
    double first = 0.0, second = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.ids[k] == edge.vertices[0])
            first = triangle.barycentric[static_cast<int>(k)];
        if (triangle.ids[k] == edge.vertices[1])
            second = triangle.barycentric[static_cast<int>(k)];
    }
    if (first + second > 0.0)
        edge.share = second / (first + second);
    return edge;
}

/// The shift of the hit's point on its plane for a shift of the position in the view, to first
/// order.
glm::dvec3 wayOnPlane(const ClickRays &rays, const DevicePoint &position, const glm::dvec2 &way, const SceneHit &hit,
                      const WorldVector &normal)
{
    const auto ray = rays.at(DevicePoint(position.x + way.x, position.y + way.y));
    if (!ray)
        return glm::dvec3(0.0);
    const glm::dvec3 along = glm::normalize(ray->along.coordinates());
    const glm::dvec3 beside = ray->at(hit.t).coordinates() - hit.world.coordinates();
    const double facing = glm::dot(normal.coordinates(), along);
    constexpr double kLeastFacing = 0.01;
    const double counted = std::copysign(std::max(std::abs(facing), kLeastFacing), facing);
    return beside - along * (glm::dot(normal.coordinates(), beside) / counted);
}

/// The uncertainty due to pointing by hand.
glm::dvec3 reachOf(const SceneHit &hit, const Anchor &anchor, const SceneRays &rays, const DevicePoint &position,
                   double pixels)
{
    if (!hit.triangle || std::holds_alternative<AtVertex>(anchor))
        return glm::dvec3(0.0);
    const WorldVector &normal = hit.triangle->normal;
    const double half = 0.5 * pixels;
    const glm::dvec3 aside = wayOnPlane(rays.rays(), position, {half, 0.0}, hit, normal);
    const glm::dvec3 down = wayOnPlane(rays.rays(), position, {0.0, half}, hit, normal);
    if (const auto *edge = std::get_if<OnEdge>(&anchor)) {
        // It stays on the edge, but anywhere on it.
        const std::array<WorldPoint, 3> corners = rays.corners(hit);
        const auto cornerOf = [&](std::uint32_t vertex) {
            const auto &ids = hit.triangle->ids;
            return corners[static_cast<std::size_t>(std::find(ids.begin(), ids.end() - 1, vertex) - ids.begin())];
        };
        const glm::dvec3 way = (cornerOf(edge->vertices[1]) - cornerOf(edge->vertices[0])).coordinates();
        const double length = glm::length(way);
        const glm::dvec3 along = length > 0.0 ? way / length : glm::dvec3(0.0);
        return glm::abs(along) * (std::abs(glm::dot(along, aside)) + std::abs(glm::dot(along, down)));
    }
    return glm::abs(aside) + glm::abs(down);
}

} // namespace

Anchor anchorOf(const SceneHit &hit, Snap snap)
{
    if (!hit.triangle || snap == Snap::Vertex)
        return AtVertex{hit.vertex.id};
    if (snap == Snap::Edge)
        return edgeOf(*hit.triangle);
    return OnTriangle{hit.triangle->triangle, hit.triangle->barycentric};
}

Landmark landmarkAt(const SceneHit &hit, Snap snap, const SceneRays &rays, const DevicePoint &position,
                    const std::string &object, double pixels)
{
    Landmark landmark;
    landmark.anchor = anchorOf(hit, snap);
    landmark.world = hit.world;
    landmark.object = object;
    landmark.uncertainty = hit.uncertainty + WorldVector(reachOf(hit, landmark.anchor, rays, position, pixels));
    return landmark;
}

void addEdge(Landmark &landmark, const PixelEdge &edge, const std::string &object)
{
    nlohmann::ordered_json &json = landmark.extra.edit()[kEdgeKey];
    json["object"] = edge.object ? nlohmann::ordered_json(object) : nlohmann::ordered_json();
    json["behind"] = edge.object ? nlohmann::ordered_json(edge.behind) : nlohmann::ordered_json();
    if (landmark.uncertainty)
        landmark.uncertainty = *landmark.uncertainty + edge.reach;
}

std::optional<LandmarkEdge> edgeOf(const Landmark &landmark)
{
    const nlohmann::ordered_json &extra = landmark.extra.json();
    const auto found = extra.is_object() ? extra.find(kEdgeKey) : extra.end();
    if (!extra.is_object() || found == extra.end() || !found->is_object())
        return std::nullopt;
    const auto object = found->find("object"), behind = found->find("behind");
    LandmarkEdge edge;
    if (object != found->end() && object->is_string())
        edge.object = object->get<std::string>();
    if (behind != found->end() && base::isJsonNumber(*behind))
        edge.behind = base::valueOfJsonNumber(*behind);
    return edge;
}

void takeEdge(Landmark &landmark, const Landmark &of)
{
    const auto holdsEdge = [](const Landmark &each) {
        return each.extra.json().is_object() && each.extra.json().contains(kEdgeKey);
    };
    if (holdsEdge(of)) {
        landmark.extra.edit()[kEdgeKey] = of.extra.json()[kEdgeKey];
    } else if (holdsEdge(landmark)) {
        landmark.extra.edit().erase(kEdgeKey);
        if (landmark.extra.json().empty())
            landmark.extra = {};
    }
}

} // namespace unprojector::ray
