#pragma once

#include "core/geometry/spaces.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <optional>

namespace unprojector::gui {

class SceneDocument;

// Ways to look at a placed point. Each is one step of undo, as every look around; of a missing point they do nothing.

/// World space, length 1: the outer side of the surface that holds a landmark; at a vertex and on an edge the mean of the
/// triangles about it by their areas.
/// @return nothing where no surface holds it
std::optional<geometry::WorldVector> normalAt(const landmarks::Anchor &anchor, const scene::SceneObject &object);

/// Turns the camera to face the surface at the point, as far away as the camera is from its centre; of a point that no surface
/// holds, to the point from where the camera is.
void goToLandmark(SceneDocument &document, std::size_t index);

/// Brings the point to the middle and gets closer, or farther, until half a device pixel is so much there: what a hand leaves
/// open on a surface that faces the camera.
/// @param half  world units, above 0
void zoomToLandmark(SceneDocument &document, std::size_t index, double half);

} // namespace unprojector::gui
