#pragma once

#include "core/unproject/certainty.h"
#include "core/unproject/depth_sample.h"
#include "core/unproject/unprojector.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace unprojector::unproject {

/// A click in a view.
struct PixelClick {
    geometry::WidgetPoint position; ///< logical pixels, origin top-left
    geometry::DevicePixel pixel;    ///< contains the position
    DepthSample sample;             ///< read at the pixel
};

/// The result of a click: its world point, with all data that led to it.
struct Pick {
    geometry::WidgetPoint widget;
    geometry::DevicePixel devicePixel;
    geometry::WindowPoint window;      ///< the pixel's centre, with the depth as read
    std::optional<std::size_t> object; ///< index in the scene's list of the object hit, at the click; none: background
    geometry::Setup setup;             ///< as it was at the click

    Unprojected point;       ///< of the surface; meaningful on a hit
    Certainty certainty;     ///< of the surface; meaningful on a hit
    Uncertainty uncertainty; ///< the same, of each coordinate; meaningful on a hit
    Uncertainty withinPixel; ///< how far the pixel extends from it; meaningful on a hit
    Unprojected rayNear;     ///< where the ray through the pixel's centre enters the view volume
    Unprojected rayFar;      ///< where that ray leaves it
    DepthSample sample;      ///< as read

    bool hit() const { return object.has_value(); }
};

/// Called with a world point; returns the known properties of the surface drawn there.
using SurfaceAt = std::function<DrawnSurface(const geometry::WorldPoint &)>;

/// The pick of a click: the point at the centre of its pixel, by every method.
/// @param unprojector  of the clicked setup, by parameters
/// @param surfaceAt    decides the point's uncertainty; called on a hit; may be empty
/// @return on a hit the errors of the formulas: DepthOutsideRange, PointAtInfinity
geometry::Result<Pick> pickAt(const Unprojector &unprojector, const PixelClick &click, const SurfaceAt &surfaceAt = {});

/// A pick's point by one method in the space of an object. The formula's world point is not rounded
/// before.
/// @return the errors of the method, of ObjectFromWorld::of and at
geometry::Result<geometry::ObjectPoint> objectPointOf(const Pick &pick, Method method,
                                                      const geometry::PreciseMatrix &worldFromObject);

/// The pick with a ray's data on its surface: the triangle. Changes only the uncertainty of a hit.
Pick refined(Pick pick, const DrawnSurface &surface);

} // namespace unprojector::unproject
