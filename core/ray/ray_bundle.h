#pragma once

#include "core/ray/ray.h"
#include "core/ray/unit_space.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace unprojector::ray {

/// The rays through a parallelogram of the view: all rays between those through its corners, with
/// equal t on each plane parallel to the near one.
struct RayBundle {
    Ray<geometry::ObjectSpace> middle;
    std::array<Ray<geometry::ObjectSpace>, 4> corners;
};

/// A ball in unit space.
struct Ball {
    glm::vec3 center;
    float radius;
};

/// A row of balls that covers a bundle in unit space, between the low and the high t of its middle.
/// At most a few hundred, as small as the bundle's width if that many suffice.
std::vector<Ball> ballsAlong(const RayBundle &bundle, const UnitSpace &space);

} // namespace unprojector::ray
