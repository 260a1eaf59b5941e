#pragma once

#include "core/scene/scene.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// The object in whose space a point is given; nothing where it is in no object's.
std::optional<std::size_t> indexOf(const geometry::GivenPoint &given, const std::vector<scene::SceneObject> &objects);

/// Where the given point of a scene lies in the world.
/// @param setup  of the scene
/// @return nothing where the scene has none, and where its coordinates are those of no world point
std::optional<geometry::WorldPoint> givenWorld(const scene::Scene &scene, const geometry::Setup &setup);

/// A given point after the objects have changed: it names its object by its new name; where that was removed, it stays where
/// it is in the world.
/// @param before, after  the lists of objects
geometry::GivenPoint withObjects(const geometry::GivenPoint &given, const std::vector<scene::SceneObject> &before,
                                 const std::vector<scene::SceneObject> &after);

} // namespace unprojector::gui
