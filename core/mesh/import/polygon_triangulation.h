#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace unprojector::mesh {

/// Triangulates polygons by ear clipping, in about linear time for polygons of real files. Its
/// memory is reused for the next polygon.
class PolygonTriangulator {
public:
    /// Appends the triangles, three corner indices each. Correct for any polygon that does not
    /// cross itself, even if it is not exactly planar. A convex polygon becomes the fan around its
    /// first corner; so does one that cannot be clipped: self-crossing, without area, or not
    /// finite.
    void triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t> &triangles);

private:
    struct Wait {
        std::uint32_t corner, next;
    };

    void flatten(std::span<const glm::vec3> corners);
    bool isConvex() const;
    void clip(std::vector<std::uint32_t> &triangles);
    void sortIntoCells();
    std::size_t cellAlong(int axis, double value) const;
    template <class Visitor>
    bool visitNearby(const glm::dvec2 &lowest, const glm::dvec2 &highest, const Visitor &visit) const;
    std::uint32_t blockerOf(std::uint32_t corner) const;

    std::vector<glm::dvec2> m_flat;      ///< anticlockwise, in the plane in which the polygon is largest
    std::vector<std::uint32_t> m_before; ///< the remaining corners as a ring
    std::vector<std::uint32_t> m_after;
    std::vector<bool> m_isLeft;
    std::vector<std::uint32_t> m_waiting; ///< by corner: the first in m_waits whose ear it blocks
    std::vector<Wait> m_waits;
    std::deque<std::uint32_t> m_candidates;
    std::vector<bool> m_isCandidate;
    std::vector<bool> m_isNextToCut;

    glm::dvec2 m_lowest{0.0}, m_cellSize{0.0};
    std::size_t m_cellsAlong = 1;
    std::vector<std::uint32_t> m_cellBegin; ///< into m_cellCorners, one more than there are cells
    std::vector<std::uint32_t> m_cellCorners;
};

} // namespace unprojector::mesh
