#pragma once

#include "core/geometry/matrix_projection.h"

#include <glm/mat4x4.hpp>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::matrices {

/// What a pasted matrix is given as.
enum class MatrixRole {
    View,       ///< eye from world, or the modelview
    Projection, ///< clip from eye
    Product     ///< clip from world
};

/// What is to be seen of a pasted matrix. All of it can be meant; what is not is the commonest reason why its points are
/// wrong.
enum class MatrixFault {
    Transposed,     ///< its last column is what the last row has to be
    Inverse,        ///< its inverse has the form of such a matrix; of a view: has the world's origin in sight
    Exchanged,      ///< a view given as the projection, or the reverse
    UnknownForm,    ///< neither of the forms that closed formulas are known for
    DepthZeroToOne, ///< value: near by NDC depths in [0, 1]
    DepthReversed,  ///< value: near
    FarAtInfinity,  ///< value: near
    YDown,          ///< y is turned round, as for Vulkan
    Mirrored,       ///< x is turned round, or the axes are left-handed ones
    LeftHanded,     ///< eye space looks along +z
    Negated,        ///< every entry has the other sign: the same points, with w < 0 in front of the eye
    Rounded, ///< nearly rigid, as few digits leave it; value: how far the axes are from orthonormal, as axesOff counts
    Scaled,  ///< value: how many times as long an axis is
    // Those of several matrices, see toldOrders:
    OtherOrder,    ///< is read in the order that its form does not have as a rule: only so it is a camera's
    OrderOfOthers, ///< is a camera's in both orders, and read as another matrix of its form
    OrderOpen      ///< is a camera's in both orders, and nothing tells which is meant
};

/// What can be done about it.
enum class MatrixRepair {
    None,
    OtherOrder, ///< read by rows what was read by columns, or the reverse
    Invert,
    Exchange, ///< view for projection
    DepthZeroToOne,
    TurnY, ///< the row of y times -1
    TurnX,
    WithoutScale, ///< axes of length 1, eye coordinates as they are
    Orthonormal,  ///< the nearest axes that are perpendicular and of length 1
    Negate,       ///< times -1
    TurnEye       ///< looks down -z, see turnEye
};

struct MatrixFinding {
    MatrixFault fault;
    MatrixRepair repair = MatrixRepair::None;
    double value = std::numeric_limits<double>::quiet_NaN();
    /// DepthZeroToOne: near by the depths in [-1, 1] that the matrix is read by as long as nothing else is said; NaN where it
    /// can only be [0, 1] and is read so already.
    double other = std::numeric_limits<double>::quiet_NaN();
};

/// A fixed name: "transposed", "inverse", "exchanged", "unknown-form", "depth-zero-to-one", "depth-reversed",
/// "far-at-infinity", "y-down", "mirrored", "left-handed", "negated", "rounded", "scaled", "other-order", "order-of-others",
/// "order-open".
std::string_view idOf(MatrixFault fault);

/// What is to be seen of a matrix. Nothing is changed; what would be read in another order or inverted is not looked at
/// further. What rounding leaves of a zero counts as one, and printed numbers as those they were rounded from.
/// @param matrix    column vectors, finite
/// @param ndcDepth  what is known of the NDC depths: then nothing is said of them
/// @param clipFromEye  with a view: its projection, to tell whether the world's origin is in sight
std::vector<MatrixFinding> findings(const glm::dmat4 &matrix, MatrixRole role,
                                    const std::optional<geometry::NdcDepth> &ndcDepth = std::nullopt,
                                    const std::optional<glm::dmat4> &clipFromEye = std::nullopt);

/// Makes a projection and a view of an eye space that looks along +z those of one that looks down -z. Their product stays.
void turnEye(glm::dmat4 &clipFromEye, glm::dmat4 &eyeFromWorld);

/// The matrix after a repair. None, Exchange and DepthZeroToOne leave it as it is: these are said elsewhere. TurnEye is that of a
/// projection alone, for a view that looks down -z.
glm::dmat4 repaired(const glm::dmat4 &matrix, const MatrixFinding &finding);

/// In a sentence without its subject: "looks transposed: …".
std::string findingText(const MatrixFinding &finding, MatrixRole role);

} // namespace unprojector::matrices
