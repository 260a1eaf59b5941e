#pragma once

#include "core/scene/scene.h"

#include <glm/mat3x3.hpp>

#include <cstddef>

namespace unprojector::scene {

/// The measures of a model or a scene. World space and double precision; sums use compensated
/// summation.
struct Measures {
    /// The vertex count of the file, used or not (see Model::fileVertices); for a triangle soup,
    /// the number of different positions.
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    double area = 0.0; ///< of all triangles, one side each
    /// The enclosed volume, by the divergence theorem. It is positive if the triangles are
    /// counter-clockwise seen from outside. It is meaningless for an open surface.
    double volume = 0.0;
    /// True if the surface is certainly not closed: the area vectors along the normals don't add up
    /// to zero, so the volume would depend on the origin. An open surface whose openings face each
    /// other is not detected.
    bool isOpen = false;
    geometry::Box box; ///< around the points and the vertices that triangles use; empty without any
    /// The half gaps at the ends of the box, see halfGapAt.
    glm::dvec3 lowestHalfGap{0.0}, highestHalfGap{0.0};

    void add(const Measures &other);
};

/// The measures of an object in its position, hidden or not. A mirroring transform leaves the
/// volume's sign unchanged.
Measures measuresOf(const SceneObject &object);

/// Half the gap between floats at a vertex of a mesh of floats. Numbers nearer than this to a
/// coordinate are the same float, and the shortest of them is what the file means. World space,
/// each axis; if the mesh is rotated, combined from the gaps of all three axes. 0 for a mesh of
/// doubles.
/// @param worldFromSource  the linear part
glm::dvec3 halfGapAt(const mesh::Mesh &mesh, std::size_t vertex, const glm::dmat3 &worldFromSource);

} // namespace unprojector::scene
