#pragma once

#include "core/unproject/comparison.h"

#include <cstddef>
#include <optional>

namespace unprojector::unproject {

/// What the framebuffer says of one pixel.
struct DepthSample {
    double depth = 1.0; ///< in the depth range: as read on a surface, that of the far plane on background
    bool hit = false;   ///< a surface was drawn there; false: background
    int depthBits = 24; ///< of the depth buffer
    std::optional<std::size_t> object = {}; ///< whose surface, its place in the scene's list
};

/// A click, followed back to the world.
struct Pick {
    WidgetPoint widget;
    DevicePixel devicePixel;
    WindowPoint window; ///< the pixel's centre, with the depth as read
    bool hit = false;
    std::optional<std::size_t> object; ///< whose surface was hit, its place in the scene's list at the click
    ViewGeometry geometry;             ///< as it was at the click

    Comparison point;    ///< of the surface; meaningful when `hit`
    Certainty certainty; ///< of the surface; meaningful when `hit`
    Comparison rayNear;  ///< where the ray through the pixel's centre enters the view volume
    Comparison rayFar;   ///< where it leaves it
};

/// The point under a click: the pixel that the position lies in, its centre, and both methods there.
/// @return the errors of check(geometry) and devicePixelFromWidget; DepthOutsideRange when `sample.hit`
Result<Pick> pickAt(const ViewGeometry &geometry, const WidgetPoint &position, const DepthSample &sample);

} // namespace unprojector::unproject
