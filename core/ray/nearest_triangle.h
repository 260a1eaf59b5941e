#pragma once

#include "core/mesh/mesh.h"
#include "core/ray/ray.h"
#include "core/ray/triangle_crossing.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace unprojector::ray {

/// A triangle of a model that a ray meets.
struct TriangleHit {
    std::uint32_t triangle = 0; ///< counted through all meshes, see ElementNumbers
    double t = 0.0;             ///< of the ray
    glm::dvec3 barycentric{0.0};
};

/// The corners of a mesh's triangle, relative to the mesh's origin, exact.
std::array<glm::dvec3, 3> cornersOf(const mesh::Mesh &mesh, std::uint32_t triangle);

/// The barycentric coordinates of a hit, each to double's last digit.
/// @param mesh, triangle  in it, of the hit
glm::dvec3 preciseBarycentric(const mesh::Mesh &mesh, std::uint32_t triangle, const Ray<geometry::ObjectSpace> &ray);

/// Finds, of all triangles that it is shown, the one that a ray meets first; where two are met at the very same t, that
/// of the lower number. The answer does not depend on the order in which they are shown, nor on
/// triangles that the ray does not meet: however a tree picks them, it is the same as for all of them.
class NearestTriangle {
public:
    /// @param model  outlives this
    NearestTriangle(const mesh::Model &model, const Ray<geometry::ObjectSpace> &ray);

    /// @param mesh      that it belongs to
    /// @param triangle  its number in the model
    /// @param corners   relative to the mesh's origin
    /// @return whether it is the nearest so far
    bool test(std::uint32_t mesh, std::uint32_t triangle, const std::array<glm::dvec3, 3> &corners);
    /// What lies beyond this t is no answer any more.
    double high() const { return m_hit ? m_hit->t : m_ray.high; }
    const std::optional<TriangleHit> &hit() const { return m_hit; }

private:
    const mesh::Model &m_model;
    Ray<geometry::ObjectSpace> m_ray;
    std::optional<TriangleHit> m_hit;
    std::uint32_t m_mesh = 0; ///< whose origin m_line is about
    LineCrossing m_line;
};

} // namespace unprojector::ray
