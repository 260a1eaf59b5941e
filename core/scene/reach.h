#pragma once

#include "core/scene/scene.h"

namespace unprojector::scene {

/// World coordinates beyond this, and objects smaller than its inverse, leave the range of doubles when they are squared and
/// multiplied.
constexpr double kFarthestWorld = 1e100;

/// Whether an object's transform leaves it where it can be computed with.
/// @return NotFinite with the coordinate that is too far away, a NaN or an infinity among them, or with a size that is too
///         small
Check reachable(const SceneObject &object);

} // namespace unprojector::scene
