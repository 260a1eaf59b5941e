#pragma once

#include "core/mesh/mesh.h"
#include "core/ray/ray.h"
#include "core/ray/triangle_crossing.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace unprojector::ray {

/// The hit of a ray on a triangle of a model.
struct TriangleHit {
    std::uint32_t triangle = 0; ///< numbered across all meshes, see ElementNumbers
    double t = 0.0;             ///< of the ray
    glm::dvec3 barycentric{0.0};
};

/// The corners of a mesh's triangle, relative to the mesh's origin, exact.
std::array<glm::dvec3, 3> cornersOf(const mesh::Mesh &mesh, std::uint32_t triangle);

/// The barycentric coordinates of a hit, each accurate to the last digit of a double.
/// @param mesh, triangle  of the hit; the triangle's index within the mesh
glm::dvec3 preciseBarycentric(const mesh::Mesh &mesh, std::uint32_t triangle, const Ray<geometry::ObjectSpace> &ray);

/// Finds the triangle that a ray hits first among the triangles tested; of two hit at the same t,
/// the one with the lower number. The answer depends neither on the order of the tests nor on
/// triangles that the ray misses. Any tree therefore gives the same answer as testing all
/// triangles.
class NearestTriangle {
public:
    /// @param model  outlives this
    NearestTriangle(const mesh::Model &model, const Ray<geometry::ObjectSpace> &ray);

    /// Tests one triangle.
    /// @param mesh      of the triangle
    /// @param triangle  its number in the model
    /// @param corners   relative to the mesh's origin
    /// @return whether it is the nearest so far
    bool test(std::uint32_t mesh, std::uint32_t triangle, const std::array<glm::dvec3, 3> &corners);
    /// The largest t that can still be an answer.
    double high() const { return m_hit ? m_hit->t : m_ray.high; }
    const std::optional<TriangleHit> &hit() const { return m_hit; }

private:
    const mesh::Model &m_model;
    Ray<geometry::ObjectSpace> m_ray;
    std::optional<TriangleHit> m_hit;
    std::uint32_t m_mesh = 0; ///< the mesh whose origin m_line is relative to
    LineCrossing m_line;
};

} // namespace unprojector::ray
