#pragma once

#include "core/geometry/numbers.h"
#include "core/geometry/result.h"
#include "core/geometry/spaces.h"

#include <glm/mat4x4.hpp>

namespace unprojector::geometry {

/// The arguments of gluLookAt, world space.
struct LookAt {
    WorldPoint eye{0.0, 0.0, 5.0};
    WorldPoint center{0.0, 0.0, 0.0};
    WorldVector up{0.0, 1.0, 0.0};
    friend bool operator==(const LookAt &, const LookAt &) = default;
};

/// The eye's position and its orthonormal axes in world space: s points right, u up, f into the
/// scene.
struct EyeFrame {
    WorldPoint eye;
    WorldVector side;
    WorldVector upward;
    WorldVector forward;
};

/// The axes before they are rounded.
struct PreciseEyeFrame {
    WorldPoint eye;
    DoubleDouble3 side, upward, forward;

    EyeFrame rounded() const;
};

/// The axes of gluLookAt:
///
///   f = unit(center - eye), s = unit(f x up), u = s x f
///
/// @return NotFinite; EyeEqualsCenter; UpIsZero; UpParallelToView (up within 1e-10 of the view
///         direction; no user chooses a direction that close)
/// Source: gluLookAt; Weng et al. 2008, section 2.1. Its world x axis points left by mistake; the
///         axis points right.
Result<PreciseEyeFrame> preciseEyeFrame(const LookAt &view);
Result<EyeFrame> eyeFrame(const LookAt &view);

/// The matrix with rows s, u, -f and the translation that moves the eye to the origin.
glm::dmat4 eyeFromWorld(const EyeFrame &frame);

/// The rigid inverse of eyeFromWorld in closed form, without a matrix inversion:
///
///   p = eye + x s + y u + z f,  z = -z_eye
///
/// Near the world's origin the eye and the offset from it cancel, so only the whole sum is rounded.
PrecisePoint<WorldSpace> preciseWorldFromEye(const PreciseEyeFrame &frame, const PrecisePoint<EyeSpace> &point);
WorldPoint worldFromEye(const PreciseEyeFrame &frame, const PrecisePoint<EyeSpace> &point);
WorldPoint worldFromEye(const EyeFrame &frame, const EyePoint &point);

/// The projection direction: dot products with the axes.
EyePoint eyeFromWorld(const EyeFrame &frame, const WorldPoint &point);

} // namespace unprojector::geometry
