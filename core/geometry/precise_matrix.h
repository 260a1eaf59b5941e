#pragma once

#include "core/geometry/numbers.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace unprojector::geometry {

/// A 4x4 matrix of double-doubles, stored column by column, for products whose terms cancel. In
/// doubles, a translation by 1e8 and its inverse would leave eight wrong digits.
struct PreciseMatrix {
    std::array<std::array<DoubleDouble, 4>, 4> columns; ///< columns[c][r] is row r of column c

    PreciseMatrix() : PreciseMatrix(glm::dmat4(1.0)) {}
    /// The matrix with exactly these doubles.
    PreciseMatrix(const glm::dmat4 &exact);

    /// Rounds each number to the nearest double.
    glm::dmat4 rounded() const;
    /// The product with (point, 1). @pre the last row is 0 0 0 1
    DoubleDouble3 at(const DoubleDouble3 &point) const;
    DoubleDouble3 at(const glm::dvec3 &point) const;
    /// The product with (vector, 0).
    DoubleDouble3 turned(const DoubleDouble3 &vector) const;

    /// The inverse, by the cross products of the columns. Not finite for a singular matrix.
    /// @pre the last row is 0 0 0 1
    PreciseMatrix affineInverse() const;

    friend bool operator==(const PreciseMatrix &, const PreciseMatrix &) = default;

    friend PreciseMatrix operator*(const PreciseMatrix &a, const PreciseMatrix &b);
};

} // namespace unprojector::geometry
