#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/matrix_projection.h"
#include "core/geometry/projection.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

#include <variant>

namespace unprojector::geometry {

/// How eye space becomes clip space: by parameters, or by the matrix of another program.
using Lens = std::variant<Projection, MatrixProjection>;
/// Where the eye is: the arguments of gluLookAt, or eyeFromWorld as another program has it.
using Pose = std::variant<LookAt, glm::dmat4>;

/// How the world is projected to the window, and all that a click needs to be computed again. The window, the command and
/// the tests all use this type. What the window draws is given by parameters (see byParameters).
struct Setup {
    Surface surface;
    Viewport viewport;
    DepthRange depthRange;
    Lens lens;
    Pose pose;

    /// Whether lens and pose are given by parameters.
    bool isByParameters() const;
    /// The parameters. @pre isByParameters()
    const Projection &projection() const;
    Projection &projection();
    const LookAt &camera() const;
    LookAt &camera();

    friend bool operator==(const Setup &, const Setup &) = default;
};

/// @return the first error of check(surface), check(viewport), check(depthRange), of the lens and the pose: check(projection)
///         or NotFinite, eyeFrame(camera) or NotFinite
Check check(const Setup &setup);

/// The NDC depths that the depth range stands for.
NdcDepth ndcDepthOf(const Setup &setup);

/// @return the errors of clipFromEye(Projection); NotFinite of a matrix (other: its place among the 16)
Result<glm::dmat4> clipFromEye(const Setup &setup);
/// @return the errors of eyeFrame; NotFinite of a matrix (other: its place among the 16)
Result<glm::dmat4> eyeFromWorld(const Setup &setup);
/// clipFromEye * eyeFromWorld
/// @return the errors of both
Result<glm::dmat4> clipFromWorld(const Setup &setup);

/// The way forward, see WayForward, rounded once.
/// @return PointAtInfinity where the point lies in the plane of the eye (w = 0); the errors of WayForward::of
Result<WindowPoint> windowFromWorld(const Setup &setup, const WorldPoint &point);

/// The same setup by parameters, for the window: a reversed matrix is one with its depth range turned round, and [0, 1]
/// one with its near plane where it is. A far plane at infinity is put at a million times near, where a depth differs by
/// less than a millionth. A setup that is by parameters already stays as it is.
/// @return the errors of check, recognised and lookAtFrom; MatrixNotAProjection for an eye space that looks along +z
Result<Setup> byParameters(const Setup &setup);

} // namespace unprojector::geometry
