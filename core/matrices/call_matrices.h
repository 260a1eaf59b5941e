#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/result.h"
#include "core/matrices/call_signature.h"

#include <glm/mat4x4.hpp>

namespace unprojector::matrices {

/// The window on the plane of near, and how far it is seen.
struct CallVolume {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0, nearDistance = -1.0, farDistance = 1.0;
};

/// Whether a matrix can be made of it: near may be behind far, as reversed depths have it.
/// @return NearNotPositive (of a perspective); LeftEqualsRight; BottomEqualsTop; NearNotBeforeFar where both are the same
geometry::Check check(const CallVolume &volume, bool isPerspective);

/// glFrustum's or glOrtho's matrix; with depths in [0, 1], and looking along +z, where the API has these.
/// @pre check(volume)
glm::dmat4 clipFromEye(const CallVolume &volume, const CallSignature &signature);

/// gluLookAt's matrix. A left-handed eye looks along +z: it is turned half round about its y axis.
/// @return the errors of eyeFrame
geometry::Result<glm::dmat4> eyeFromWorld(const geometry::LookAt &camera, bool isLeftHanded);

} // namespace unprojector::matrices
