#pragma once

#include "core/unproject/certainty.h"
#include "core/unproject/unprojector.h"

#include <cstddef>
#include <optional>

namespace unprojector::unproject {

/// What the framebuffer says of one pixel.
struct DepthSample {
    double depth = 1.0; ///< in the depth range: as read on a surface, that of the far plane on background
    std::optional<std::size_t> object = {}; ///< whose surface, its place in the scene's list; nothing: background
    int depthBits = 24;                     ///< of the depth buffer

    bool hit() const { return object.has_value(); }
};

/// A click, followed back to the world.
struct Pick {
    WidgetPoint widget;
    DevicePixel devicePixel;
    WindowPoint window;                ///< the pixel's centre, with the depth as read
    std::optional<std::size_t> object; ///< whose surface, its place in the scene's list at the click; none: background
    Picture geometry;                  ///< as it was at the click

    Unprojected point;       ///< of the surface; meaningful on a hit
    Certainty certainty;     ///< of the surface; meaningful on a hit
    Uncertainty uncertainty; ///< the same, of each coordinate; meaningful on a hit
    Unprojected rayNear;     ///< where the ray through the pixel's centre enters the view volume
    Unprojected rayFar;      ///< where it leaves it

    bool hit() const { return object.has_value(); }
};

/// The point under a click: the pixel that the position lies in, its centre, and every method there.
/// @param unprojector  of the picture that was clicked, by parameters
/// @return the errors of devicePixelFromWidget; on a hit those of the formulas: DepthOutsideRange, PointAtInfinity
Result<Pick> pickAt(const Unprojector &unprojector, const WidgetPoint &position, const DepthSample &sample);

} // namespace unprojector::unproject
