#pragma once

#include "core/unproject/certainty.h"
#include "core/unproject/depth_sample.h"
#include "core/unproject/unprojector.h"

#include <cstddef>
#include <optional>

namespace unprojector::unproject {

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
    Uncertainty withinPixel; ///< how far from it the pixel reaches; meaningful on a hit
    Unprojected rayNear;     ///< where the ray through the pixel's centre enters the view volume
    Unprojected rayFar;      ///< where it leaves it
    DepthSample sample;      ///< what was read

    bool hit() const { return object.has_value(); }
};

/// The point under a click: the pixel that the position lies in, its centre, and every method there.
/// @param unprojector  of the picture that was clicked, by parameters
/// @param surface  what is known of the surface, for how sure the point is
/// @return the errors of devicePixelFromWidget; on a hit those of the formulas: DepthOutsideRange, PointAtInfinity
Result<Pick> pickAt(const Unprojector &unprojector, const WidgetPoint &position, const DepthSample &sample,
                    const DrawnSurface &surface = {});

/// The same click when more has become known of its surface: the triangle, once somebody has asked for what its ray meets.
/// Only how sure the point is changes; of a pick that is no hit nothing does.
Pick withSurface(Pick pick, const DrawnSurface &surface);

} // namespace unprojector::unproject
