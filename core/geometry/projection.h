#pragma once

#include "core/geometry/numbers.h"
#include "core/geometry/result.h"

#include <glm/mat4x4.hpp>

#include <variant>

namespace unprojector::geometry {

/// The arguments of glFrustum: the window [left, right] x [bottom, top] on the plane z_eye = -near,
/// eye units. It may be off-centre, and mirrored (left > right). 0 < near < far. A skew shears eye
/// space before glFrustum: x_eye is replaced by x_eye + skew y_eye, as by the skew of a camera
/// matrix.
struct Frustum {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
    double skew = 0.0;
    friend bool operator==(const Frustum &, const Frustum &) = default;
};

/// The arguments of glOrtho, eye units. near and far are distances in front of the eye; either may
/// be negative.
struct Ortho {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
    friend bool operator==(const Ortho &, const Ortho &) = default;
};

/// The arguments of gluPerspective. aspect = width / height; a viewport's need not be a double.
struct Perspective {
    Angle verticalFov = Angle::fromDegrees(45.0);
    DoubleDouble aspect = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
    friend bool operator==(const Perspective &, const Perspective &) = default;
};

/// A sheared glOrtho box: x += cot(theta) z_eye, y += cot(phi) z_eye before the box is normalised.
/// An angle of pi/2 leaves its axis unsheared.
struct Oblique {
    Ortho box;
    Angle theta = Angle::fromDegrees(90.0);
    Angle phi = Angle::fromDegrees(90.0);
    friend bool operator==(const Oblique &, const Oblique &) = default;
};

/// A frustum given by a camera matrix K and the size of its image in pixels, counted from the
/// top-left corner: x = fx X / Z + skew Y / Z + cx, y = fy Y / Z + cy, with X right, Y down, Z
/// ahead. fx and fy are not 0; a negative one mirrors. 0 < near < far.
///
///   left = -n cx' / fx,  right = n (width - cx') / fx,  bottom = -n (height - cy') / fy,
///   top = n cy' / fy,  skew of the frustum = -skew / fx;  cx', cy' count from the image's corner
struct Pinhole {
    double fx = 1.0, fy = 1.0, cx = 0.0, cy = 0.0, skew = 0.0;
    double width = 1.0, height = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
    /// The centre of the first pixel has the coordinates 0, as in OpenCV; otherwise ½.
    bool areCentersWhole = false;
    friend bool operator==(const Pinhole &, const Pinhole &) = default;
};

using Projection = std::variant<Frustum, Ortho, Perspective, Oblique, Pinhole>;

/// Checks the parameters.
/// @return NotFinite; FocalLengthIsZero; EmptyImage; LeftEqualsRight; BottomEqualsTop; NearNotPositive (all but boxes);
///         NearNotBeforeFar; FieldOfViewOutOfRange; AspectNotPositive; ShearAngleOutOfRange
Check check(const Projection &projection);

/// The symmetric frustum of gluPerspective: top = n tan(fovy/2), right = top * aspect. The program
/// computes the tangent itself, so the digits do not depend on the system's library.
Frustum frustumFromPerspective(const Perspective &perspective);

/// The edges and the skew of a pinhole, rounded.
Frustum frustumFromPinhole(const Pinhole &pinhole);

/// The window on the near plane and the clip distances of a projection. For Oblique it is the
/// unsheared box. `isPerspective` distinguishes a frustum from a box. skew is a frustum's: the
/// window is that of x_eye + skew y_eye.
struct ProjectionWindow {
    double left, right, bottom, top, nearDistance, farDistance;
    double skew = 0.0;
};
ProjectionWindow projectionWindow(const Projection &projection);
/// The edges of that window and its skew before rounding: a perspective's edges depend on a
/// tangent, a pinhole's on quotients.
struct PreciseEdges {
    DoubleDouble left, right, bottom, top, skew;
};
PreciseEdges preciseEdges(const Projection &projection);
bool isPerspective(const Projection &projection);

/// The projection matrix as glFrustum, glOrtho and gluPerspective build it; for Oblique and for a
/// frustum with a skew times the shear; for a pinhole by its own numbers. The third row of the frustum is (0, 0,
/// -(f+n)/(f-n), -2fn/(f-n)).
/// @return the errors of `check`
/// Source: OpenGL 2.1 reference; `parallel-projection` for the shear. (The zhangci tutorial prints
///         the ortho matrix with a garbled third row.)
Result<glm::dmat4> clipFromEye(const Projection &projection);

/// A pinhole is a frustum.
enum class ProjectionKind { Frustum, Perspective, Ortho, Oblique };
ProjectionKind kindOf(const Projection &projection);

/// The projection of another kind whose view is as similar as possible. A frustum and a perspective
/// convert exactly (an off-centre frustum is centred and keeps its height; only frustums keep a
/// skew). Between frustum and
/// box, and where a shear is dropped, points at `distance` in front of the eye keep their position
/// in the view. A new oblique gets angles of 45 degrees, so that the shear is visible.
/// @param distance  > 0, eye units
/// @pre the projection is valid
Projection converted(const Projection &projection, ProjectionKind kind, double distance);

/// The cotangent, exactly 0 at pi/2: an unsheared axis of an oblique projection stays unsheared.
DoubleDouble preciseCotangent(const Angle &angle);
double cotangent(const Angle &angle);

/// The projection for a viewport of another aspect (width / height); circles stay circles. bottom
/// and top stay. A frustum's left and right are multiplied by one factor, so their ratio stays. A
/// box becomes wider or narrower about its centre.
/// @pre the projection is valid and aspect > 0
Projection withAspect(const Projection &projection, const DoubleDouble &aspect);

/// The same view with other clip distances: a frustum's window is scaled with its near plane.
/// @pre 0 < nearDistance < farDistance if the projection is a perspective
Projection withClipDistances(const Projection &projection, double nearDistance, double farDistance);

} // namespace unprojector::geometry
