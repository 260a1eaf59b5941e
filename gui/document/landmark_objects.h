#pragma once

#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// Landmarks after their objects have changed: they go with the object that they name. Where it was moved, one that is held
/// by its mesh is where the mesh has it now, a free one goes the same way; where it was renamed, they name it by its new name;
/// where it was removed, they are free where they are, on nothing. How far they can be off is stretched with the object.
/// @param before, after  the lists of objects
/// @return the same where nothing of that concerns any of them
std::shared_ptr<const landmarks::LandmarkSet> withObjects(const std::shared_ptr<const landmarks::LandmarkSet> &set,
                                                          const std::vector<scene::SceneObject> &before,
                                                          const std::vector<scene::SceneObject> &after);

/// Landmarks carried along as one object goes from a placement to another: all of them, whatever they lie on, and semilandmarks. Those of the object are
/// where its mesh has them then, and name it by its name there. Between a scene and the file of the object's mesh, whose placement
/// is none: the way back has rounding, and the errors of single axes do not come back as they were, only their length does.
/// @param from, to  the same object, with the same model
/// @return nothing where a coordinate would not be finite, as back from an object that is scaled to nothing
std::optional<landmarks::LandmarkSet> transformed(landmarks::LandmarkSet set, const scene::SceneObject &from,
                                                  const scene::SceneObject &to);

/// Lets go of landmarks what their objects do not hold: objects that are not there, elements that a model does not have, or that are elsewhere than the
/// landmark, as of another version of the file. They stay where they are, free.
/// @return how many, and one of them, in sentences; empty where all are where they are held
QString detachStale(std::vector<landmarks::Landmark> &landmarks, const std::vector<scene::SceneObject> &objects);

/// Where a landmark's hold is in the world.
/// @return nothing where it is free, and where the object has no such triangle or vertex
std::optional<geometry::WorldPoint> worldOf(const landmarks::Anchor &anchor, const scene::SceneObject &object);

} // namespace unprojector::gui
