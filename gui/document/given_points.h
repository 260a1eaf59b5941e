#pragma once

#include "core/scene/scene.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// The object in whose space the point is given; nothing if it is in no object's space.
std::optional<std::size_t> indexOf(const geometry::GivenPoint &given, const std::vector<scene::SceneObject> &objects);

/// The world position of a scene's user point.
/// @param setup  of the scene
/// @return nothing if the scene has none, or if its coordinates match no world point
std::optional<geometry::WorldPoint> givenWorld(const scene::Scene &scene, const geometry::Setup &setup);

/// A user point adapted to changed objects: it takes over the new name of its object. If the object
/// was removed, it keeps its world position.
/// @param before, after  the lists of objects
geometry::GivenPoint withObjects(const geometry::GivenPoint &given, const std::vector<scene::SceneObject> &before,
                                 const std::vector<scene::SceneObject> &after);

} // namespace unprojector::gui
