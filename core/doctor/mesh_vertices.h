#pragma once

#include "core/doctor/diagnosis.h"
#include "core/scene/scene.h"

#include <span>
#include <vector>

namespace unprojector::doctor {

/// The vertices of the objects in sight that lie in a box of world space, its faces included, for Case::verticesIn. Every vertex
/// is looked at: no tree is needed. One a place, at most a thousand.
std::vector<KnownPoint> verticesIn(std::span<const scene::SceneObject> objects, const geometry::Box &world);

} // namespace unprojector::doctor
