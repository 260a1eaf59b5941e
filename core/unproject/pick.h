#pragma once

#include "core/unproject/comparison.h"

namespace unprojector::unproject {

/// What the framebuffer says of one pixel.
struct DepthSample {
    double depth = 1.0; ///< as read, in the depth range
    bool hit = false;   ///< a surface was drawn there; false: background, the depth is the one it was cleared to
    int depthBits = 24; ///< of the depth buffer
};

/// A click, followed back to the world.
struct Pick {
    WidgetPoint widget;
    DevicePixel devicePixel;
    WindowPoint window; ///< the pixel's centre, with the depth as read
    bool hit = false;
    ViewGeometry geometry; ///< as it was at the click

    Comparison point;    ///< of the surface; meaningful when `hit`
    Certainty certainty; ///< of the surface; meaningful when `hit`
    Comparison rayNear;  ///< where the ray through the pixel's centre enters the view volume
    Comparison rayFar;   ///< where it leaves it
};

/// The point under a click: the pixel that the position lies in, its centre, and both methods there.
/// @return the errors of check(geometry) and devicePixelFromWidget; DepthOutsideRange when `sample.hit`
Result<Pick> pickAt(const ViewGeometry &geometry, const WidgetPoint &position, const DepthSample &sample);

} // namespace unprojector::unproject
