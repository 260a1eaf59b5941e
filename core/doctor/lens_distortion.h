#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/geometry/setup.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <optional>

namespace unprojector::doctor {

/// The matrix K of a perspective: pixel = focal * direction + centre. Pixels are device pixels from
/// the top-left corner; a direction is (X / Z, Y / Z) with Y down and Z ahead.
struct Pinhole {
    glm::dvec2 focal{1.0}, centre{0.0};

    glm::dvec2 pixel(const glm::dvec2 &direction) const { return focal * direction + centre; }
    glm::dvec2 direction(const glm::dvec2 &pixel) const { return (pixel - centre) / focal; }
};

/// @param side  direction of view in eye space: z_eye = side * distance
Pinhole pinholeOf(const glm::dmat4 &clipFromEye, double side, const geometry::Viewport &viewport,
                  const geometry::Surface &surface);

/// The distorted direction, by the model of Brown and Conrady:
///
///   x' = x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²), and y' likewise
glm::dvec2 distorted(const cameras::Distortion &distortion, const glm::dvec2 &direction);

/// The direction whose distorted one is given, by Newton's method.
/// @return empty outside the range in which the model can be inverted
std::optional<glm::dvec2> undistorted(const cameras::Distortion &distortion, const glm::dvec2 &direction);

} // namespace unprojector::doctor
