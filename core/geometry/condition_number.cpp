#include "core/geometry/condition_number.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::geometry {
namespace {

double largestRowSum(const glm::dmat4 &m)
{
    double largest = 0.0;
    for (int row = 0; row < 4; ++row) {
        double sum = 0.0;
        for (int column = 0; column < 4; ++column)
            sum += std::abs(m[column][row]);
        largest = std::max(largest, sum);
    }
    return largest;
}

} // namespace

double largestEntry(const glm::dmat4 &matrix)
{
    double largest = 0.0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(matrix[i / 4][i % 4]));
    return largest;
}

/// Row echelon by the largest pivot distinguishes a singular matrix from one whose determinant is
/// merely small: a determinant scales with the fourth power of the units.
bool isSingular(const glm::dmat4 &matrix)
{
    glm::dmat4 m = matrix;
    for (int column = 0; column < 4; ++column) {
        double scale = 0.0;
        for (int row = 0; row < 4; ++row)
            scale = std::max(scale, std::abs(m[column][row]));
        if (scale == 0.0)
            return true;
    }
    for (int k = 0; k < 4; ++k) {
        int pivot = k;
        for (int row = k + 1; row < 4; ++row) {
            if (std::abs(m[k][row]) > std::abs(m[k][pivot]))
                pivot = row;
        }
        if (m[k][pivot] == 0.0)
            return true;
        for (int column = 0; column < 4; ++column)
            std::swap(m[column][k], m[column][pivot]);
        for (int row = k + 1; row < 4; ++row) {
            const double factor = m[k][row] / m[k][k];
            for (int column = k; column < 4; ++column)
                m[column][row] -= factor * m[column][k];
        }
    }
    return false;
}

double conditionNumber(const glm::dmat4 &matrix)
{
    if (isSingular(matrix))
        return std::numeric_limits<double>::infinity();
    return largestRowSum(matrix) * largestRowSum(glm::inverse(matrix));
}

} // namespace unprojector::geometry
