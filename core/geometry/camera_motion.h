#pragma once

#include "core/geometry/box.h"
#include "core/geometry/camera.h"
#include "core/geometry/setup.h"

namespace unprojector::geometry {

// What a user's hand does to a camera. All of it keeps a valid geometry valid; nothing here touches the surface.

/// The sides a model is looked at from. World y is up, z points to the viewer of the front.
enum class StandardView { Front, Back, Right, Left, Top, Bottom };

/// Turns the camera about a pivot, as a turntable: `yaw` about world up, `pitch` about the camera's side axis,
/// stopping short of the poles. The pivot keeps its place in the picture.
/// @param yawRadians    positive turns the scene to the right
/// @param pitchRadians  positive tips the scene's top towards the viewer
LookAt orbited(const LookAt &camera, const WorldPoint &pivot, double yawRadians, double pitchRadians);

/// Moves eye and center together.
LookAt moved(const LookAt &camera, const WorldVector &offset);

/// Looks at the same centre from one of the six sides, at the same distance.
LookAt seenFrom(const LookAt &camera, StandardView side);

/// World size of one logical pixel at the depth of `anchor`: what a hand, whose ways are logical pixels, moves by.
/// @pre the geometry is valid
double worldPerLogicalPixel(const Setup &setup, const WorldPoint &anchor);

/// Zooms by `factor` (> 1: closer) so that `anchor` stays where it is in the picture: a perspective's eye moves
/// along the ray to it, a box shrinks about it while its eye steps forward. The centre moves to the anchor's depth.
Setup zoomed(const Setup &setup, const WorldPoint &anchor, double factor);

/// Shifts the camera sideways so that `point` comes to the middle of the picture, and makes its depth the centre's.
LookAt recentered(const Setup &setup, const WorldPoint &point);

/// Clip distances that hold the box tightly, which gives the depth buffer's steps to the scene; what lies in front
/// of the eye by less than 1% of the centre's distance is cut off in a perspective.
/// @param bounds  of what is picked; empty: the distances stay
/// @param reach   of what is only drawn (ground, axes): it stretches the far plane, not the near one
Projection withFittedClipDistances(const Setup &setup, const Box &bounds, const Box &reach);

} // namespace unprojector::geometry
