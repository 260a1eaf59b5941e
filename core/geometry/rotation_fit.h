#pragma once

#include <glm/mat3x3.hpp>

namespace unprojector::geometry {

/// The rotation R that maximises the sum of y . R x, for points x and y about their centroids. It is
/// the unit quaternion of the largest eigenvalue of Horn's 4 x 4 matrix, which is never a reflection.
///
/// @param fromTo  fromTo[j][i] = sum of x_i y_j over the points, weighted or not
/// Source: Horn 1987, "Closed-form solution of absolute orientation using unit quaternions".
glm::dmat3 rotationOfSums(const glm::dmat3 &fromTo);

} // namespace unprojector::geometry
