#pragma once

#include "core/geometry/projection.h"
#include "core/geometry/spaces.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <variant>

namespace unprojector::geometry {

/// A projection that another program gives as its matrix: column vectors, eye space looking down -z or +z.
struct MatrixProjection {
    glm::dmat4 clipFromEye{1.0};
    /// Which NDC depths the window's depth range stands for. A matrix alone does not tell: each that goes by [0, 1] is
    /// one of [-1, 1] with another near plane. Without a word it is taken for OpenGL's, unless it can only be [0, 1].
    std::optional<NdcDepth> ndcDepth;
    friend bool operator==(const MatrixProjection &, const MatrixProjection &) = default;
};

/// The numbers that a matrix of one of the known forms is made of. With side = -1 where eye space looks down -z, else
/// +1, so that z_eye = side z with z the distance, and w the number that scales the whole matrix, as a rule 1:
///
///   perspective  w x_n = xScale x / z - xOffset,  w y_n = …,  w z_n = zOffset / z - zScale
///   box          w x_n = xScale x + xShear z_eye - xOffset,  w y_n = …,  w z_n = zScale z_eye + zOffset
///
struct ProjectionCoefficients {
    bool perspective = true;
    double side = -1.0;
    double w = 1.0;
    double xScale = 1.0, yScale = 1.0;
    double xOffset = 0.0, yOffset = 0.0;
    double xShear = 0.0, yShear = 0.0; ///< box only
    double zScale = -1.0, zOffset = 0.0;
};

/// What a projection matrix says, told in the arguments of glFrustum or glOrtho.
struct RecognisedProjection {
    /// The same volume in OpenGL's terms. Where `infiniteFar`, far is infinity. The arguments are those with the fewest
    /// digits that make this very matrix; where none do (a matrix that was rounded otherwise), the nearest.
    std::variant<Frustum, Ortho, Oblique> parameters;
    NdcDepth ndcDepth = NdcDepth::MinusOneToOne;
    bool reversed = false; ///< near lies at the greater NDC depth
    bool infiniteFar = false;
    bool looksAlongPlusZ = false; ///< left-handed eye space; `parameters` have z counted forward all the same
    bool exact = false;           ///< `parameters` make the matrix again, to the last bit (of single precision, where
                                  ///< all its numbers are single)
    ProjectionCoefficients coefficients;
};

/// Reads a projection matrix: glFrustum, glOrtho, sheared glOrtho, in OpenGL's depth or Direct3D's and Vulkan's, reversed
/// or not, with the far plane at infinity or not, looking down either way, times any positive number.
/// @return NotFinite; SingularMatrix; MatrixNotAProjection (value: the entry that does not fit; other: its place among the
///         16, column by column, from 0)
Result<RecognisedProjection> recognised(const MatrixProjection &projection);

/// Eye-space point under a window position, term by term as in formulas (9) to (12): no matrix is inverted. What the
/// formulas do with near and far is done with the matrix's own numbers, since a far plane's digits are no longer in it:
///
///   z = zOffset / (w z_n + zScale), the denominator being (zScale + w) - w k (1 - d) or, reversed,
///   (zScale + w (1 - k)) + w k d, whose terms never cancel;  k = 2 for [-1, 1], 1 for [0, 1]
///
/// Not rounded yet, see preciseEyePoint(Projection).
/// @return the errors of recognised, check(viewport), depthShares; NotFinite (position); PointAtInfinity
Result<PrecisePoint<EyeSpace>> preciseEyePoint(const MatrixProjection &projection, const Viewport &viewport,
                                               const DepthRange &range, const WindowPoint &window);

/// The convention that both methods go by: the one given, else what `recognised` says, else OpenGL's.
NdcDepth ndcDepthOf(const MatrixProjection &projection);

} // namespace unprojector::geometry
