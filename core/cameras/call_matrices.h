#pragma once

#include "core/cameras/call_signature.h"
#include "core/geometry/camera.h"
#include "core/geometry/projection.h"
#include "core/geometry/result.h"

#include <glm/mat4x4.hpp>

namespace unprojector::cameras {

/// Returns whether a matrix can be made from the window on the near plane, near and far. Near may lie behind far, as in
/// reversed depth.
/// @return NearNotPositive (of a perspective); LeftEqualsRight; BottomEqualsTop; NearNotBeforeFar
///         where both are the same
geometry::Check check(const geometry::Ortho &volume, bool isPerspective);

/// The matrix of glFrustum or glOrtho, with NDC depths in [0, 1] or an eye that looks along +z if
/// the API has these.
/// @pre check(volume)
glm::dmat4 clipFromEye(const geometry::Ortho &volume, const CallSignature &signature);

/// The matrix of gluLookAt. A left-handed eye looks along +z: it is rotated by 180 degrees about
/// its y axis.
/// @return the errors of eyeFrame
geometry::Result<glm::dmat4> eyeFromWorld(const geometry::LookAt &camera, bool isLeftHanded);

} // namespace unprojector::cameras
