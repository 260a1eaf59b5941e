#pragma once

#include "core/geometry/setup.h"

#include <cstdint>

namespace unprojector::geometry {

/// glViewport's limit on the graphics cards of today; beyond its own a driver cuts sizes silently.
constexpr int kMostDrawnPixels = 16384;

/// The very integers and floats that OpenGL takes of a picture's viewport and depth range. Views draw from nothing else, and
/// clicks on them are unprojected with `setup`, which says the same in doubles: nothing is rounded between the two. The
/// matrix, which shaders take in single precision, is rounded once for each object.
struct Drawable {
    Setup setup;                                      ///< its depth range is the one that OpenGL has
    std::int32_t x = 0, y = 0, width = 0, height = 0; ///< glViewport
    float depthAtNear = 0.0f,
          depthAtFar = 1.0f; ///< glDepthRangef; the depth buffer is cleared to that of the far plane
};

/// What OpenGL will draw of a picture. A depth range is rounded to single precision, which is all that OpenGL takes; what
/// it would change by more, or cut without a word, is refused.
/// @return the errors of check(setup); FramebufferTooLarge; ViewportNotWhole; ViewportTooLarge; DepthRangeNotDrawable (an
///         end below 0 or above 1); EmptyDepthRange (two ends that are one in single precision)
Result<Drawable> drawable(const Setup &setup);

/// Whether OpenGL takes a number of a viewport as it is.
/// @return NotFinite; ViewportNotWhole; ViewportTooLarge
Check checkViewportNumber(double pixels);
/// Whether OpenGL takes an end of a depth range.
/// @return NotFinite; DepthRangeNotDrawable
Check checkDepthRangeEnd(double depth);

} // namespace unprojector::geometry
