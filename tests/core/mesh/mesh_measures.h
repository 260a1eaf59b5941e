#pragma once

#include "core/mesh/mesh.h"

#include <glm/geometric.hpp>
#include <glm/gtc/epsilon.hpp>
#include <glm/vector_relational.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

/// Measures that the tests of the bundled meshes share: a mesh's triangles, its edges after
/// welding, and its volume.
namespace mesh_measures {

using Place = std::tuple<float, float, float>;

// Positions are floats of size up to 4: their rounding is at most 2.4e-7, and a few of them add up.
inline constexpr double kFloatTolerance = 1e-6;

inline constexpr int kTeapotDivisions = 10;

inline glm::dvec3 corner(const unprojector::mesh::Mesh &mesh, std::size_t index)
{
    return mesh.position(mesh.vertexAt(index));
}

inline std::array<glm::dvec3, 3> triangle(const unprojector::mesh::Mesh &mesh, std::size_t number)
{
    return {corner(mesh, 3 * number), corner(mesh, 3 * number + 1), corner(mesh, 3 * number + 2)};
}

/// Vertices at one place are one.
inline Place place(const glm::dvec3 &point)
{
    // Adding zero turns -0 into 0. Both compare equal; this is only for printing.
    const glm::vec3 p = glm::vec3(point) + 0.0f;
    return {p.x, p.y, p.z};
}

/// The signed volume, by the divergence theorem: positive when a closed mesh is counter-clockwise
/// from outside.
inline double signedVolume(const unprojector::mesh::Mesh &mesh)
{
    double volume = 0.0;
    for (std::size_t number = 0; number < mesh.triangleCount(); ++number) {
        const auto t = triangle(mesh, number);
        volume += glm::dot(t[0], glm::cross(t[1], t[2])) / 6.0;
    }
    return volume;
}

/// The number of occurrences of each directed edge, after welding.
inline std::map<std::pair<Place, Place>, int> directedEdges(const unprojector::mesh::Mesh &mesh)
{
    std::map<std::pair<Place, Place>, int> edges;
    for (std::size_t number = 0; number < mesh.triangleCount(); ++number) {
        const auto t = triangle(mesh, number);
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{place(t[i]), place(t[(i + 1) % 3])}];
    }
    return edges;
}

inline bool isNear(const glm::dvec3 &a, const glm::dvec3 &b, double tolerance = kFloatTolerance)
{
    return glm::all(glm::epsilonEqual(a, b, tolerance));
}

} // namespace mesh_measures
