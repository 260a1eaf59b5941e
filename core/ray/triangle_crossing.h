#pragma once

#include <glm/vec3.hpp>

#include <optional>

namespace unprojector::ray {

/// The intersection of a line with a triangle.
struct Crossing {
    double t;               ///< of the line
    glm::dvec3 barycentric; ///< of the three corners, none below 0, their sum 1
};

/// A line, prepared for intersection with many triangles. All coordinates are in one space and
/// relative to one origin.
///
/// Space is sheared so that the line becomes an axis. The line crosses a triangle if the three
/// edges go round that axis in one sense (Woop, Benthin, Wald 2013, "Watertight Ray/Triangle
/// Intersection"). The sign of an edge is exact: 30 digits decide it if double precision cannot.
/// Triangles that share an edge therefore agree on the side on which the line passes, and no line
/// slips between them. A line that meets the edge itself crosses both.
class LineCrossing {
public:
    /// @param along  not 0
    LineCrossing(const glm::dvec3 &from, const glm::dvec3 &along);

    /// The intersection from either side of the triangle.
    /// @return nothing if the line misses the triangle, sees it edge on, or the triangle has no
    ///         area
    std::optional<Crossing> with(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) const;
    /// The barycentric coordinates of the intersection, each accurate to the last digit of a
    /// double: the point lies on the line even for very thin triangles.
    /// @pre `with` finds a crossing
    glm::dvec3 preciseBarycentric(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) const;

private:
    struct Sheared {
        double x, y, z;
        double size; ///< the scale of the rounding of x and y
    };
    Sheared sheared(const glm::dvec3 &corner) const;
    double preciseEdge(const glm::dvec3 &b, const glm::dvec3 &c) const;

    glm::dvec3 m_from, m_along;
    int m_x, m_y, m_z; ///< the largest component of the line's direction is along axis m_z
    double m_shearX, m_shearY;
};

} // namespace unprojector::ray
