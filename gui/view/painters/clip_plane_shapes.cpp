#include "gui/view/painters/clip_plane_shapes.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr glm::vec4 kFaceColor{0.45f, 0.30f, 0.70f, 0.09f};
constexpr glm::vec4 kBorderColor{0.45f, 0.30f, 0.70f, 0.60f};
/// Relative to the box's half diagonal: slightly more than the box, for any direction of the plane.
constexpr double kReach = 1.1;

std::vector<glm::dvec3> squareOf(const glm::dvec4 &plane, const Box &box)
{
    const double length = glm::length(glm::dvec3(plane));
    const glm::dvec3 normal = glm::dvec3(plane) / length;
    const glm::dvec3 middle = box.center() - normal * (glm::dot(normal, box.center()) + plane.w / length);
    // One edge is level, unless the plane itself is.
    const glm::dvec3 up = std::abs(normal.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const double reach = kReach * (box.diagonal() > 0.0 ? box.diagonal() / 2.0 : 0.5);
    const glm::dvec3 side = glm::normalize(glm::cross(up, normal)) * reach;
    const glm::dvec3 other = glm::cross(normal, side);
    return {middle - side - other, middle + side - other, middle + side + other, middle - side + other};
}

/// The part of a convex polygon on the positive side of a plane.
std::vector<glm::dvec3> cut(const std::vector<glm::dvec3> &polygon, const glm::dvec4 &plane)
{
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = glm::dot(plane, glm::dvec4(from, 1.0)), b = glm::dot(plane, glm::dvec4(to, 1.0));
        if (a >= 0.0)
            kept.push_back(from);
        if ((a < 0.0) != (b < 0.0))
            kept.push_back(from + (to - from) * (a / (a - b)));
    }
    return kept;
}

} // namespace

ClipPlaneShape clipPlaneShape(const glm::dvec4 &plane, const Box &box, const std::vector<glm::dvec4> &bounds)
{
    ClipPlaneShape shape;
    if (box.isEmpty())
        return shape;
    std::vector<glm::dvec3> polygon = squareOf(plane, box);
    for (const glm::dvec4 &bound : bounds)
        polygon = cut(polygon, bound);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        shape.border.push_back({polygon[i], polygon[(i + 1) % polygon.size()], kBorderColor});
    // A triangle fan; a face has four corners, of which two coincide.
    for (std::size_t i = 2; i < polygon.size(); ++i)
        shape.faces.push_back({{polygon[0], polygon[i - 1], polygon[i], polygon[i]}, kFaceColor});
    return shape;
}

} // namespace unprojector::gui
