#include "core/mesh/import/polygon_triangulation.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace unprojector::mesh {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
/// Up to about this many corners, a linear scan is faster than cells.
constexpr std::size_t kFewCorners = 48;

double turn(const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

} // namespace

void PolygonTriangulator::flatten(std::span<const glm::vec3> corners)
{
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[(i + 1) % corners.size()]) - origin);
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double sign = normal[axis] < 0.0 ? -1.0 : 1.0;
    m_flat.clear();
    for (const glm::vec3 &corner : corners)
        m_flat.emplace_back(sign * static_cast<double>(corner[u]), static_cast<double>(corner[v]));
}

/// Returns whether the polygon turns left everywhere, and once around in all.
bool PolygonTriangulator::isConvex() const
{
    const std::size_t count = m_flat.size();
    std::size_t changes = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 &a = m_flat[i];
        const glm::dvec2 &b = m_flat[(i + 1) % count];
        const glm::dvec2 &c = m_flat[(i + 2) % count];
        if (!(turn(a, b, c) > 0.0))
            return false;
        changes += (b.x > a.x) != (c.x > b.x);
    }
    return changes <= 2;
}

std::size_t PolygonTriangulator::cellAlong(int axis, double value) const
{
    const double cell = (value - m_lowest[axis]) / m_cellSize[axis];
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(m_cellsAlong - 1)));
}

/// Sorts the corners into square cells, about one a cell.
void PolygonTriangulator::sortIntoCells()
{
    m_lowest = m_flat[0];
    glm::dvec2 highest = m_flat[0];
    for (const glm::dvec2 &corner : m_flat) {
        m_lowest = glm::min(m_lowest, corner);
        highest = glm::max(highest, corner);
    }
    m_cellsAlong = static_cast<std::size_t>(std::sqrt(static_cast<double>(m_flat.size())));
    m_cellSize = (highest - m_lowest) / static_cast<double>(m_cellsAlong);
    for (int axis = 0; axis < 2; ++axis) {
        if (!(m_cellSize[axis] > 0.0))
            m_cellSize[axis] = 1.0;
    }
    m_cellBegin.assign(m_cellsAlong * m_cellsAlong + 1, 0);
    const auto cellOf = [this](const glm::dvec2 &corner) {
        return cellAlong(1, corner.y) * m_cellsAlong + cellAlong(0, corner.x);
    };
    for (const glm::dvec2 &corner : m_flat)
        ++m_cellBegin[cellOf(corner) + 1];
    std::partial_sum(m_cellBegin.begin(), m_cellBegin.end(), m_cellBegin.begin());
    m_cellCorners.resize(m_flat.size());
    // Goes backward, so that the begin of each cell ends up in place.
    for (std::size_t i = m_flat.size(); i-- > 0;)
        m_cellCorners[--m_cellBegin[cellOf(m_flat[i]) + 1]] = static_cast<std::uint32_t>(i);
    std::rotate(m_cellBegin.begin(), m_cellBegin.begin() + 1, m_cellBegin.end());
    m_cellBegin.back() = static_cast<std::uint32_t>(m_flat.size());
}

/// Visits all corners in a box, and some others; stops when the visitor returns true.
template <class Visitor>
bool PolygonTriangulator::visitNearby(const glm::dvec2 &lowest, const glm::dvec2 &highest, const Visitor &visit) const
{
    const std::size_t lastColumn = cellAlong(0, highest.x);
    const std::size_t lastRow = cellAlong(1, highest.y);
    for (std::size_t row = cellAlong(1, lowest.y); row <= lastRow; ++row) {
        const std::size_t begin = m_cellBegin[row * m_cellsAlong + cellAlong(0, lowest.x)];
        const std::size_t end = m_cellBegin[row * m_cellsAlong + lastColumn + 1];
        for (std::size_t i = begin; i < end; ++i) {
            if (visit(m_cellCorners[i]))
                return true;
        }
    }
    return false;
}

/// A corner that prevents this one from being an ear; itself if it is reflex; none if it is an ear.
std::uint32_t PolygonTriangulator::blockerOf(std::uint32_t corner) const
{
    const std::uint32_t before = m_before[corner];
    const std::uint32_t after = m_after[corner];
    const glm::dvec2 &a = m_flat[before];
    const glm::dvec2 &b = m_flat[corner];
    const glm::dvec2 &c = m_flat[after];
    if (!(turn(a, b, c) > 0.0))
        return corner;
    std::uint32_t blocker = kNone;
    const auto blocks = [&](std::uint32_t other) {
        const glm::dvec2 &p = m_flat[other];
        if (!m_isLeft[other] || p == a || p == b || p == c || turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0
            || turn(c, a, p) < 0.0)
            return false;
        blocker = other;
        return true;
    };
    if (m_flat.size() > kFewCorners) {
        visitNearby(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), blocks);
        return blocker;
    }
    for (std::uint32_t other = m_after[after]; other != before; other = m_after[other]) {
        if (blocks(other))
            break;
    }
    return blocker;
}

/// Cuts ears. A corner is tested again only after a neighbour or the corner that blocked its ear
/// was cut.
void PolygonTriangulator::clip(std::vector<std::uint32_t> &triangles)
{
    const auto count = static_cast<std::uint32_t>(m_flat.size());
    m_before.resize(count);
    m_after.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        m_before[i] = (i + count - 1) % count;
        m_after[i] = (i + 1) % count;
    }
    m_isLeft.assign(count, true);
    m_isCandidate.assign(count, true);
    m_waiting.assign(count, kNone);
    m_isNextToCut.assign(count, false);
    m_waits.clear();
    if (count > kFewCorners)
        sortIntoCells();
    m_candidates.clear();
    for (std::uint32_t i = 1; i <= count; ++i)
        m_candidates.push_back(i % count);

    const auto lookAgainAt = [this](std::uint32_t corner) {
        if (m_isLeft[corner] && !m_isCandidate[corner]) {
            m_isCandidate[corner] = true;
            m_candidates.push_back(corner);
        }
    };
    std::uint32_t left = count;
    std::uint32_t last = 0;
    while (left > 3 && !m_candidates.empty()) {
        const std::uint32_t corner = m_candidates.front();
        m_candidates.pop_front();
        if (!m_isLeft[corner])
            continue;
        // A neighbour was just cut: others go first. Otherwise all ears along the outline would end
        // in one far corner, with long triangles and many corners to test.
        if (m_isNextToCut[corner]) {
            m_isNextToCut[corner] = false;
            m_candidates.push_back(corner);
            continue;
        }
        m_isCandidate[corner] = false;
        const std::uint32_t blocker = blockerOf(corner);
        if (blocker == corner)
            continue;
        if (blocker != kNone) {
            m_waits.push_back({corner, m_waiting[blocker]});
            m_waiting[blocker] = static_cast<std::uint32_t>(m_waits.size() - 1);
            continue;
        }
        const std::uint32_t before = m_before[corner];
        const std::uint32_t after = m_after[corner];
        triangles.insert(triangles.end(), {before, corner, after});
        m_after[before] = after;
        m_before[after] = before;
        m_isLeft[corner] = false;
        --left;
        last = before;
        for (const std::uint32_t neighbour : {before, after}) {
            m_isNextToCut[neighbour] = m_isCandidate[neighbour];
            lookAgainAt(neighbour);
        }
        for (std::uint32_t wait = m_waiting[corner]; wait != kNone; wait = m_waits[wait].next)
            lookAgainAt(m_waits[wait].corner);
    }
    // The last triangle, or a rest without ears.
    const std::uint32_t first = left == count ? 0 : last;
    for (std::uint32_t i = m_after[first]; m_after[i] != first; i = m_after[i])
        triangles.insert(triangles.end(), {first, i, m_after[i]});
}

void PolygonTriangulator::triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t> &triangles)
{
    if (corners.size() < 3)
        return;
    bool canClip = corners.size() > 3;
    if (canClip) {
        flatten(corners);
        canClip =
            std::all_of(m_flat.begin(), m_flat.end(),
                        [](const glm::dvec2 &corner) { return std::isfinite(corner.x) && std::isfinite(corner.y); })
            && !isConvex();
    }
    if (canClip) {
        clip(triangles);
        return;
    }
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i)
        triangles.insert(triangles.end(), {0, i, i + 1});
}

} // namespace unprojector::mesh
