#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace unprojector::geometry {

/// An axis-aligned box, empty until a point is added.
struct Box {
    glm::dvec3 lowest{1.0, 1.0, 1.0};
    glm::dvec3 highest{-1.0, -1.0, -1.0};

    bool isEmpty() const { return lowest.x > highest.x; }
    void add(const glm::dvec3 &point);
    void add(const Box &other);
    glm::dvec3 center() const { return (lowest + highest) / 2.0; }
    /// Length of the diagonal; 0 when empty.
    double diagonal() const;
    /// The axis-aligned box around this box's eight corners after the transform.
    Box transformed(const glm::dmat4 &targetFromSource) const;
};

} // namespace unprojector::geometry
