#include "core/mesh_import/polygon_triangulation.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <cstddef>
#include <numeric>

namespace unprojector::mesh_import {

namespace {

/// Clipping ears takes the square of the corner count or worse: beyond this a fan must do.
constexpr std::size_t kMostCornersToClip = 512;

double turn(const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners along the axis in which the polygon's area is largest, turned so that it winds anticlockwise.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> corners)
{
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[(i + 1) % corners.size()]) - origin);
    const glm::dvec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const int axis = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double sign = normal[axis] < 0.0 ? -1.0 : 1.0;
    std::vector<glm::dvec2> flat;
    for (const glm::vec3 &corner : corners)
        flat.emplace_back(sign * corner[u], corner[v]);
    return flat;
}

bool isEar(const std::vector<glm::dvec2> &flat, const std::vector<std::uint32_t> &left, std::size_t at)
{
    const std::size_t count = left.size();
    const std::size_t before = (at + count - 1) % count;
    const std::size_t after = (at + 1) % count;
    const glm::dvec2 &a = flat[left[before]];
    const glm::dvec2 &b = flat[left[at]];
    const glm::dvec2 &c = flat[left[after]];
    if (!(turn(a, b, c) > 0.0))
        return false;
    for (std::size_t i = 0; i < count; ++i) {
        if (i == before || i == at || i == after)
            continue;
        const glm::dvec2 &p = flat[left[i]];
        if (p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0)
            return false;
    }
    return true;
}

} // namespace

void triangulatePolygon(std::span<const glm::vec3> corners, std::vector<std::uint32_t> &triangles)
{
    if (corners.size() < 3)
        return;
    std::vector<std::uint32_t> left(corners.size());
    std::iota(left.begin(), left.end(), 0u);
    if (corners.size() > 3 && corners.size() <= kMostCornersToClip) {
        const std::vector<glm::dvec2> flat = flattened(corners);
        // From the second corner on, so that a convex polygon becomes the fan around its first.
        std::size_t at = 1;
        std::size_t misses = 0;
        while (left.size() > 3 && misses < left.size()) {
            at %= left.size();
            if (isEar(flat, left, at)) {
                triangles.insert(triangles.end(),
                                 {left[(at + left.size() - 1) % left.size()], left[at], left[(at + 1) % left.size()]});
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
                misses = 0;
            } else {
                ++at;
                ++misses;
            }
        }
    }
    // A triangle; or what has no ear: crossing itself, without area, or not finite.
    for (std::size_t i = 1; i + 1 < left.size(); ++i)
        triangles.insert(triangles.end(), {left[0], left[i], left[i + 1]});
}

} // namespace unprojector::mesh_import
