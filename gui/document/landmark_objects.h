#pragma once

#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {
using namespace scene;

/// Landmarks after their objects have changed: they go with the object that they name. Where it was moved, one that is held
/// by its mesh is where the mesh has it now, a free one goes the same way; where it was renamed, they name it by its new name;
/// where it was removed, they are free where they are, on nothing. How far they can be off is stretched with the object.
/// @param before, after  the lists of objects
/// @return the same where nothing of that concerns any of them
std::shared_ptr<const landmarks::LandmarkSet> withObjects(const std::shared_ptr<const landmarks::LandmarkSet> &set,
                                                          const std::vector<SceneObject> &before,
                                                          const std::vector<SceneObject> &after);

/// Where a landmark's hold is in the world.
/// @return nothing where it is free, and where the object has no such triangle or vertex
std::optional<WorldPoint> worldOf(const landmarks::Hold &hold, const SceneObject &object);

} // namespace unprojector::gui
