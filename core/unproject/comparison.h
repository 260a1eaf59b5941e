#pragma once

#include "core/geometry/view_geometry.h"

namespace unprojector::unproject {
using namespace geometry;

/// One point computed by each method, in one space. Each says for itself why it has no answer.
template <class Space>
struct TwoWays {
    Result<Point<Space>> formula;
    Result<Point<Space>> matrix;
    Result<Point<Space>> matrixInFloat; ///< the matrix path done wholly in single precision, as most programs do

    /// formula - matrix.
    /// @pre both have an answer
    glm::dvec3 difference() const { return formula->coordinates() - matrix->coordinates(); }
};

/// A window position unprojected by formulas (9) to (12) and by the inverted matrix.
struct Comparison {
    TwoWays<EyeSpace> eye;
    TwoWays<WorldSpace> world;
};

/// Both methods side by side. Eye to world goes by the camera's axes for the formula, by the inverse of
/// clipFromWorld for the matrix.
/// @return never an error as a whole: the errors of the geometry and of the depth are in each method's result
Comparison compareUnprojections(const ViewGeometry &geometry, const WindowPoint &window);

/// The spacing of doubles at the largest component of a point: the unit that differences of this point are
/// counted in. Counting each component in its own unit would call the noise of a component near 0 enormous.
double ulpOfLargest(const glm::dvec3 &point);

} // namespace unprojector::unproject
