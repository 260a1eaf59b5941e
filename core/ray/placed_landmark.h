#pragma once

#include "core/landmarks/landmark.h"
#include "core/ray/scene_rays.h"

#include <string>

namespace unprojector::ray {

/// What holds a landmark that is placed where a click hits: the triangle; the vertex of a point of a point cloud and of what snaps
/// to vertices; the edge of what snaps to edges.
/// @param snap  what the click took
landmarks::Anchor anchorOf(const SceneHit &hit, Snap snap);

/// A landmark without a name, where a click hits. How far each coordinate can be off: by how far a hand that points with that
/// many pixels leaves the place open on the surface (to first order; a surface seen at less than 0.6 degrees counts as seen at
/// that), and by SceneHit::uncertainty. A vertex and a point of a point cloud are what the file has: only the latter counts.
/// @param rays      that hit
/// @param position  of the hit in their picture
/// @param object    the name of the object that was hit
/// @param pixels    how exactly a hand points, device pixels: a click means its pixel, 1
landmarks::Landmark landmarkAt(const SceneHit &hit, Snap snap, const SceneRays &rays,
                               const geometry::DevicePoint &position, const std::string &object, double pixels = 1.0);

} // namespace unprojector::ray
