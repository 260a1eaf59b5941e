#pragma once

#include "core/unproject/certainty.h"
#include "core/unproject/depth_sample.h"
#include "core/unproject/unprojector.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace unprojector::unproject {

/// A click as a view takes it.
struct PixelClick {
    geometry::WidgetPoint position; ///< logical pixels, origin top-left
    geometry::DevicePixel pixel;    ///< that the position lies in
    DepthSample sample;             ///< what was read there
};

/// A click, followed back to the world.
struct Pick {
    geometry::WidgetPoint widget;
    geometry::DevicePixel devicePixel;
    geometry::WindowPoint window;      ///< the pixel's centre, with the depth as read
    std::optional<std::size_t> object; ///< whose surface, its place in the scene's list at the click; none: background
    geometry::Setup setup;             ///< as it was at the click

    Unprojected point;       ///< of the surface; meaningful on a hit
    Certainty certainty;     ///< of the surface; meaningful on a hit
    Uncertainty uncertainty; ///< the same, of each coordinate; meaningful on a hit
    Uncertainty withinPixel; ///< how far from it the pixel reaches; meaningful on a hit
    Unprojected rayNear;     ///< where the ray through the pixel's centre enters the view volume
    Unprojected rayFar;      ///< where it leaves it
    DepthSample sample;      ///< what was read

    bool hit() const { return object.has_value(); }
};

/// Returns what is known of the surface that was drawn at a world point.
using SurfaceAt = std::function<DrawnSurface(const geometry::WorldPoint &)>;

/// The point under a click: the centre of its pixel, and every method there.
/// @param unprojector  of the picture that was clicked, by parameters
/// @param surfaceAt    decides the point's uncertainty; called on a hit; may be empty
/// @return on a hit the errors of the formulas: DepthOutsideRange, PointAtInfinity
geometry::Result<Pick> pickAt(const Unprojector &unprojector, const PixelClick &click, const SurfaceAt &surfaceAt = {});

/// The same pick with what a ray tells of its surface: the triangle. Changes the uncertainty of a hit, and nothing else.
Pick refined(Pick pick, const DrawnSurface &surface);

} // namespace unprojector::unproject
