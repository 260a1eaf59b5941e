#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/result.h"
#include "core/matrices/call_signature.h"

#include <glm/mat4x4.hpp>

namespace unprojector::matrices {

/// The window on the near plane, and the near and far distance.
struct CallVolume {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0, nearDistance = -1.0, farDistance = 1.0;
};

/// Returns whether a matrix can be made from the volume. Near may lie behind far, as in reversed
/// depth.
/// @return NearNotPositive (of a perspective); LeftEqualsRight; BottomEqualsTop; NearNotBeforeFar
///         where both are the same
geometry::Check check(const CallVolume &volume, bool isPerspective);

/// The matrix of glFrustum or glOrtho, with NDC depths in [0, 1] or an eye that looks along +z if
/// the API has these.
/// @pre check(volume)
glm::dmat4 clipFromEye(const CallVolume &volume, const CallSignature &signature);

/// The matrix of gluLookAt. A left-handed eye looks along +z: it is rotated by 180 degrees about
/// its y axis.
/// @return the errors of eyeFrame
geometry::Result<glm::dmat4> eyeFromWorld(const geometry::LookAt &camera, bool isLeftHanded);

} // namespace unprojector::matrices
