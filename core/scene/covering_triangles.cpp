#include "core/scene/covering_triangles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace unprojector::scene {
namespace {

/// Corners are snapped to 1/256 of a pixel at the coarsest that OpenGL's implementations do; doubled twice.
constexpr double kSnapping = 4.0 / 256.0;
/// What rounding may do to a sum of four products in single precision, and to the quotient of two of them, of the summands'
/// size.
constexpr double kRounding = 0x1p-20;
/// Beyond, a rasteriser may place corners as it likes.
constexpr double kMostPixels = 0x1p20;

} // namespace

CoveringTriangles::CoveringTriangles(const Mesh &mesh, const glm::mat4 &clipFromSource, const glm::ivec4 &viewport,
                                     const glm::dvec3 &reach)
    : m_mesh(mesh), m_lowest(viewport.x, viewport.y), m_highest(viewport.x + viewport.z, viewport.y + viewport.w)
{
    const glm::dmat4 rows = glm::transpose(glm::dmat4(clipFromSource));
    const auto size = [&reach](const glm::dvec4 &row) { return glm::dot(glm::abs(row), glm::dvec4(reach, 1.0)); };
    m_w = rows[3];
    m_sizeOfW = size(m_w);
    // Pixels at once: (x / w + 1) / 2 * width + left.
    const glm::dvec2 half = (m_highest - m_lowest) / 2.0, middle = (m_highest + m_lowest) / 2.0;
    m_x = rows[0] * half.x + m_w * middle.x;
    m_y = rows[1] * half.y + m_w * middle.y;
    m_sizeOfX = size(rows[0]) * half.x;
    m_sizeOfY = size(rows[1]) * half.y;
}

CoveringTriangles::Corner CoveringTriangles::cornerAt(const glm::vec3 &position) const
{
    const glm::dvec4 p(glm::dvec3(position), 1.0);
    const double w = glm::dot(m_w, p);
    if (!(w > 0.0))
        return {{}, std::numeric_limits<double>::infinity()};
    const glm::dvec2 pixel(glm::dot(m_x, p) / w, glm::dot(m_y, p) / w);
    const double width = m_highest.x - m_lowest.x, height = m_highest.y - m_lowest.y;
    const double size = std::max({std::abs(pixel.x), std::abs(pixel.y), width, height});
    if (!(size < kMostPixels))
        return {{}, std::numeric_limits<double>::infinity()};
    return {pixel, kSnapping + kRounding * ((std::max(m_sizeOfX, m_sizeOfY) + size * m_sizeOfW) / w + size)};
}

bool CoveringTriangles::canCover(const std::array<Corner, 3> &corners) const
{
    const double margin = std::max({corners[0].margin, corners[1].margin, corners[2].margin});
    if (std::isinf(margin))
        return true;
    const std::array<glm::dvec2, 3> at{corners[0].pixel, corners[1].pixel, corners[2].pixel};
    const glm::dvec2 lowest = glm::max(glm::min(glm::min(at[0], at[1]), at[2]) - margin, m_lowest);
    const glm::dvec2 highest = glm::min(glm::max(glm::max(at[0], at[1]), at[2]) + margin, m_highest);
    // The first and the last pixel whose centres lie in the box around it.
    const glm::dvec2 first = glm::ceil(lowest - 0.5), last = glm::floor(highest - 0.5);
    if (first.x > last.x || first.y > last.y)
        return false;
    if (first != last)
        return true;
    // A single one: it may still lie beside the triangle, on the outer side of one of its edges.
    const glm::dvec2 centre = first + 0.5;
    const auto cross = [](const glm::dvec2 &a, const glm::dvec2 &b) { return a.x * b.y - a.y * b.x; };
    const double side = cross(at[1] - at[0], at[2] - at[0]) < 0.0 ? -1.0 : 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 edge = at[(k + 1) % 3] - at[k];
        // What the triangle covers with its corners placed elsewhere by the margin is no farther from what it covers here.
        if (side * cross(edge, centre - at[k]) < -margin * (std::abs(edge.x) + std::abs(edge.y)))
            return false;
    }
    return true;
}

void CoveringTriangles::append(std::size_t begin, std::size_t end, std::vector<std::uint32_t> &vertices) const
{
    const bool isIndexed = !m_mesh.indices.empty();
    for (std::size_t first = begin; first < end; first += 3) {
        std::array<std::uint32_t, 3> triangle;
        std::array<Corner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle[k] = isIndexed ? m_mesh.indices[first + k] : static_cast<std::uint32_t>(first + k);
            corners[k] = cornerAt(m_mesh.positions[triangle[k]]);
        }
        if (canCover(corners))
            vertices.insert(vertices.end(), triangle.begin(), triangle.end());
    }
}

} // namespace unprojector::scene
