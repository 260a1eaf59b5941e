#pragma once

#include "core/cameras/foreign_camera.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>

namespace unprojector::cameras {

/// A rotation by |axis| radians about the axis, as cv2.Rodrigues makes it.
glm::dmat3 rotationOf(const glm::dvec3 &axis);

/// Returns whether axes are perpendicular and of length 1, up to two printed decimals; they may mirror.
bool areOrthonormal(const glm::dmat3 &axes);

/// K and [R t] of a camera matrix.
struct CameraParts {
    Intrinsics intrinsics;
    glm::dmat4 cameraFromWorld{1.0};
};

/// Splits P = K [R t], of any scale and sign, by an RQ decomposition: fx and fy are positive, R is
/// a rotation.
/// @param numbers  twelve, by rows
/// @return nothing if the first three columns have no inverse
std::optional<CameraParts> partsOf(std::span<const double> numbers);

} // namespace unprojector::cameras
