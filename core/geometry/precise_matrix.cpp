#include "core/geometry/precise_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace unprojector::geometry {

PreciseMatrix::PreciseMatrix(const glm::dmat4 &exact)
{
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t r = 0; r < 4; ++r)
            columns[c][r] = exact[static_cast<int>(c)][static_cast<int>(r)];
    }
}

glm::dmat4 PreciseMatrix::rounded() const
{
    glm::dmat4 matrix;
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t r = 0; r < 4; ++r)
            matrix[static_cast<int>(c)][static_cast<int>(r)] = columns[c][r].value;
    }
    return matrix;
}

DoubleDouble3 PreciseMatrix::turned(const DoubleDouble3 &vector) const
{
    DoubleDouble3 result;
    for (std::size_t r = 0; r < 3; ++r)
        result[r] = columns[0][r] * vector[0] + columns[1][r] * vector[1] + columns[2][r] * vector[2];
    return result;
}

DoubleDouble3 PreciseMatrix::at(const DoubleDouble3 &point) const
{
    DoubleDouble3 result = turned(point);
    for (std::size_t r = 0; r < 3; ++r)
        result[r] = result[r] + columns[3][r];
    return result;
}

DoubleDouble3 PreciseMatrix::at(const glm::dvec3 &point) const
{
    return at(DoubleDouble3{point.x, point.y, point.z});
}

PreciseMatrix PreciseMatrix::affineInverse() const
{
    // Of size 1, so that nothing leaves the range of doubles.
    double largest = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t r = 0; r < 3; ++r)
            largest = std::max(largest, std::abs(columns[c][r].value));
    }
    const int exponent = largest > 0.0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
    const auto scaled = [](const DoubleDouble &d, int power) {
        return DoubleDouble(std::ldexp(d.value, power), std::ldexp(d.rest, power));
    };
    const auto column = [&](std::size_t c) {
        return DoubleDouble3{scaled(columns[c][0], -exponent), scaled(columns[c][1], -exponent),
                             scaled(columns[c][2], -exponent)};
    };
    const std::array<DoubleDouble3, 3> rows{cross(column(1), column(2)), cross(column(2), column(0)),
                                            cross(column(0), column(1))};
    const DoubleDouble determinant = dot(column(0), rows[0]);
    PreciseMatrix inverse;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c)
            inverse.columns[c][r] = rows[r][c] / determinant;
    }
    // The cofactors lose the square of the condition number. Newton's step X (2 - M X) gives it back.
    for (int step = 0; step < 2; ++step) {
        std::array<DoubleDouble3, 3> left; // the columns of 1 - M X
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t r = 0; r < 3; ++r) {
                left[c][r] = r == c ? 1.0 : 0.0;
                for (std::size_t k = 0; k < 3; ++k)
                    left[c][r] = left[c][r] - column(k)[r] * inverse.columns[c][k];
            }
        }
        const PreciseMatrix before = inverse;
        for (std::size_t c = 0; c < 3; ++c) {
            const DoubleDouble3 change = before.turned(left[c]);
            for (std::size_t r = 0; r < 3; ++r)
                inverse.columns[c][r] = before.columns[c][r] + change[r];
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t r = 0; r < 3; ++r)
            inverse.columns[c][r] = scaled(inverse.columns[c][r], -exponent);
    }
    const DoubleDouble3 moved = inverse.turned(column(3));
    for (std::size_t r = 0; r < 3; ++r)
        inverse.columns[3][r] = -moved[r];
    return inverse;
}

PreciseMatrix operator*(const PreciseMatrix &a, const PreciseMatrix &b)
{
    PreciseMatrix product(glm::dmat4(0.0));
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t r = 0; r < 4; ++r) {
            for (std::size_t k = 0; k < 4; ++k)
                product.columns[c][r] = product.columns[c][r] + a.columns[k][r] * b.columns[c][k];
        }
    }
    return product;
}

} // namespace unprojector::geometry
