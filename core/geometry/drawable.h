#pragma once

#include "core/geometry/setup.h"

#include <cstdint>

namespace unprojector::geometry {

/// The limit of glViewport on current graphics cards. Beyond its own limit a driver silently clamps
/// sizes.
constexpr int kMostDrawnPixels = 16384;

/// A setup's viewport and depth range as the exact integers and floats that OpenGL takes. Views
/// draw only from these. Clicks on them are unprojected with `setup`, which holds the same numbers
/// in doubles, so nothing is rounded in between. The matrix, which shaders take in single
/// precision, is rounded once per object.
struct Drawable {
    Setup setup;                                      ///< its depth range is the one set in OpenGL
    std::int32_t x = 0, y = 0, width = 0, height = 0; ///< glViewport
    float depthAtNear = 0.0f,
          depthAtFar = 1.0f; ///< glDepthRangef; the depth buffer is cleared to the far plane's value
};

/// The numbers with which OpenGL draws a setup. A depth range is rounded to single precision, the
/// only one that OpenGL takes. A number that OpenGL would change further or silently clamp is an
/// error.
/// @return the errors of check(setup); FramebufferTooLarge; ViewportNotWhole; ViewportTooLarge;
///         DepthRangeNotDrawable (an end below 0 or above 1); EmptyDepthRange (both ends are equal
///         in single precision)
Result<Drawable> drawable(const Setup &setup);

/// Checks whether OpenGL takes a viewport number unchanged.
/// @return NotFinite; ViewportNotWhole; ViewportTooLarge
Check checkViewportNumber(double pixels);
/// Checks whether OpenGL takes an end of a depth range.
/// @return NotFinite; DepthRangeNotDrawable
Check checkDepthRangeEnd(double depth);

} // namespace unprojector::geometry
