#pragma once

#include <glm/mat4x4.hpp>

#include <optional>

namespace unprojector::matrices {

/// The unit of the last decimal that a matrix was printed with, 0.01 to 0.000001, where no entry has more.
/// @return 0 where one has more than six decimals
double printedUnit(const glm::dmat4 &matrix);

/// The same matrix with the nearest axes that are perpendicular and of length 1 (those of its polar decomposition, by
/// Newton's iteration; Higham 1986); the translation stays.
/// @param eyeFromWorld  with an inverse
glm::dmat4 orthonormal(const glm::dmat4 &eyeFromWorld);

/// Whether a view's axes are only off by what it was rounded to when it was printed, and by more than formulas allow.
/// @return how far they are from orthonormal: the largest |entry| of R R^T - 1
std::optional<double> roundedOff(const glm::dmat4 &eyeFromWorld);

} // namespace unprojector::matrices
