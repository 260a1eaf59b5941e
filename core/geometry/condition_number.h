#pragma once

#include <glm/mat4x4.hpp>

namespace unprojector::geometry {

/// The greatest absolute value of an entry.
double largestEntry(const glm::dmat4 &matrix);

/// Whether a matrix has no inverse, told by its pivots.
bool isSingular(const glm::dmat4 &matrix);

/// How much inverting can amplify a relative error: |M| |M^-1| in the largest-row-sum norm, at least 1; infinity for a
/// singular matrix.
double conditionNumber(const glm::dmat4 &matrix);

} // namespace unprojector::geometry
