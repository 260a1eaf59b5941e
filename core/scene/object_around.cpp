#include "core/scene/object_around.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace unprojector::scene {
namespace {

/// Distance of a point to a box; 0 inside.
double distanceTo(const Box &box, const glm::dvec3 &point)
{
    return glm::length(point - glm::clamp(point, box.lowest, box.highest));
}

} // namespace

std::optional<std::size_t> objectAround(const Scene &scene, const WorldPoint &point)
{
    constexpr double kInside = 1e-6; // of a box's diagonal
    std::optional<std::size_t> best;
    double bestDistance = 0.0, bestDiagonal = 0.0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const SceneObject &object = scene.objects[i];
        const Box box = object.model->bounds.transformed(worldFromObject(object.transform));
        if (box.isEmpty())
            continue;
        const double diagonal = box.diagonal();
        double distance = distanceTo(box, point.coordinates());
        if (distance <= kInside * diagonal)
            distance = 0.0;
        if (!best || distance < bestDistance || (distance == bestDistance && diagonal < bestDiagonal)) {
            best = i;
            bestDistance = distance;
            bestDiagonal = diagonal;
        }
    }
    return best;
}

} // namespace unprojector::scene
