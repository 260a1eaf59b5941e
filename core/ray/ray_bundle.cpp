#include "core/ray/ray_bundle.h"

#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unprojector::ray {
using namespace geometry;

std::vector<Ball> ballsAlong(const RayBundle &bundle, const UnitSpace &space)
{
    constexpr double kReach = std::numbers::sqrt3 * (1.0 + 4.0 * double(UnitSpace::kMargin)); // in unit space
    constexpr double kMost = 256.0;
    const glm::dvec3 along = bundle.middle.along.coordinates() * space.scale();
    const double square = glm::dot(along, along);
    // Lengths s are measured along the middle from its point nearest to the space's centre, which
    // may be far from the start of the rays.
    const double nearest =
        -glm::dot((bundle.middle.from.coordinates() - space.center()) * space.scale(), along) / square;
    glm::dvec3 place(0.0);
    for (int axis = 0; axis < 3; ++axis) { // cancellation of the two terms
        const DoubleDouble exact = DoubleDouble(bundle.middle.from[axis]) - space.center()[axis]
                                   + DoubleDouble(bundle.middle.along[axis]) * nearest;
        place[axis] = exact.value * space.scale();
    }
    // Every ray of the bundle at s is within width + growth s of its middle.
    double width = 0.0, growth = 0.0;
    for (const Ray<ObjectSpace> &corner : bundle.corners) {
        width = std::max(width, distance(corner.from, bundle.middle.from) * space.scale());
        growth = std::max(growth, length(corner.along - bundle.middle.along) * space.scale());
    }
    width += growth * nearest;
    // The interval with |place + s along| <= kReach + width + growth s.
    const double a = square - growth * growth;
    const double b = glm::dot(place, along) - (kReach + width) * growth;
    const double c = glm::dot(place, place) - (kReach + width) * (kReach + width);
    const double root = b * b - a * c;
    if (!(a > 0.0 && std::isfinite(root))) // as wide as long
        return {{glm::vec3(0.0f), static_cast<float>(2.0 * kReach)}};
    if (root < 0.0)
        return {};
    const double low = std::max(bundle.middle.low - nearest, (-b - std::sqrt(root)) / a);
    const double high = std::min(bundle.middle.high - nearest, (-b + std::sqrt(root)) / a);
    const double size = std::sqrt(square);
    std::vector<Ball> balls;
    for (double start = low, end = low; start <= high && (balls.empty() || end < high); start = end) {
        end = std::min(high, start + std::max((width + growth * start) / size, (high - low) / kMost));
        if (!(end > start)) // the step vanishes in double
            end = high;
        const double radius = size * (end - start) / 2.0 + width + growth * end + 8.0 * double(UnitSpace::kMargin);
        balls.push_back({glm::vec3(place + along * ((start + end) / 2.0)), static_cast<float>(radius)});
    }
    return balls;
}

} // namespace unprojector::ray
