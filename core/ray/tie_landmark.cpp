#include "core/ray/tie_landmark.h"

#include "core/geometry/transform.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>

namespace unprojector::ray {
using namespace geometry;

namespace {

/// The relative tolerance between a position and its text: single precision.
constexpr double kSamePlace = 1e-6;

glm::dvec3 moved(const glm::dmat4 &matrix, const glm::dvec3 &point)
{
    return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

} // namespace

std::optional<Tied> tieToMesh(landmarks::Landmark &landmark, std::span<const TyingTarget> targets)
{
    if (!landmark.world)
        return std::nullopt;
    const glm::dvec3 world = landmark.world->coordinates();
    const bool isNamed = std::any_of(targets.begin(), targets.end(),
                                     [&](const TyingTarget &target) { return target.name == landmark.object; });
    std::optional<Tied> best;
    std::optional<ClosestPlace> place;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const TyingTarget &target = targets[i];
        if (isNamed && target.name != landmark.object)
            continue;
        if (isNamed) {
            const std::optional<ObjectPoint> held = placeOf(landmark.anchor, target.places->model());
            const double distance =
                held ? glm::distance(moved(target.worldFromObject, held->coordinates()), world) : 0.0;
            if (held && distance <= kSamePlace * target.places->model().bounds.diagonal())
                return Tied{distance, i};
        }
        const glm::dvec3 object = moved(glm::inverse(target.worldFromObject), world);
        const std::optional<ClosestPlace> there = target.places->to(ObjectPoint(object));
        if (!there)
            continue;
        // The way through the matrix and back rounds; the identity does not.
        const double distance = target.worldFromObject == glm::dmat4(1.0)
                                    ? there->distance
                                    : glm::distance(moved(target.worldFromObject, there->point.coordinates()), world);
        if (!best || distance < best->distance) {
            best = Tied{distance, i};
            place = there;
        }
    }
    if (!best)
        return std::nullopt;
    const TyingTarget &target = targets[best->target];
    landmark.world = WorldPoint(moved(target.worldFromObject, place->point.coordinates()));
    landmark.anchor = place->anchor;
    landmark.object = target.name;
    return best;
}

} // namespace unprojector::ray
