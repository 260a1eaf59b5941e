#pragma once

#include "core/scene/scene.h"

namespace unprojector::scene {

/// World coordinates beyond this, and objects smaller than its inverse, leave the range of doubles
/// when squared and multiplied.
constexpr double kFarthestWorld = 1e100;

/// Returns whether computations with an object's transform stay in range.
/// @return ObjectTooFar; ObjectTooSmall
geometry::Check reachable(const SceneObject &object);

} // namespace unprojector::scene
