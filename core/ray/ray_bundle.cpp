#include "core/ray/ray_bundle.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unprojector::ray {

std::vector<Ball> ballsAlong(const RayBundle &bundle, const UnitSpace &space)
{
    constexpr double kReach = std::numbers::sqrt3 * (1.0 + 4.0 * double(UnitSpace::kMargin)); // of unit space
    constexpr double kMost = 256.0;
    const glm::dvec3 from = (bundle.middle.from.coordinates() - space.center()) * space.scale();
    const glm::dvec3 along = bundle.middle.along.coordinates() * space.scale();
    // At t nothing of the bundle is farther from its middle than width + growth t.
    double width = 0.0, growth = 0.0;
    for (const Ray<ObjectSpace> &corner : bundle.corners) {
        width = std::max(width, distance(corner.from, bundle.middle.from) * space.scale());
        growth = std::max(growth, length(corner.along - bundle.middle.along) * space.scale());
    }
    // Where |from + t along| <= kReach + width + growth t.
    const double a = glm::dot(along, along) - growth * growth;
    const double b = glm::dot(from, along) - (kReach + width) * growth;
    const double c = glm::dot(from, from) - (kReach + width) * (kReach + width);
    const double square = b * b - a * c;
    if (!(a > 0.0 && std::isfinite(square))) // as wide as it is long
        return {{glm::vec3(0.0f), static_cast<float>(2.0 * kReach)}};
    if (square < 0.0)
        return {};
    const double low = std::max(bundle.middle.low, (-b - std::sqrt(square)) / a);
    const double high = std::min(bundle.middle.high, (-b + std::sqrt(square)) / a);
    const double size = glm::length(along);
    std::vector<Ball> balls;
    for (double start = low, end = low; start <= high && (balls.empty() || end < high); start = end) {
        end = std::min(high, start + std::max((width + growth * start) / size, (high - low) / kMost));
        const double radius = size * (end - start) / 2.0 + width + growth * end + 8.0 * double(UnitSpace::kMargin);
        balls.push_back({glm::vec3(from + along * ((start + end) / 2.0)), static_cast<float>(radius)});
    }
    return balls;
}

} // namespace unprojector::ray
