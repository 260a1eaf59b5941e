#pragma once

#include "core/geometry/spaces.h"
#include "core/scene/scene.h"

#include <optional>

namespace unprojector::scene {
using namespace geometry;

/// The object that a point on a surface belongs to, told by the boxes alone: the one whose world bounds hold the point
/// (a millionth of their diagonal counts as inside, since a picked point is rounded), the smallest such box, else the
/// nearest one; nothing without objects.
std::optional<std::size_t> objectAround(const Scene &scene, const WorldPoint &point);

} // namespace unprojector::scene
