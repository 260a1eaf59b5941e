#pragma once

#include "core/scene/scene.h"

#include <glm/mat3x3.hpp>

#include <cstddef>

namespace unprojector::scene {

/// What a model or a scene amounts to. World space and double precision; sums carry what they round away.
struct Measures {
    /// Of the file, used or not (see Model::fileVertices); of a soup the places at which there are any.
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    double area = 0.0; ///< of all triangles, each from one side
    /// By the divergence theorem: what a closed surface holds, above 0 where its triangles go round counter-clockwise as seen
    /// from outside. Of an open one it says nothing.
    double volume = 0.0;
    /// Certainly not closed: the areas, as vectors along the normals, do not add up to zero, and the volume would be another
    /// one about another origin. An open surface whose openings face each other is not found this way.
    bool isOpen = false;
    geometry::Box box; ///< around the vertices that triangles use and the points; empty without any
    /// Of the box's ends, see halfGapAt.
    glm::dvec3 lowestHalfGap{0.0}, highestHalfGap{0.0};

    void add(const Measures &other);
};

/// Of an object where it stands, hidden or not. A transform that mirrors it leaves the volume's sign as it is.
Measures measuresOf(const SceneObject &object);

/// Of a mesh of floats: numbers that are nearer than this to a coordinate of a vertex are the same float, and the shortest of
/// them is what the file means. World space, each axis; where the mesh is turned, what is left open of a coordinate by the
/// gaps of all three. 0 for a mesh of doubles.
/// @param worldFromSource  the linear part
glm::dvec3 halfGapAt(const mesh::Mesh &mesh, std::size_t vertex, const glm::dmat3 &worldFromSource);

} // namespace unprojector::scene
