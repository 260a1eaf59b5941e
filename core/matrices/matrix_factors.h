#pragma once

#include "core/geometry/api_conventions.h"
#include "core/geometry/camera.h"
#include "core/geometry/projection.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace unprojector::matrices {

/// What one factor of a view's or a projection's matrix does. l, r, b, t, n, f are the arguments of glOrtho and glFrustum.
enum class MatrixStep {
    MoveEye,         ///< gluLookAt's T: world -> axes as in the world, origin at the eye
    TurnAxes,        ///< gluLookAt's R: rows s, u, -f
    Shear,           ///< x += cot theta z, y += cot phi z, eye units
    MoveBox,         ///< the box's middle, z = -(n + f)/2, to the origin; eye units
    ScaleBox,        ///< the box to sides of 2: 2/(r-l), 2/(t-b), 2/(f-n)
    TurnZ,           ///< z times -1: a greater NDC depth is farther away
    OntoNear,        ///< (n x, n y, a z + b, -z), divided by w: onto the near plane; a = -(f+n)/(f-n), b = -2fn/(f-n)
    NearToSquare,    ///< x and y of the near plane's window [l, r] x [b, t] to [-1, 1]; before the division
    FromConventions, ///< an API's axes to this program's
    ToConventions    ///< this program's axes to an API's
};

struct MatrixFactor {
    MatrixStep step;
    glm::dmat4 matrix; ///< for column vectors
};

/// clipFromEye in the steps of its derivation, in the order in which they act on a point; the product is written the other way
/// round:
///
///   glOrtho    TurnZ * ScaleBox * MoveBox, oblique: * Shear
///   glFrustum  NearToSquare * OntoNear
///
/// Multiplied in double they are within a unit in the last place of clipFromEye(projection), entry by entry.
/// @return the errors of check(projection)
/// Source: `parallel-projection`; Zhang Ci, section 2.2.1; `projection-derivation` for a z + b.
geometry::Result<std::vector<MatrixFactor>> factors(const geometry::Projection &projection);

/// eyeFromWorld = TurnAxes * MoveEye, in the order in which they act.
/// @return the errors of eyeFrame
/// Source: gluLookAt; Weng et al. 2008, section 2.1.
geometry::Result<std::vector<MatrixFactor>> factors(const geometry::LookAt &view);

/// The factors of the matrix that an API has from and to its own spaces.
/// @param source, target  how the coordinates of the two spaces follow from this program's; what changes nothing adds no factor
std::vector<MatrixFactor> inConventions(std::vector<MatrixFactor> factors, const geometry::AxisChange &source,
                                        const geometry::AxisChange &target);

/// What a factor does where only a part of it acts: (1 - share) I + share M, entry by entry. I at 0; M, to the last bit, at 1.
/// Half of TurnZ is flat. Of OntoNear w is 1 - share - share z, which is above 0 in front of the eye.
/// @param share  in [0, 1]
glm::dmat4 partOf(const glm::dmat4 &factor, double share);

/// The product of the factors' parts. Where every share is 1 it is that of the factors, see differenceUlps.
/// @param factors  in the order in which they act
/// @param shares   in [0, 1], one of each factor
glm::dmat4 productOf(const std::vector<MatrixFactor> &factors, const std::vector<double> &shares);

/// The greatest difference of an entry of the factors' product from that of a matrix, in units in the last place of the entry;
/// where terms of other signs cancel, of the sum of their sizes, which is what rounding goes by.
/// @param factors  in the order in which they act; at least one
double differenceUlps(const std::vector<MatrixFactor> &factors, const glm::dmat4 &matrix);

} // namespace unprojector::matrices
