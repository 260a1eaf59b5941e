#pragma once

#include "core/geometry/api_conventions.h"
#include "core/geometry/camera.h"
#include "core/geometry/projection.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace unprojector::pipeline {

/// The effect of one factor of a view or projection matrix. l, r, b, t, n, f are the arguments of
/// glOrtho and glFrustum.
enum class MatrixStep {
    MoveEye,         ///< gluLookAt's T: world -> axes as in the world, origin at the eye
    TurnAxes,        ///< gluLookAt's R: rows s, u, -f
    Shear,           ///< x += cot theta z, y += cot phi z, eye units
    Skew,            ///< x += skew y, eye units
    MoveBox,         ///< the box's middle, z = -(n + f)/2, to the origin; eye units
    ScaleBox,        ///< the box to sides of 2: 2/(r-l), 2/(t-b), 2/(f-n)
    TurnZ,           ///< z times -1: a greater NDC depth is farther away
    OntoNear,        ///< (n x, n y, a z + b, -z), divided by w: onto the near plane; a = -(f+n)/(f-n), b = -2fn/(f-n)
    NearToSquare,    ///< x and y of the near plane's window [l, r] x [b, t] to [-1, 1]; before the division
    FromConventions, ///< from an API's axes to this program's
    ToConventions    ///< from this program's axes to an API's
};

struct MatrixFactor {
    MatrixStep step;
    glm::dmat4 matrix; ///< for column vectors
};

/// The factors of clipFromEye in the order in which they act on a point; the product is written in
/// the reverse order:
///
///   glOrtho    TurnZ * ScaleBox * MoveBox, oblique: * Shear
///   glFrustum  NearToSquare * OntoNear, with a skew: * Skew
///
/// Each entry of their product in double is within a unit in the last place of
/// clipFromEye(projection).
/// @return the errors of check(projection)
/// Source: `parallel-projection`; Zhang Ci, section 2.2.1; `projection-derivation` for a z + b.
geometry::Result<std::vector<MatrixFactor>> factors(const geometry::Projection &projection);

/// The factors of eyeFromWorld = TurnAxes * MoveEye, in the order in which they act.
/// @return the errors of eyeFrame
/// Source: gluLookAt; Weng et al. 2008, section 2.1.
geometry::Result<std::vector<MatrixFactor>> factors(const geometry::LookAt &view);

/// The factors of the matrix from an API's source space to its target space.
/// @param source, target  from this program's coordinates to the API's, in the two spaces; an
///         identity adds no factor
std::vector<MatrixFactor> inConventions(std::vector<MatrixFactor> factors, const geometry::AxisChange &source,
                                        const geometry::AxisChange &target);

/// The interpolation from the identity to a factor: (1 - share) I + share M, entry by entry. It is
/// I at 0, and M to the last bit at 1. TurnZ is flat at one half. For OntoNear, w = 1 - share -
/// share z, which is positive in front of the eye.
/// @param share  in [0, 1]
glm::dmat4 partOf(const glm::dmat4 &factor, double share);

/// The product of the factors' parts, see partOf. If every share is 1, it is the product of the
/// factors, see differenceUlps.
/// @param factors  in the order in which they act
/// @param shares   in [0, 1], one per factor
glm::dmat4 productOf(const std::vector<MatrixFactor> &factors, const std::vector<double> &shares);

/// The largest difference of an entry between the factors' product and a matrix, in units in the
/// last place of the entry. If terms of opposite signs cancel, the unit is taken at the sum of
/// their sizes, since the rounding error scales with it.
/// @param factors  in the order in which they act; at least one
double differenceUlps(const std::vector<MatrixFactor> &factors, const glm::dmat4 &matrix);

} // namespace unprojector::pipeline
