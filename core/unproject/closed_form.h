#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projection.h"
#include "core/geometry/viewport.h"

namespace unprojector::unproject {

/// Eye-space point under a window position: no matrix is inverted. This is what a click, a row and a table compute.
///
/// Frustum; a Perspective is taken as its frustum, the edges not rounded:
///
///   x = (x_v - vx) (r - l) z / (width n) + l z / n        (9) with (7) x_v = px
///   y = (y_v - vy) (t - b) z / (height n) + b z / n       (10) with (8) y_v = rect.bottom - py
///   z = n f / (f (1 - d) + n d),  z_eye = -z
///
/// Orthographic box:
///
///   x = (x_v - vx) (r - l) / width + l                    (11)
///   y = (y_v - vy) (t - b) / height + b                   (12)
///   z = n (1 - d) + f d,  z_eye = -z
///
/// Oblique: (11) and (12), then the shear undone: x += cot(theta) z, y += cot(phi) z with z the distance in front of the
/// eye.
///
/// Evaluated with z / n taken out, ((x_v - vx) (r - l) / width + l) z / n, and with 32 digits: the two terms of (9) and
/// of (10) cancel near the view axis. The usual way to write the distance, n f / (f - d (f - n)), cancels near the far plane
/// and loses seven digits at n : f = 0.01 : 10^6; this one does not. Not rounded yet, for going on to world space: near the world's origin the digits of
/// the eye cancel, and what an eye coordinate in double has dropped would be all that is left.
/// @param window  device pixels, origin bottom-left, inside the viewport or not; depth in the depth range
/// @return the errors of check(projection), check(viewport), unitDepth; NotFinite for a NaN or infinite position;
///         PointAtInfinity, when the numbers leave the range of doubles
/// Source: Weng et al. 2008, section 3. The paper leaves the sign of z open: it holds for the distance in front of
///         the eye. It calls the result view-volume coordinates: they are eye coordinates. For a box it gives x and y only.
geometry::Result<geometry::PrecisePoint<geometry::EyeSpace>> preciseEyePoint(const geometry::Projection &projection,
                                                                             const geometry::Viewport &viewport,
                                                                             const geometry::DepthRange &range,
                                                                             const geometry::WindowPoint &window);

} // namespace unprojector::unproject
