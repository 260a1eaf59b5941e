#pragma once

#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// Landmarks adapted to changed objects. If an object was moved, an anchored landmark stays on its
/// mesh and a free one moves along. If it was renamed, landmarks take over its new name. If it was
/// removed, they keep their position and become free. Uncertainties scale with the object.
/// @param before, after  the lists of objects
/// @return the same set if no landmark is concerned
std::shared_ptr<const landmarks::LandmarkSet> withObjects(const std::shared_ptr<const landmarks::LandmarkSet> &set,
                                                          const std::vector<scene::SceneObject> &before,
                                                          const std::vector<scene::SceneObject> &after);

/// Landmarks transformed from one placement of an object to another: all of them, on any object,
/// and semilandmarks. Those on the object are anchored to its mesh and take its name there. Used
/// between a scene and the file of the object's mesh, which has no placement. The way back has
/// rounding; the errors of single axes change, only their length is restored.
/// @param from, to  the same object, with the same model
/// @return nothing if a coordinate would not be finite, as back from an object that is scaled to
/// nothing
std::optional<landmarks::LandmarkSet> transformed(landmarks::LandmarkSet set, const scene::SceneObject &from,
                                                  const scene::SceneObject &to);

/// Detaches landmarks from objects that no longer exist, and from elements that are missing or
/// elsewhere, as in another version of the file. They keep their position and become free. The
/// uncertainty of those that are away from their anchor becomes unknown.
/// @return how many, and one of them, in sentences; empty if none was detached
QString detachStale(std::vector<landmarks::Landmark> &landmarks, const std::vector<scene::SceneObject> &objects);

/// The world position of a landmark's anchor.
/// @return nothing if it is free, or if the object has no such triangle or vertex
std::optional<geometry::WorldPoint> worldOf(const landmarks::Anchor &anchor, const scene::SceneObject &object);

} // namespace unprojector::gui
