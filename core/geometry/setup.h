#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/matrix_projection.h"
#include "core/geometry/projection.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

#include <variant>

namespace unprojector::geometry {

/// The transform from eye space to clip space: by parameters, or by another program's matrix.
using Lens = std::variant<Projection, MatrixProjection>;
/// The pose of the eye: the arguments of gluLookAt, or another program's eyeFromWorld.
using Pose = std::variant<LookAt, glm::dmat4>;

/// All that maps the world to the window, and all that repeating a click's computation needs. The
/// window, the command and the tests all use this type. The window draws only setups by parameters
/// (see byParameters).
struct Setup {
    Surface surface;
    Viewport viewport;
    DepthRange depthRange;
    Lens lens;
    Pose pose;

    /// True if lens and pose are given by parameters.
    bool isByParameters() const;
    /// The parameters. @pre isByParameters()
    const Projection &projection() const;
    Projection &projection();
    const LookAt &camera() const;
    LookAt &camera();

    friend bool operator==(const Setup &, const Setup &) = default;
};

/// Checks the surface, the viewport, the depth range, the lens and the pose.
/// @return the first error of check(surface), check(viewport), check(depthRange), of the lens and
///         the pose: check(projection) or NotFinite, eyeFrame(camera) or NotFinite
Check check(const Setup &setup);

/// Returns whether a projection is a perspective with exactly the viewport's aspect, unrounded.
bool hasAspectOf(const Projection &projection, const Viewport &viewport);

/// The NDC depths that the depth range maps to.
NdcDepth ndcDepthOf(const Setup &setup);

/// @return the errors of clipFromEye(Projection); NotFinite for a matrix (other: its index among
///         the 16)
Result<glm::dmat4> clipFromEye(const Setup &setup);
/// @return the errors of eyeFrame; NotFinite for a matrix (other: its index among the 16)
Result<glm::dmat4> eyeFromWorld(const Setup &setup);
/// The product clipFromEye * eyeFromWorld.
/// @return the errors of both
Result<glm::dmat4> clipFromWorld(const Setup &setup);

/// The projection of a point to the window, see WayForward, rounded once.
/// @return PointAtInfinity where the point lies in the plane of the eye (w = 0); the errors of
///         WayForward::of
Result<WindowPoint> windowFromWorld(const Setup &setup, const WorldPoint &point);

/// The same setup by parameters, for the window. A reversed matrix becomes one with a swapped depth
/// range; [0, 1] becomes one with its near plane in the same position. A far plane at infinity is
/// put at a million times near, which changes a depth by less than a millionth. A setup that is
/// already by parameters stays unchanged.
/// @return the errors of check, recognised and lookAtFrom; MatrixNotAProjection for an eye space
///         that looks along +z
Result<Setup> byParameters(const Setup &setup);

} // namespace unprojector::geometry
