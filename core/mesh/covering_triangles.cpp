#include "core/mesh/covering_triangles.h"

#include "core/base/parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::mesh {
namespace {

/// OpenGL implementations snap corners to 1/256 of a pixel at the coarsest; doubled twice as a
/// margin.
constexpr float kSnapping = 4.0F / 256.0F;
/// The relative rounding error of a sum of four products in single precision, and of the quotient
/// of two such sums: OpenGL's and this code's.
constexpr float kRounding = 0x1p-19F;
/// Beyond this size, the position of corners in a rasteriser is undefined.
constexpr float kMostPixels = 0x1p20F;
/// The maximum number of pixel centres to test one by one.
constexpr int kMostCentres = 4;

float dotWithPoint(const glm::vec4 &row, const glm::vec3 &point)
{
    return row.x * point.x + row.y * point.y + row.z * point.z + row.w;
}

} // namespace

CoveringTriangles::CoveringTriangles(const Mesh &mesh, const glm::mat4 &clipFromSource, const glm::ivec4 &viewport,
                                     const glm::dvec3 &reach)
    : m_mesh(mesh), m_width(static_cast<float>(viewport.z)), m_height(static_cast<float>(viewport.w))
{
    const glm::dmat4 rows = glm::transpose(glm::dmat4(clipFromSource));
    const auto size = [&reach](const glm::dvec4 &row) { return glm::dot(glm::abs(row), glm::dvec4(reach, 1.0)); };
    // Maps to pixels in one step: (x / w + 1) / 2 * width.
    const glm::dvec2 half(viewport.z / 2.0, viewport.w / 2.0);
    m_x = glm::vec4((rows[0] + rows[3]) * half.x);
    m_y = glm::vec4((rows[1] + rows[3]) * half.y);
    m_w = glm::vec4(rows[3]);
    m_sizeOfXY = static_cast<float>(std::max(size(rows[0]) * half.x, size(rows[1]) * half.y));
    m_sizeOfW = static_cast<float>(size(rows[3]));
}

CoveringTriangles::Corner CoveringTriangles::cornerAt(const glm::vec3 &position) const
{
    const float w = dotWithPoint(m_w, position), share = 1.0F / w;
    const float x = dotWithPoint(m_x, position) * share, y = dotWithPoint(m_y, position) * share;
    const float size = std::max({std::abs(x), std::abs(y), m_width, m_height});
    if (!(w > 0.0F) || !(size < kMostPixels))
        return {0.0F, 0.0F, std::numeric_limits<float>::infinity()};
    return {x, y, kSnapping + kRounding * ((m_sizeOfXY + size * m_sizeOfW) * share + size)};
}

bool CoveringTriangles::canCover(const Corner &a, const Corner &b, const Corner &c) const
{
    const float margin = std::max({a.margin, b.margin, c.margin});
    if (!(margin < kMostPixels))
        return true;
    // The first pixel whose centre lies in the bounding box, and the one after the last.
    const auto pixelsFrom = [margin](float lowest) { return static_cast<int>(std::max(lowest - margin + 0.5F, 0.0F)); };
    const auto pixelsTo = [margin](float highest, float rim) {
        return static_cast<int>(std::max(std::min(highest + margin, rim) + 0.5F, 0.0F));
    };
    const int left = pixelsFrom(std::min({a.x, b.x, c.x})), right = pixelsTo(std::max({a.x, b.x, c.x}), m_width);
    const int bottom = pixelsFrom(std::min({a.y, b.y, c.y})), top = pixelsTo(std::max({a.y, b.y, c.y}), m_height);
    if (left >= right || bottom >= top)
        return false;
    if (right - left > kMostCentres || (right - left) * (top - bottom) > kMostCentres)
        return true;
    // The centres may still all lie outside one of the triangle's edges.
    const float turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const float side = turn < 0.0F ? -1.0F : 1.0F;
    const auto isOutside = [side, margin](const Corner &from, const Corner &to, float x, float y) {
        const float alongX = to.x - from.x, alongY = to.y - from.y;
        // A triangle with corners shifted by up to the margin covers only points within the margin
        // of this one.
        return side * (alongX * (y - from.y) - alongY * (x - from.x)) < -margin * (std::abs(alongX) + std::abs(alongY));
    };
    for (int j = bottom; j < top; ++j) {
        for (int i = left; i < right; ++i) {
            const float x = static_cast<float>(i) + 0.5F, y = static_cast<float>(j) + 0.5F;
            if (!isOutside(a, b, x, y) && !isOutside(b, c, x, y) && !isOutside(c, a, x, y))
                return true;
        }
    }
    return false;
}

void CoveringTriangles::placeVertices()
{
    base::fillInParallel(m_placed, m_mesh.positions.size(), {}, [this](std::size_t begin, std::size_t end) {
        for (std::size_t vertex = begin; vertex < end; ++vertex)
            m_placed[vertex] = cornerAt(m_mesh.positions[vertex]);
    });
}

void CoveringTriangles::append(std::size_t begin, std::size_t end, std::vector<std::uint32_t> &vertices) const
{
    const auto cornerOf = [this](std::uint32_t vertex) {
        return m_placed.empty() ? cornerAt(m_mesh.positions[vertex]) : m_placed[vertex];
    };
    std::size_t used = vertices.size();
    vertices.resize(used + (end - begin));
    for (std::size_t first = begin; first < end; first += 3) {
        // Always writes the corners; the next triangle overwrites them if this one covers nothing.
        // Half of the triangles cover nothing, in no order.
        for (std::size_t k = 0; k < 3; ++k)
            vertices[used + k] = static_cast<std::uint32_t>(m_mesh.vertexAt(first + k));
        const bool isNeeded =
            canCover(cornerOf(vertices[used]), cornerOf(vertices[used + 1]), cornerOf(vertices[used + 2]));
        used += isNeeded ? 3 : 0;
    }
    vertices.resize(used);
}

} // namespace unprojector::mesh
