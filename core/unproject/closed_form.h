#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projection.h"
#include "core/geometry/viewport.h"

namespace unprojector::unproject {

/// The eye-space point under a window position, without inverting a matrix. Clicks, batch rows and
/// tables use this computation.
///
/// Frustum; a Perspective and a Pinhole are converted to their frustum without rounding the edges:
///
///   x = (x_v - vx) (r - l) z / (width n) + l z / n        (9) with (7) x_v = px
///   y = (y_v - vy) (t - b) z / (height n) + b z / n       (10) with (8) y_v = rect.bottom - py
///   z = n f / (f (1 - d) + n d),  z_eye = -z
///   with a skew, then x -= skew y
///
/// Orthographic box:
///
///   x = (x_v - vx) (r - l) / width + l                    (11)
///   y = (y_v - vy) (t - b) / height + b                   (12)
///   z = n (1 - d) + f d,  z_eye = -z
///
/// Oblique: (11) and (12), then the inverse shear: x += cot(theta) z, y += cot(phi) z with z the
/// distance in front of the eye.
///
/// Evaluated with z / n factored out, ((x_v - vx) (r - l) / width + l) z / n, and with 32 digits:
/// the two terms of (9) and of (10) cancel near the view axis. The usual formula for the distance,
/// n f / (f - d (f - n)), cancels near the far plane and loses seven digits at n : f = 0.01 : 10^6;
/// this one does not. The result is not rounded yet, so that it can be converted to world space.
/// Near the world's origin the digits of the eye cancel, and only the digits beyond a double would
/// be left.
/// @param window  device pixels, origin bottom-left, inside the viewport or not; depth in the depth
///         range
/// @return the errors of check(projection), check(viewport), unitDepth; NotFinite for a NaN or
///         infinite position; PointAtInfinity if the numbers leave the range of doubles
/// Source: Weng et al. 2008, section 3. The paper leaves the sign of z open: it holds for the
/// distance in front of the eye. It calls the result view-volume coordinates: they are eye
/// coordinates. For a box it gives x and y only.
geometry::Result<geometry::PrecisePoint<geometry::EyeSpace>>
preciseEyePoint(const geometry::Projection &projection, const geometry::Viewport &viewport,
                const geometry::DepthRange &range, const geometry::PrecisePoint<geometry::WindowSpace> &window);

} // namespace unprojector::unproject
