#pragma once

#include <glm/mat4x4.hpp>

namespace unprojector::geometry {

/// The greatest absolute value of an entry.
double largestEntry(const glm::dmat4 &matrix);

/// True if a matrix has no inverse, judged by its pivots.
bool isSingular(const glm::dmat4 &matrix);

/// The greatest factor by which inverting amplifies a relative error: |M| |M^-1| in the
/// largest-row-sum norm, at least 1. Infinity for a singular matrix.
double conditionNumber(const glm::dmat4 &matrix);

} // namespace unprojector::geometry
