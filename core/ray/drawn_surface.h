#pragma once

#include "core/ray/scene_hit.h"
#include "core/scene/scene.h"
#include "core/unproject/depth_error.h"

namespace unprojector::ray {

/// The surface under a pixel, with only the object known: the space of its vertices. If its meshes
/// have different origins, the mesh whose origin is nearest to the point is used.
/// @param point  on the surface, or nearly
unproject::DrawnSurface drawnSurface(const scene::SceneObject &object, const geometry::WorldPoint &point);

/// The surface under a pixel whose centre's ray hits the object: also its triangle, or its point.
/// @pre the hit is on the object's model
unproject::DrawnSurface drawnSurface(const scene::SceneObject &object, const SceneHit &hit);

} // namespace unprojector::ray
