#pragma once

#include "core/landmarks/landmark.h"
#include "core/ray/scene_rays.h"

#include <string>

namespace unprojector::ray {

/// The anchor of a landmark placed at a hit: the triangle; the vertex for a point of a point cloud
/// or a click snapped to a vertex; the edge for a click snapped to an edge.
/// @param snap  the mode of the click
landmarks::Anchor anchorOf(const SceneHit &hit, Snap snap);

/// A landmark without a name at a hit. Its uncertainty is the sum of SceneHit::uncertainty and the
/// extent on the surface of a pointing error of `pixels` (to first order; surfaces seen at less
/// than 0.6 degrees count as 0.6 degrees). A vertex and a point of a point cloud have only
/// SceneHit::uncertainty, since the file defines their coordinates.
/// @param rays      of the hit
/// @param position  of the hit in their setup
/// @param object    the name of the hit object
/// @param pixels    the precision of pointing, device pixels: a click means its pixel, 1
landmarks::Landmark landmarkAt(const SceneHit &hit, Snap snap, const SceneRays &rays,
                               const geometry::DevicePoint &position, const std::string &object, double pixels = 1.0);

} // namespace unprojector::ray
