#pragma once

#include "core/geometry/matrix_projection.h"

#include <glm/mat4x4.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::pipeline {

/// The role in which a matrix is pasted.
enum class MatrixRole {
    View,       ///< eye from world, or the modelview
    Projection, ///< clip from eye
    Product     ///< clip from world
};

/// A property of a pasted matrix that may be a mistake. Each can be intended; unintended, it is the
/// most common reason for wrong points.
enum class MatrixFault {
    Transposed,     ///< its last column looks like the last row of such a matrix
    Inverse,        ///< its inverse has the form of such a matrix; for a view: has the world's origin in sight
    Exchanged,      ///< a view given as the projection, or the reverse
    UnknownForm,    ///< neither of the forms that have closed formulas
    DepthZeroToOne, ///< value: near, assuming NDC depths in [0, 1]
    DepthReversed,  ///< value: near
    FarAtInfinity,  ///< value: near
    YDown,          ///< y is flipped, as for Vulkan
    Mirrored,       ///< x is flipped, or the axes are left-handed
    LeftHanded,     ///< eye space looks along +z
    Negated,        ///< every entry has the other sign: the same points, with w < 0 in front of the eye
    Rounded,        ///< nearly rigid, as few printed digits leave it; value: deviation from orthonormal, see axesOff
    Scaled,         ///< value: the length of an axis
    // Faults that involve several matrices, see toldOrders:
    OtherOrder,    ///< is read in the order that is unusual for its form: only that order gives a camera's matrix
    OrderOfOthers, ///< is a camera's matrix in both orders; the order of another matrix of its form decides
    OrderOpen      ///< is a camera's matrix in both orders, and nothing decides between them
};

/// The repair that a finding offers.
enum class MatrixRepair {
    None,
    OtherOrder, ///< reads by rows instead of by columns, or the reverse
    Invert,
    Exchange, ///< uses the view as the projection, or the reverse
    DepthZeroToOne,
    TurnY, ///< the row of y times -1
    TurnX,
    WithoutScale, ///< scales the axes to length 1; eye coordinates stay as they are
    Orthonormal,  ///< the nearest perpendicular axes of length 1
    Negate,       ///< times -1
    TurnEye       ///< makes the eye look down -z, see turnEye
};

struct MatrixFinding {
    MatrixFault fault;
    MatrixRepair repair = MatrixRepair::None;
    double value = std::numeric_limits<double>::quiet_NaN();
    /// DepthZeroToOne: near if NDC depths are in [-1, 1], which is the default reading. NaN if only
    /// [0, 1] is possible; then the matrix is read so already.
    double other = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the findings of a matrix; changes nothing. After a finding that changes the order or
/// inverts, the search stops. Rounding residue of a zero counts as zero, and printed numbers count
/// as the numbers they were rounded from.
/// @param matrix    column vectors, finite
/// @param ndcDepth  the known NDC depths: then there are no findings about them
/// @param clipFromEye  for a view: its projection, to test whether the world's origin is in sight
std::vector<MatrixFinding> findings(const glm::dmat4 &matrix, MatrixRole role,
                                    const std::optional<geometry::NdcDepth> &ndcDepth = std::nullopt,
                                    const std::optional<glm::dmat4> &clipFromEye = std::nullopt);

/// Converts a projection and a view for an eye that looks along +z to an eye that looks down -z.
/// Their product stays the same.
void turnEye(glm::dmat4 &clipFromEye, glm::dmat4 &eyeFromWorld);

/// The matrix after a repair. None, Exchange and DepthZeroToOne return it unchanged: the caller
/// applies them. TurnEye gives the projection alone, for a view that looks down -z.
glm::dmat4 repaired(const glm::dmat4 &matrix, const MatrixFinding &finding);

/// The finding as a sentence without its subject: "looks transposed: …".
std::string findingText(const MatrixFinding &finding, MatrixRole role);

} // namespace unprojector::pipeline
