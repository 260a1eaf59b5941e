#include "core/ray/unit_space.h"

#include "core/geometry/finite.h"
#include "core/geometry/numbers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::ray {
using namespace geometry;

UnitSpace::UnitSpace(const mesh::Model &model)
{
    const Box bounds = model.bounds.isEmpty() ? mesh::boundsOf(model.meshes) : model.bounds;
    m_center = bounds.lowest / 2.0 + bounds.highest / 2.0;
    const glm::dvec3 half = bounds.highest / 2.0 - bounds.lowest / 2.0;
    const double size = std::max({half.x, half.y, half.z});
    m_size = size > 0.0 ? size : 1.0;
    m_scale = 1.0 / m_size;
}

std::optional<UnitRay> UnitSpace::inside(const Ray<ObjectSpace> &ray) const
{
    if (!isFinite(ray.from) || !isFinite(ray.along))
        return std::nullopt;
    const glm::dvec3 from = (ray.from.coordinates() - m_center) * m_scale;
    const glm::dvec3 along = ray.along.coordinates() * m_scale;
    const double length = glm::length(along);
    if (!(length > 0.0 && std::isfinite(length)))
        return std::nullopt;
    // A little larger than all boxes. The eye of a map may be very far away; then the box grows
    // with the rounding.
    const double distance = std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
    const double reach = 1.0 + 2.0 * double(kMargin) + 0x1p-50 * distance;
    double low = ray.low, high = ray.high;
    for (int axis = 0; axis < 3; ++axis) {
        if (along[axis] == 0.0) {
            if (std::abs(from[axis]) > reach)
                return std::nullopt;
            continue;
        }
        const double one = (-reach - from[axis]) / along[axis], other = (reach - from[axis]) / along[axis];
        low = std::max(low, std::min(one, other));
        high = std::min(high, std::max(one, other));
    }
    if (!(low <= high && std::isfinite(low) && std::isfinite(high)))
        return std::nullopt;
    glm::vec3 start(from + along * low);
    constexpr double kFar = 1e6;
    for (int axis = 0; axis < 3 && distance > kFar; ++axis) { // cancellation of the two terms
        const DoubleDouble exact =
            (DoubleDouble(ray.from[axis]) - m_center[axis] + DoubleDouble(ray.along[axis]) * low) * m_scale;
        start[axis] = static_cast<float>(exact.value);
    }
    UnitRay unit{start, glm::vec3(along / length), 0.0f, low, length};
    unit.length = unit.lengthTo(high);
    return unit;
}

float UnitRay::lengthTo(double t) const
{
    constexpr double kMost = 8.0; // more than the box's diagonal
    const double exact = (t - start) * scale;
    return static_cast<float>(std::min(exact, kMost)) + 4.0f * UnitSpace::kMargin;
}

} // namespace unprojector::ray
