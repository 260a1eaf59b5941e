#pragma once

#include "core/geometry/camera.h"

#include <glm/mat4x4.hpp>

namespace unprojector::geometry {

/// What of a view matrix closed formulas need: that it only turns and moves (it may mirror, too). Numbers that went
/// through single precision leave the axes a few 1e-8 off; up to 1e-5 counts as rigid.
///
/// @param eyeFromWorld  column vectors
/// @return how far the axes are from orthonormal: the largest |entry| of R R^T - 1; NotFinite; ViewNotRigid (value: how
///         far; or, with other = its place among the 16, the entry of the last row that is not 0, 0, 0, 1)
Result<double> axesOff(const glm::dmat4 &eyeFromWorld);

/// The world point of an eye point by the axes in the matrix's rows, no matrix is inverted:
///
///   p = R^T (p_eye - t), then twice p += R^T (p_eye - R p - t)
///
/// which is exact for a rigid matrix, and takes back what single precision has put the axes off.
/// @return the errors of axesOff; PointAtInfinity
Result<WorldPoint> worldFromEye(const glm::dmat4 &eyeFromWorld, const PrecisePoint<EyeSpace> &point);
Result<WorldPoint> worldFromEye(const glm::dmat4 &eyeFromWorld, const EyePoint &point);

/// The arguments of gluLookAt that give this view: the eye, a center so far in front of it, and the matrix's own up.
/// @param distance  > 0, world units
/// @return the errors of axesOff; ViewNotRigid for a mirrored view (value: 2), which no gluLookAt gives
Result<LookAt> lookAtFrom(const glm::dmat4 &eyeFromWorld, double distance);

} // namespace unprojector::geometry
