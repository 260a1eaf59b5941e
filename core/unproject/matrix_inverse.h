#pragma once

#include "core/geometry/result.h"
#include "core/geometry/spaces.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

namespace unprojector::unproject {
using namespace geometry;

/// gluUnProject's way: p = M^-1 (x_n, y_n, z_n, 1), divided by its w, with M inverted by glm::inverse.
///
/// The space of the result is the source space of the matrix given: clipFromEye gives eye coordinates,
/// clipFromWorld world coordinates, clipFromObject object coordinates.
///
/// @tparam Scalar double, or float to see what programs lose that do all of it in single precision
/// @param window  device pixels, origin bottom-left; depth in the depth range (not required to be inside it:
///                a matrix does not care)
/// @param ndcDepth  what the ends of the depth range stand for; with [0, 1] z_n keeps the digits of a small depth
/// @return NotFinite (position, depth or an entry of the matrix); the errors of check(viewport) and check(range);
///         SingularMatrix; PointAtInfinity
/// Source: gluUnProject, OpenGL 2.1 reference. MVPW^-1 (x_w, y_w, d, 1) with the viewport's inverse taken first.
template <class Space, class Scalar = double>
Result<Point<Space>> unprojectByInverse(const glm::dmat4 &clipFromSpace, const Viewport &viewport,
                                        const DepthRange &range, const WindowPoint &window,
                                        NdcDepth ndcDepth = NdcDepth::MinusOneToOne);

} // namespace unprojector::unproject
