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

DoubleDouble3 PreciseMatrix::at(const glm::dvec3 &point) const
{
    DoubleDouble3 result;
    for (std::size_t r = 0; r < 3; ++r)
        result[r] = columns[0][r] * point.x + columns[1][r] * point.y + columns[2][r] * point.z + columns[3][r];
    return result;
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
