#include "core/doctor/lens_distortion.h"

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace unprojector::doctor {
namespace {

/// The derivatives of distorted().
glm::dmat2 derivativesOf(const cameras::Distortion &d, const glm::dvec2 &p)
{
    const double r2 = glm::dot(p, p), radial = 1.0 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
    const double slope = 2.0 * (d.k1 + r2 * (2.0 * d.k2 + r2 * 3.0 * d.k3)); // of radial by x, divided by x
    const double xx = radial + slope * p.x * p.x + 2.0 * d.p1 * p.y + 6.0 * d.p2 * p.x;
    const double yy = radial + slope * p.y * p.y + 6.0 * d.p1 * p.y + 2.0 * d.p2 * p.x;
    const double xy = slope * p.x * p.y + 2.0 * d.p1 * p.x + 2.0 * d.p2 * p.y;
    return {xx, xy, xy, yy};
}

} // namespace

Pinhole pinholeOf(const glm::dmat4 &clipFromEye, double side, const geometry::Viewport &viewport,
                  const geometry::Surface &surface)
{
    const glm::dmat4 &m = clipFromEye;
    const double w = side * m[2][3]; // of a point at distance 1
    const glm::dvec2 scale = glm::dvec2(m[0][0], m[1][1]) / w, middle = side * glm::dvec2(m[2]) / w;
    Pinhole pinhole;
    pinhole.focal = scale * glm::dvec2(viewport.width, viewport.height) / 2.0;
    pinhole.centre = {viewport.x + (middle.x + 1.0) / 2.0 * viewport.width,
                      surface.heightPixels - viewport.y - (middle.y + 1.0) / 2.0 * viewport.height};
    return pinhole;
}

glm::dvec2 distorted(const cameras::Distortion &d, const glm::dvec2 &p)
{
    const double r2 = glm::dot(p, p), radial = 1.0 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
    return {p.x * radial + 2.0 * d.p1 * p.x * p.y + d.p2 * (r2 + 2.0 * p.x * p.x),
            p.y * radial + d.p1 * (r2 + 2.0 * p.y * p.y) + 2.0 * d.p2 * p.x * p.y};
}

std::optional<glm::dvec2> undistorted(const cameras::Distortion &distortion, const glm::dvec2 &direction)
{
    constexpr int kSteps = 50;
    constexpr double kExact = 1e-13;
    glm::dvec2 p = direction;
    for (int step = 0; step < kSteps; ++step) {
        const glm::dvec2 off = distorted(distortion, p) - direction;
        const glm::dmat2 derivatives = derivativesOf(distortion, p);
        // Beyond the model's greatest radius two directions have one pixel.
        if (!(derivatives[0][0] > 0.0) || !(glm::determinant(derivatives) > 0.0))
            return std::nullopt;
        if (glm::length(off) <= kExact * (1.0 + glm::length(direction)))
            return p;
        p -= glm::inverse(derivatives) * off;
    }
    return std::nullopt;
}

} // namespace unprojector::doctor
