#pragma once

#include "core/cameras/foreign_camera.h"

#include <glm/vec2.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>

namespace unprojector::cameras {

/// A position in the image of a lens with these coefficients (Brown 1966; Conrady 1919), from
/// that of a pinhole:
///
///   r^2 = x^2 + y^2,  c = 1 + k1 r^2 + k2 r^4 + k3 r^6
///   x_d = c x + 2 p1 x y + p2 (r^2 + 2 x^2)
///   y_d = c y + p1 (r^2 + 2 y^2) + 2 p2 x y
///
/// @param position  (X / Z, Y / Z), X right, Y down, Z ahead
/// Source: OpenCV, calib3d
glm::dvec2 distorted(const Distortion &lens, const glm::dvec2 &position);

/// The inverse of distorted(), by Newton's iteration.
/// @return nothing if no position near the centre has this image: far out, coefficients fold the
///         image over
std::optional<glm::dvec2> undistorted(const Distortion &lens, const glm::dvec2 &position);

/// The same for pixels, counted from the image's top-left corner.
/// @param k  centres at whole numbers or at halves, as they say
glm::dvec2 distortedPixel(const Distortion &lens, const Intrinsics &k, const glm::dvec2 &pixel);
std::optional<glm::dvec2> undistortedPixel(const Distortion &lens, const Intrinsics &k, const glm::dvec2 &pixel);

/// The names of the coefficients in OpenCV's order.
inline constexpr std::array kCoefficients{"k1", "k2", "p1", "p2", "k3", "k4", "k5",
                                          "k6", "s1", "s2", "s3", "s4", "tx", "ty"};

/// The coefficients of a list in OpenCV's order: k1, k2, p1, p2, k3; four, five or more, of which
/// those after k3 must be 0.
/// @return the reason why they are none, which names each coefficient after k3
geometry::Result<Distortion, std::string> distortionOf(std::span<const double> coefficients);

/// "k1 = -0.3, p2 = 0.001": the coefficients that are not 0.
std::string coefficientsText(const Distortion &lens);

} // namespace unprojector::cameras
