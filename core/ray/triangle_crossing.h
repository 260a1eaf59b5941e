#pragma once

#include <glm/vec3.hpp>

#include <optional>

namespace unprojector::ray {

/// Where a line crosses a triangle.
struct Crossing {
    double t;               ///< of the line
    glm::dvec3 barycentric; ///< of the three corners, none below 0, their sum 1
};

/// A line, prepared for many triangles. All of it is in one space, about one origin.
///
/// Space is sheared so that the line becomes an axis; it crosses a triangle where the three edges go round that axis in
/// one sense (Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection"). The sign of an edge is exact: where double
/// precision cannot tell it, 30 digits do. Triangles that share an edge therefore agree on which side of it the line passes,
/// and no line slips through between them; one that meets the edge itself crosses both.
class LineCrossing {
public:
    /// @param along  not 0
    LineCrossing(const glm::dvec3 &from, const glm::dvec3 &along);

    /// Either side of the triangle counts.
    /// @return nothing beside the triangle, and for one that the line sees edge on or that has no area
    std::optional<Crossing> with(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) const;
    /// The barycentric coordinates of where it crosses a triangle, each to double's last digit: however thin the triangle is,
    /// the place is on the line.
    /// @pre `with` finds a crossing
    glm::dvec3 preciseBarycentric(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) const;

private:
    struct Sheared {
        double x, y, z;
        double size; ///< what the rounding of x and y goes by
    };
    Sheared sheared(const glm::dvec3 &corner) const;
    double preciseEdge(const glm::dvec3 &b, const glm::dvec3 &c) const;

    glm::dvec3 m_from, m_along;
    int m_x, m_y, m_z; ///< the line goes farthest along axis m_z
    double m_shearX, m_shearY;
};

} // namespace unprojector::ray
