#include "core/pipeline/printed_digits.h"

#include "core/geometry/view_matrix.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::pipeline {

double largestDifference(const glm::dmat3 &a, const glm::dmat3 &b)
{
    double largest = 0.0;
    for (int i = 0; i < 9; ++i)
        largest = std::max(largest, std::abs(a[i / 3][i % 3] - b[i / 3][i % 3]));
    return largest;
}

glm::dmat4 withoutNegativeZeros(glm::dmat4 matrix)
{
    for (int i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] += 0.0;
    return matrix;
}

double printedUnit(const glm::dmat4 &matrix)
{
    constexpr int kFewest = 2, kMost = 6;
    constexpr double kDoubleRounding = 1e-12;
    double power = 10.0;
    for (int decimals = kFewest; decimals <= kMost; ++decimals) {
        power *= 10.0;
        bool isWhole = true;
        for (int i = 0; i < 16; ++i) {
            const double entry = matrix[i / 4][i % 4] * power;
            isWhole =
                isWhole && std::abs(entry - std::round(entry)) <= kDoubleRounding * std::max(1.0, std::abs(entry));
        }
        if (isWhole)
            return 1.0 / power;
    }
    return 0.0;
}

glm::dmat4 orthonormal(const glm::dmat4 &eyeFromWorld)
{
    glm::dmat3 axes = glm::dmat3(eyeFromWorld) / eyeFromWorld[3][3];
    constexpr int kMostSteps = 30; // near the solution, each step doubles the digits
    for (int step = 0; step < kMostSteps; ++step) {
        const glm::dmat3 next = 0.5 * (axes + glm::inverse(glm::transpose(axes)));
        const double moved = largestDifference(next, axes);
        axes = next;
        if (!(moved > 1e-15))
            break;
    }
    glm::dmat4 m = glm::dmat4(axes);
    m[3] = eyeFromWorld[3] / eyeFromWorld[3][3];
    return m;
}

std::optional<double> roundedOff(const glm::dmat4 &eyeFromWorld)
{
    const double unit = printedUnit(eyeFromWorld);
    if (unit == 0.0 || geometry::axesOff(eyeFromWorld) || !(eyeFromWorld[3][3] > 0.0))
        return std::nullopt;
    const glm::dmat3 axes = glm::dmat3(eyeFromWorld) / eyeFromWorld[3][3];
    if (glm::determinant(axes) == 0.0)
        return std::nullopt;
    // Rounding explains half a unit per entry; the margin is for the nearest axes, which differ
    // from the rounded ones.
    if (!(largestDifference(glm::dmat3(orthonormal(eyeFromWorld)), axes) <= 0.75 * unit))
        return std::nullopt;
    return largestDifference(axes * glm::transpose(axes), glm::dmat3(1.0));
}

} // namespace unprojector::pipeline
