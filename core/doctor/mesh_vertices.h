#pragma once

#include "core/doctor/diagnosis.h"
#include "core/scene/scene.h"

#include <span>
#include <vector>

namespace unprojector::doctor {

/// The vertices of the visible objects in a box of world space, including its faces, for
/// Case::verticesIn. It tests every vertex, so no tree is needed. One per position, at most a
/// thousand.
std::vector<KnownPoint> verticesIn(std::span<const scene::SceneObject> objects, const geometry::Box &world);

} // namespace unprojector::doctor
