#pragma once

#include "core/geometry/projection.h"
#include "core/geometry/spaces.h"

#include <array>
#include <optional>

namespace unprojector::geometry {

/// The corners of the view volume, eye space. In the index, bit 0 means right (else left), bit 1
/// top (else bottom), bit 2 far plane (else near plane: the projection window). The projection's
/// arguments use the same names.
/// @pre the projection is valid
std::array<EyePoint, 8> viewVolumeCorners(const Projection &projection);

/// The morph from the view volume in eye space (t = 0) to the canonical view volume (t = 1), for a
/// view from outside.
///
/// Both ends are homogeneous matrices, and so is every step between them:
///
///   M(t) = (1 - t) k S + t D clipFromEye
///
///   S  a similarity: moves the volume's centre to the origin, its corners into the ball about the
///      cube [-1, 1]^3
///   D  diag(1, 1, -1, 1): NDC with z drawn backwards; x or y is negated too where the window is
///      mirrored
///   k  the weight of S: sqrt(near far) in a perspective, 1 in a box
///
/// NDC is left-handed and eye space right-handed. Without D the volume would turn inside out and be
/// flat at some t. D keeps the orientation, so the determinant is above 0 throughout. At t = 1 a
/// view must therefore draw its z axis away from the eye, where NDC's z grows.
///
/// A homogeneous matrix keeps straight lines straight. w = (1 - t) k + t w_clip is above 0 in the
/// whole volume. Each point lies on the line from its position at t = 0 to that at t = 1, so it
/// never leaves the ball. The eye of a perspective recedes to infinity as t goes to 1: the rays
/// through the window become parallel.
struct ViewVolumeMorph {
    glm::dmat4 unitFromEye;    ///< S
    glm::dmat4 morphedFromNdc; ///< D
    glm::dmat4 clipFromEye;
    double weight;   ///< k
    EyePoint center; ///< the point that S moves to the origin
    double scale;    ///< scale of S
};

/// @return the errors of clipFromEye
Result<ViewVolumeMorph> viewVolumeMorph(const Projection &projection);

/// M(t); divide by w.
/// @param t  in [0, 1]
glm::dmat4 morphedFromEye(const ViewVolumeMorph &morph, double t);

/// Planes (A, B, C, D) in eye space that cut the drawn scene, A x + B y + C z + D >= 0 inside:
/// near, left, right, bottom, top, far. At t = 0 they contain everything (A = B = C = 0), at t = 1
/// they are the volume's own, and they close in continuously. Points inside have w > 0 under M(t):
/// nothing behind the eye is folded over into the view.
std::array<glm::dvec4, 6> closingPlanes(const ViewVolumeMorph &morph, double t);

/// A plane in the source space of a matrix.
glm::dvec4 planeInSource(const glm::dvec4 &plane, const glm::dmat4 &targetFromSource);

struct Segment {
    glm::dvec3 from;
    glm::dvec3 to;
};

/// The part of a segment on the positive side of every plane; empty if all of it is cut off.
template <class Planes>
std::optional<Segment> clipped(Segment segment, const Planes &planes)
{
    for (const glm::dvec4 &plane : planes) {
        const auto side = [&plane](const glm::dvec3 &p) {
            return plane.x * p.x + plane.y * p.y + plane.z * p.z + plane.w;
        };
        const double a = side(segment.from), b = side(segment.to);
        if (a < 0.0 && b < 0.0)
            return std::nullopt;
        if (a < 0.0)
            segment.from += (segment.to - segment.from) * (a / (a - b));
        else if (b < 0.0)
            segment.to += (segment.from - segment.to) * (b / (b - a));
    }
    return segment;
}

} // namespace unprojector::geometry
