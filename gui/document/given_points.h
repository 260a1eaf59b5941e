#pragma once

#include "core/scene/scene.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

/// The object in whose space a point is given; nothing where it is in no object's.
std::optional<std::size_t> placeOf(const GivenPoint &given, const std::vector<SceneObject> &objects);

/// Where the given point of a scene lies in the world.
/// @param picture  of the scene
/// @return nothing where the scene has none, and where its coordinates are those of no world point
std::optional<WorldPoint> givenWorld(const Scene &scene, const Picture &picture);

/// A given point after the objects have changed: it names its object by its new name; where that was removed, it stays where
/// it is in the world.
/// @param before, after  the lists of objects
GivenPoint withObjects(const GivenPoint &given, const std::vector<SceneObject> &before,
                       const std::vector<SceneObject> &after);

} // namespace unprojector::gui
