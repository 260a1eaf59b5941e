#pragma once

#include "core/scene/scene.h"

#include <vector>

namespace unprojector::scene {

/// The initial projection for models; it follows the viewport and fits the objects.
geometry::Projection openingProjection();

/// The initial camera for models: in front and a little above, as near as they fit into a window of
/// this size.
/// @pre check(surface)
geometry::LookAt openingCamera(const std::vector<SceneObject> &objects, const geometry::Surface &surface);

/// The grid of lines under the objects, world space.
struct Ground {
    geometry::Box box;    ///< flat, at the lowest height of the objects; empty without any
    double spacing = 1.0; ///< between two lines: 1, 2 or 5 times a power of ten
};
Ground groundUnder(const geometry::Box &bounds);

} // namespace unprojector::scene
