#pragma once

#include "core/geometry/result.h"
#include "core/geometry/spaces.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

namespace unprojector::unproject {

/// Unprojects like gluUnProject, with its matrix inverted once for any number of points: p = M^-1
/// (x_n, y_n, z_n, 1), divided by its w, with M inverted by glm::inverse.
///
/// The result is in the source space of the given matrix: clipFromEye gives eye coordinates,
/// clipFromWorld world coordinates, clipFromObject object coordinates.
///
/// @tparam Scalar double, or float to show the loss of programs that use single precision
///         throughout
/// Source: gluUnProject, OpenGL 2.1 reference. MVPW^-1 (x_w, y_w, d, 1) with the viewport's inverse
/// taken first.
template <class Space, class Scalar = double>
class MatrixInverse {
public:
    using Matrix = glm::mat<4, 4, Scalar>;

    /// @param ndcDepth  the NDC depths at the ends of the depth range; with [0, 1] z_n keeps the
    ///         digits of a small depth
    /// @return the errors of check(viewport) and check(range); NotFinite (an entry of the matrix);
    ///         SingularMatrix
    static geometry::Result<MatrixInverse> of(const glm::dmat4 &clipFromSpace, const geometry::Viewport &viewport,
                                              const geometry::DepthRange &range,
                                              geometry::NdcDepth ndcDepth = geometry::NdcDepth::MinusOneToOne);

    /// @param window  device pixels, origin bottom-left; depth in the depth range (may lie outside
    ///         it, since the matrix extrapolates)
    /// @return NotFinite (position or depth); PointAtInfinity
    geometry::Result<geometry::Point<Space>> at(const geometry::WindowPoint &window) const;

    /// The same before the division by w.
    /// @return NotFinite (position or depth)
    geometry::Result<glm::vec<4, Scalar>> homogeneousAt(const geometry::WindowPoint &window) const;

    /// M^-1 as applied to points.
    const Matrix &spaceFromClip() const { return m_spaceFromClip; }

private:
    MatrixInverse(const Matrix &spaceFromClip, const geometry::Viewport &viewport, const geometry::DepthRange &range,
                  geometry::NdcDepth ndcDepth)
        : m_spaceFromClip(spaceFromClip), m_viewport(viewport), m_range(range), m_ndcDepth(ndcDepth)
    {
    }

    Matrix m_spaceFromClip;
    geometry::Viewport m_viewport;
    geometry::DepthRange m_range;
    geometry::NdcDepth m_ndcDepth;
};

} // namespace unprojector::unproject
