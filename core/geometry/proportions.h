#pragma once

#include "core/geometry/setup.h"

#include <glm/vec2.hpp>

namespace unprojector::geometry {

/// A window position as shares of the viewport and, equally, of the projection window.
struct Proportions {
    glm::dvec2 share; ///< of the viewport's width and height, 0 at the left and bottom edge; beyond [0, 1] outside it
    glm::dvec2 position; ///< x_w and y_w in [left, right] x [bottom, top], eye units; for a frustum on its near plane
};

/// The position by equal shares on both sides:
///
///   (x_w - left) / (right - left) = (x_v - vx) / width          (3)
///   (y_w - bottom) / (top - bottom) = (y_v - vy) / height       (4)
///
/// @param window  device pixels, origin bottom-left; its depth is not used
/// @pre the setup is valid
/// Source: Weng et al. 2008, section 2.2. An oblique projection's x_w and y_w belong to the sheared
///         box.
Proportions proportions(const Setup &setup, const WindowPoint &window);

/// The ratio of width to height with which a circle parallel to the projection plane is drawn:
///
///   (width / |right - left|) / (height / |top - bottom|)
///
/// 1 where the projection window has the viewport's aspect. Pixels are assumed square.
/// @pre the setup is valid
double circleAspect(const Setup &setup);

/// Width and height of a pixel at a distance: (r-l) z / (n width) by (t-b) z / (n height) in a
/// perspective, (r-l) / width by (t-b) / height in a box.
/// @param distance  z > 0 in front of the eye (any z for a box), eye units
/// @return world units
/// @pre the setup is valid and by parameters
glm::dvec2 pixelFootprint(const Setup &setup, double distance);

} // namespace unprojector::geometry
