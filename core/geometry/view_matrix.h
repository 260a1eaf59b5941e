#pragma once

#include "core/geometry/camera.h"

#include <glm/mat4x4.hpp>

namespace unprojector::geometry {

/// Checks that a view matrix is rigid, which closed formulas need: it may rotate, translate and
/// mirror, times any positive number w. Single precision or six printed digits put the axes up to
/// 2e-6 off; up to 1e-5 counts as rigid. A general inverse puts w an ulp off 1. After full pivoting
/// the rest of the last row is off 0 by a rounding error.
///
/// @param eyeFromWorld  column vectors
/// @return deviation of the axes from orthonormal: the largest |entry| of R R^T - 1; NotFinite;
///         ViewNotRigid. For ViewNotRigid, other is the index among the 16, column by column. value
///         is, in the last row, that entry; on the diagonal, the row's squared length minus 1;
///         elsewhere, the product of the two rows
Result<double> axesOff(const glm::dmat4 &eyeFromWorld);

/// The eye's position and axes in world space, before rounding: a view matrix solved for the world
/// point,
///
///   p = w R^-1 p_eye - R^-1 t,  R^-1 = (r1 x r2, r2 x r0, r0 x r1) / (r0 . r1 x r2)
///
/// with r0, r1, r2 the rows of R. For a rigid matrix these products are the rows themselves.
/// Otherwise they correct the error that single precision has added to the axes.
struct PreciseAxes {
    DoubleDouble3 origin, x, y, z; ///< p = origin + x x_eye + y y_eye + z z_eye
};

/// @return the errors of axesOff
Result<PreciseAxes> preciseAxes(const glm::dmat4 &eyeFromWorld);

/// The world point of an eye point by these axes.
/// @return the errors of axesOff; PointAtInfinity
Result<PrecisePoint<WorldSpace>> preciseWorldFromEye(const glm::dmat4 &eyeFromWorld,
                                                     const PrecisePoint<EyeSpace> &point);
/// The same rounded once.
Result<WorldPoint> worldFromEye(const glm::dmat4 &eyeFromWorld, const PrecisePoint<EyeSpace> &point);
/// The arguments of gluLookAt that give this view: the eye, a center at `distance` in front of it,
/// and the matrix's own up.
/// @param distance  > 0, world units
/// @return the errors of axesOff; ViewMirrored, which no gluLookAt gives
Result<LookAt> lookAtFrom(const glm::dmat4 &eyeFromWorld, double distance);

} // namespace unprojector::geometry
