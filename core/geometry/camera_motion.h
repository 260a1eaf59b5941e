#pragma once

#include "core/geometry/box.h"
#include "core/geometry/camera.h"
#include "core/geometry/setup.h"

namespace unprojector::geometry {

// Camera motions for the user's input. Each keeps a valid setup valid; none changes the surface.

/// The sides from which a model is viewed. World y is up; world z points to the viewer of the
/// front.
enum class StandardView { Front, Back, Right, Left, Top, Bottom };

/// Rotates the camera about a pivot like a turntable: `yaw` about world up, `pitch` about the
/// camera's side axis. The pitch stops short of the poles. The pivot stays at its position in the
/// view.
/// @param yawRadians    positive turns the scene to the right
/// @param pitchRadians  positive tips the scene's top towards the viewer
LookAt orbited(const LookAt &camera, const WorldPoint &pivot, double yawRadians, double pitchRadians);

/// Moves eye and center together.
LookAt moved(const LookAt &camera, const WorldVector &offset);

/// The camera that looks at the same centre from one of the six sides, at the same distance.
LookAt seenFrom(const LookAt &camera, StandardView side);

/// World size of one logical pixel at the depth of `anchor`. It scales pointer motion, which is in
/// logical pixels.
/// @pre the setup is valid
double worldPerLogicalPixel(const Setup &setup, const WorldPoint &anchor);

/// Zooms by `factor` (> 1: closer) so that `anchor` stays where it is in the view. In a perspective
/// the eye moves along the ray to it. A box shrinks about it while its eye steps forward. The
/// centre moves to the anchor's depth.
Setup zoomed(const Setup &setup, const WorldPoint &anchor, double factor);

/// Shifts the camera sideways so that `point` comes to the middle of the view. The centre takes the
/// point's depth.
LookAt recentered(const Setup &setup, const WorldPoint &point);

/// The projection with clip distances that fit the box tightly, so that the depth buffer has its
/// finest steps in the scene. A perspective cuts off everything nearer than 1% of the centre's
/// distance.
/// @param bounds  box of the pickable objects; empty: the distances stay
/// @param reach   box of what is only drawn (ground, axes): it moves the far plane, not the near
///         one
Projection withFittedClipDistances(const Setup &setup, const Box &bounds, const Box &reach);

} // namespace unprojector::geometry
