#pragma once

#include "core/geometry/double_double.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace unprojector::geometry {

/// A 4x4 matrix of double-doubles, stored column by column, for products whose terms cancel. In
/// doubles, a translation by 1e8 and its inverse would leave eight wrong digits.
struct PreciseMatrix {
    std::array<std::array<DoubleDouble, 4>, 4> columns; ///< columns[c][r] is row r of column c

    /// The matrix with exactly these doubles.
    explicit PreciseMatrix(const glm::dmat4 &exact);

    /// Rounds each number to the nearest double.
    glm::dmat4 rounded() const;
    /// The product with (point, 1). @pre the last row is 0 0 0 1
    DoubleDouble3 at(const glm::dvec3 &point) const;

    friend PreciseMatrix operator*(const PreciseMatrix &a, const PreciseMatrix &b);
};

} // namespace unprojector::geometry
