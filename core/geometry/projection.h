#pragma once

#include "core/geometry/angle.h"
#include "core/geometry/double_double.h"
#include "core/geometry/result.h"

#include <glm/mat4x4.hpp>

#include <variant>

namespace unprojector::geometry {

/// The arguments of glFrustum: the window [left, right] x [bottom, top] on the plane z_eye = -near, eye units.
/// It may be off-centre, and mirrored (left > right). 0 < near < far.
struct Frustum {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
    friend bool operator==(const Frustum &, const Frustum &) = default;
};

/// The arguments of glOrtho, eye units. near and far are distances in front of the eye; either may be negative.
struct Ortho {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
    friend bool operator==(const Ortho &, const Ortho &) = default;
};

/// The arguments of gluPerspective, with the angle in radians. aspect = width / height.
struct Perspective {
    double verticalFovRadians = radiansFromDegrees(45.0);
    double aspect = 1.0;
    double nearDistance = 1.0, farDistance = 100.0;
    friend bool operator==(const Perspective &, const Perspective &) = default;
};

/// A sheared glOrtho box: x += cot(theta) z_eye, y += cot(phi) z_eye before the box is normalised. An angle of
/// pi/2 leaves its axis unsheared.
struct Oblique {
    Ortho box;
    double thetaRadians = radiansFromDegrees(90.0);
    double phiRadians = radiansFromDegrees(90.0);
    friend bool operator==(const Oblique &, const Oblique &) = default;
};

using Projection = std::variant<Frustum, Ortho, Perspective, Oblique>;

/// What is wrong with the parameters: NotFinite; LeftEqualsRight; BottomEqualsTop; NearNotPositive (frustum and
/// perspective); NearNotBeforeFar; FieldOfViewOutOfRange; AspectNotPositive; ShearAngleOutOfRange.
Check check(const Projection &projection);

/// The symmetric frustum of gluPerspective: top = n tan(fovy/2), right = top * aspect. The tangent is our own, so that
/// the digits do not depend on the system's library.
Frustum frustumFromPerspective(const Perspective &perspective);

/// The window and clip distances that a projection uses on its near plane. For Oblique it is the unsheared box.
/// Whether it is a frustum or a box is told by `isPerspective`.
struct ProjectionWindow {
    double left, right, bottom, top, nearDistance, farDistance;
};
ProjectionWindow projectionWindow(const Projection &projection);
/// The edges of that window before they are rounded: a perspective's hang on a tangent.
struct PreciseEdges {
    DoubleDouble left, right, bottom, top;
};
PreciseEdges preciseEdges(const Projection &projection);
bool isPerspective(const Projection &projection);

/// The projection matrix as glFrustum, glOrtho and gluPerspective make it; for Oblique ortho * shear.
/// The third row of the frustum is (0, 0, -(f+n)/(f-n), -2fn/(f-n)).
/// @return the errors of `check`
/// Source: OpenGL 2.1 reference; `parallel-projection` for the shear. (The zhangci tutorial prints the ortho
///         matrix with a garbled third row.)
Result<glm::dmat4> clipFromEye(const Projection &projection);

enum class ProjectionKind { Frustum, Perspective, Ortho, Oblique };
ProjectionKind kindOf(const Projection &projection);

/// The projection of another kind whose picture is as close as it can be: a frustum and a perspective exchange exactly
/// (an off-centre frustum is centred, with its height); between frustum and box, and where a shear is dropped, what lies
/// at `distance` in front of the eye keeps its place. The angles of a new oblique are 45 degrees, so that
/// the shear is seen.
/// @param distance  > 0, eye units
/// @pre the projection is valid
Projection converted(const Projection &projection, ProjectionKind kind, double distance);

/// The angle that radians stand for. Angles are given in degrees: where such of at most 12 digits give these radians, it is theirs
/// before they were rounded, which the tangent of a field of view of 179 degrees would magnify a hundredfold; else it is what
/// the double says.
DoubleDouble preciseRadians(double radians);

/// cot, exactly 0 at pi/2: an unsheared axis of an oblique projection stays unsheared.
DoubleDouble preciseCotangent(double radians);
double cotangent(double radians);

/// The same projection for a viewport of another aspect (width / height), so that a circle stays a circle: bottom
/// and top stay; a frustum's left and right are scaled, which keeps the view axis at the same share of the width;
/// a box is widened about its centre.
/// @pre the projection is valid and aspect > 0
Projection withAspect(const Projection &projection, double aspect);

/// The same picture with other clip distances: a frustum's window is scaled along with its near plane.
/// @pre 0 < nearDistance < farDistance where the projection is a perspective
Projection withClipDistances(const Projection &projection, double nearDistance, double farDistance);

} // namespace unprojector::geometry
