#pragma once

#include "core/scene/scene.h"

#include <vector>

namespace unprojector::scene {

/// The projection that models are shown with at first; it follows the viewport and fits the objects.
geometry::Projection openingProjection();

/// The camera that models are shown with at first: in front and a little above, as near as they fit into a window of this size.
/// @pre check(surface)
geometry::LookAt openingCamera(const std::vector<SceneObject> &objects, const geometry::Surface &surface);

/// The square of lines that objects stand on, world space.
struct Ground {
    geometry::Box box;    ///< flat, at the objects' lowest height; empty without any
    double spacing = 1.0; ///< of two lines: 1, 2 or 5 times a power of ten
};
Ground groundUnder(const geometry::Box &bounds);

} // namespace unprojector::scene
