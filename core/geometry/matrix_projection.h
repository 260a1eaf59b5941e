#pragma once

#include "core/geometry/projection.h"
#include "core/geometry/spaces.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <variant>

namespace unprojector::geometry {

/// A projection given by another program as a matrix: column vectors, eye space looking down -z or
/// +z.
struct MatrixProjection {
    glm::dmat4 clipFromEye{1.0};
    /// The NDC depths that the window's depth range maps to. A matrix alone does not determine
    /// them: each matrix for [0, 1] equals one for [-1, 1] with another near plane. If empty,
    /// OpenGL's are assumed unless the matrix can only be [0, 1].
    std::optional<NdcDepth> ndcDepth;
    friend bool operator==(const MatrixProjection &, const MatrixProjection &) = default;
};

/// The coefficients of a matrix of one of the known forms. side is -1 where eye space looks down
/// -z, else +1, so that z_eye = side z with z the distance. w scales the whole matrix and is
/// usually 1. A matrix with all signs turned has the coefficients of the turned one, so w > 0:
///
///   perspective  w x_n = (xScale x + xSkew y) / z - xOffset,  w y_n = …,
///                w z_n = zOffset / z - zScale
///   box          w x_n = xScale x + xShear z_eye - xOffset,  w y_n = …,
///                w z_n = zScale z_eye + zOffset
struct ProjectionCoefficients {
    bool perspective = true;
    double side = -1.0;
    double w = 1.0;
    double xScale = 1.0, yScale = 1.0;
    double xOffset = 0.0, yOffset = 0.0;
    double xSkew = 0.0;                ///< perspective only
    double xShear = 0.0, yShear = 0.0; ///< box only
    double zScale = -1.0, zOffset = 0.0;
};

/// The content of a projection matrix, in the arguments of glFrustum or glOrtho.
struct RecognisedProjection {
    /// The same volume in OpenGL's terms. Where `infiniteFar`, far is infinity. The arguments have
    /// the fewest digits that give exactly this matrix. Where none do (the matrix was rounded
    /// otherwise), they are the nearest.
    std::variant<Frustum, Ortho, Oblique> parameters;
    NdcDepth ndcDepth = NdcDepth::MinusOneToOne;
    bool reversed = false; ///< near has the greater NDC depth
    bool infiniteFar = false;
    bool negated = false;         ///< all signs are turned: w < 0 in front of the eye
    bool looksAlongPlusZ = false; ///< left-handed eye space; `parameters` count z forward nevertheless
    bool exact = false; ///< `parameters` give the matrix to the last bit (of single precision if its numbers are)
    ProjectionCoefficients coefficients;
};

/// Recognises a projection matrix: glFrustum, with a skew or without, glOrtho or sheared glOrtho. The depth may be
/// OpenGL's, or Direct3D's and Vulkan's, reversed or not. The far plane may be at infinity, eye
/// space may look down either direction, and any factor but 0 may scale the matrix.
/// @return NotFinite; SingularMatrix; MatrixNotAProjection (value: the entry that does not fit;
///         other: its index among the 16, column by column, from 0)
Result<RecognisedProjection> recognised(const MatrixProjection &projection);

/// The eye-space point under a window position, term by term as in formulas (9) to (12); no matrix
/// is inverted. The matrix's own numbers replace near and far, because a far plane's digits are no
/// longer in the matrix:
///
///   z = zOffset / (w z_n + zScale), the denominator being (zScale + w) - w k (1 - d) or, reversed,
///   (zScale + w (1 - k)) + w k d, whose terms never cancel;  k = 2 for [-1, 1], 1 for [0, 1]
///
/// The point is not rounded yet, see preciseEyePoint(Projection).
/// @return the errors of recognised, check(viewport), depthShares; NotFinite (position);
///         PointAtInfinity
Result<PrecisePoint<EyeSpace>> preciseEyePoint(const MatrixProjection &projection, const Viewport &viewport,
                                               const DepthRange &range, const PrecisePoint<WindowSpace> &window);

/// The depth convention that both methods use: the given one, else the one that `recognised` finds,
/// else OpenGL's.
NdcDepth ndcDepthOf(const MatrixProjection &projection);

/// The sign of w in front of the eye: -1 for a matrix with all signs turned. Where w has both signs
/// in the depth range, OpenGL's: 1.
double wInFront(const MatrixProjection &projection);

} // namespace unprojector::geometry
