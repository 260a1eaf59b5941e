#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <optional>

namespace unprojector::pipeline {

/// The largest |entry| of a - b.
double largestDifference(const glm::dmat3 &a, const glm::dmat3 &b);

/// The matrix with 0 in place of -0.
glm::dmat4 withoutNegativeZeros(glm::dmat4 matrix);

/// The unit of the last decimal that a matrix was printed with, 0.01 to 0.000001, if no entry has
/// more decimals.
/// @return 0 where one has more than six decimals
double printedUnit(const glm::dmat4 &matrix);

/// The matrix with the nearest perpendicular axes of length 1 (from its polar decomposition, by
/// Newton's iteration; Higham 1986). The translation stays.
/// @param eyeFromWorld  with an inverse
glm::dmat4 orthonormal(const glm::dmat4 &eyeFromWorld);

/// Returns the deviation of a view's axes from orthonormal if printing alone explains it and it
/// exceeds what the formulas allow.
/// @return the largest |entry| of R R^T - 1
std::optional<double> roundedOff(const glm::dmat4 &eyeFromWorld);

} // namespace unprojector::pipeline
