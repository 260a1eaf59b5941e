#pragma once

#include "core/ray/scene_hit.h"
#include "core/scene/scene.h"
#include "core/unproject/depth_error.h"

namespace unprojector::ray {

/// What is known of the surface under a pixel when nothing but the object has been read: the space of its vertices. Where
/// its meshes have different origins, that of the mesh whose origin is nearest to the point.
/// @param point  on the surface, or nearly
unproject::DrawnSurface drawnSurface(const scene::SceneObject &object, const geometry::WorldPoint &point);

/// The same when the ray through the pixel's centre is known to meet the object: its triangle, or its point.
/// @pre the hit is on the object's model
unproject::DrawnSurface drawnSurface(const scene::SceneObject &object, const SceneHit &hit);

} // namespace unprojector::ray
