#include "core/geometry/precise_matrix.h"

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
    const auto column = [this](std::size_t c) { return DoubleDouble3{columns[c][0], columns[c][1], columns[c][2]}; };
    const std::array<DoubleDouble3, 3> rows{cross(column(1), column(2)), cross(column(2), column(0)),
                                            cross(column(0), column(1))};
    const DoubleDouble determinant = dot(column(0), rows[0]);
    PreciseMatrix inverse;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c)
            inverse.columns[c][r] = rows[r][c] / determinant;
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
