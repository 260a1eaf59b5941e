#pragma once

#include "core/scene/scene.h"

namespace unprojector::scene {

/// World coordinates beyond this, and objects smaller than its inverse, leave the range of doubles when they are squared and
/// multiplied.
constexpr double kFarthestWorld = 1e100;

/// Whether an object's transform leaves it where it can be computed with.
/// @return ObjectTooFar; ObjectTooSmall
geometry::Check reachable(const SceneObject &object);

} // namespace unprojector::scene
