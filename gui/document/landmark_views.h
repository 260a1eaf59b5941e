#pragma once

#include "core/geometry/spaces.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <optional>

namespace unprojector::gui {

class SceneDocument;

// Views of a landmark. Each is one step of undo; without a position they do nothing.

/// The outward surface normal at an anchor, in world space, length 1. At a vertex and on an edge,
/// the area-weighted mean of the adjacent triangles.
/// @return nothing if the landmark is on no surface
std::optional<geometry::WorldVector> normalAt(const landmarks::Anchor &anchor, const scene::SceneObject &object);

/// The mean outward normal of the surface around a point, world space, length 1: the area-weighted sum
/// over the triangles within a tenth of the object's size that face the same way as the surface there.
/// A crease or noise at the point itself does not turn it.
/// @param there  the surface at the point
/// @return nothing if the normals cancel out
std::optional<geometry::WorldVector> normalAround(const geometry::ObjectPoint &point, const landmarks::Anchor &there,
                                                  const scene::SceneObject &object);

/// Turns the camera to look at a point along the surface's normal there, and keeps its distance from
/// its centre.
/// @param normal  outward, length 1; nothing: the camera keeps its direction
void faceSurface(SceneDocument &document, const geometry::WorldPoint &point,
                 const std::optional<geometry::WorldVector> &normal);

/// Turns the camera to face the surface at the landmark and keeps its distance from its centre. A
/// landmark on no surface: turns the camera to it.
void goToLandmark(SceneDocument &document, std::size_t index);

/// Centres the landmark and zooms until `half` is half a device pixel there: the error of a manual
/// click on a surface that faces the camera.
/// @param half  world units, above 0
void zoomToLandmark(SceneDocument &document, std::size_t index, double half);

} // namespace unprojector::gui
