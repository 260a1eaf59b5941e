#pragma once

#include "core/geometry/camera.h"

#include <glm/mat4x4.hpp>

namespace unprojector::geometry {

/// What of a view matrix closed formulas need: that it only turns and moves (it may mirror, too), times any positive number
/// w. Numbers that went through single precision or six printed digits leave the axes up to 2e-6 off; up to 1e-5 counts as
/// rigid. A general inverse leaves w an ulp off 1, and after full pivoting the rest of the last row off 0 by a rounding.
///
/// @param eyeFromWorld  column vectors
/// @return how far the axes are from orthonormal: the largest |entry| of R R^T - 1; NotFinite; ViewNotRigid (other: the place
///         among the 16, column by column; value: in the last row the entry that stands there, on the diagonal how much
///         the row's squared length exceeds 1, elsewhere the product of the two rows)
Result<double> axesOff(const glm::dmat4 &eyeFromWorld);

/// The eye's place and its axes in world space, before they are rounded: a view matrix solved for the world point,
///
///   p = w R^-1 p_eye - R^-1 t,  R^-1 = (r1 x r2, r2 x r0, r0 x r1) / (r0 . r1 x r2)
///
/// with r0, r1, r2 the rows of R. For a rigid matrix these products are the rows themselves; what single precision has put
/// the axes off they take back.
struct PreciseAxes {
    DoubleDouble3 origin, x, y, z; ///< p = origin + x x_eye + y y_eye + z z_eye
};

/// @return the errors of axesOff
Result<PreciseAxes> preciseAxes(const glm::dmat4 &eyeFromWorld);

/// The world point of an eye point by these axes, rounded once.
/// @return the errors of axesOff; PointAtInfinity
Result<WorldPoint> worldFromEye(const glm::dmat4 &eyeFromWorld, const PrecisePoint<EyeSpace> &point);
Result<WorldPoint> worldFromEye(const glm::dmat4 &eyeFromWorld, const EyePoint &point);

/// The arguments of gluLookAt that give this view: the eye, a center so far in front of it, and the matrix's own up.
/// @param distance  > 0, world units
/// @return the errors of axesOff; ViewMirrored, which no gluLookAt gives
Result<LookAt> lookAtFrom(const glm::dmat4 &eyeFromWorld, double distance);

} // namespace unprojector::geometry
