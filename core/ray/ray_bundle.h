#pragma once

#include "core/ray/ray.h"
#include "core/ray/unit_space.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace unprojector::ray {

/// The rays through a parallelogram of the picture: all between those through its corners, with the same t on each plane that
/// is parallel to the near one.
struct RayBundle {
    Ray<geometry::ObjectSpace> middle;
    std::array<Ray<geometry::ObjectSpace>, 4> corners;
};

/// A ball in unit space.
struct Ball {
    glm::vec3 center;
    float radius;
};

/// Balls one behind the other that hold what of a bundle lies in unit space, between the low and the high t of its middle: at most
/// a few hundred, as small as the bundle is wide where those are enough.
std::vector<Ball> ballsAlong(const RayBundle &bundle, const UnitSpace &space);

} // namespace unprojector::ray
