#pragma once

#include "core/curves/surface_mesh.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <iterator>
#include <vector>

namespace unprojector::curves {

/// A surface in world space.
class PlacedMesh {
public:
    PlacedMesh(const SurfaceMesh &mesh, const glm::dmat4 &worldFromObject)
        : m_mesh(mesh), m_linear(worldFromObject), m_shift(worldFromObject[3]),
          m_isPlain(worldFromObject == glm::dmat4(1.0))
    {
    }
    const SurfaceMesh *operator->() const { return &m_mesh; }
    glm::dvec3 operator[](std::uint32_t corner) const
    {
        const glm::dvec3 &place = m_mesh.place(corner);
        return m_isPlain ? place : m_linear * place + m_shift;
    }

private:
    const SurfaceMesh &m_mesh;
    glm::dmat3 m_linear;
    glm::dvec3 m_shift;
    bool m_isPlain; ///< the world is the object's space; searches ask for millions of positions
};

/// An end of a path, by its corners: one for a vertex, two for an edge, three inside a triangle.
class PathEnd {
public:
    /// The weighted position in another space, from the corners' positions there.
    template <class Where>
    auto mixed(const Where &where) const
    {
        auto sum = m_weights.front() * where(m_corners.front());
        for (std::size_t i = 1; i < m_corners.size(); ++i)
            sum += m_weights[i] * where(m_corners[i]);
        return sum;
    }

    PathEnd(const PlacedMesh &mesh, const SurfacePlace &place)
    {
        const glm::dvec3 weights = glm::max(place.barycentric, glm::dvec3(0.0));
        const double sum = weights[0] + weights[1] + weights[2];
        for (int i = 0; i < 3; ++i) {
            if (weights[i] > 0.0) {
                m_corners.push_back(mesh->corners(place.triangle)[static_cast<std::size_t>(i)]);
                m_weights.push_back(weights[i] / sum);
            }
        }
        m_place = mixed([&](std::uint32_t corner) { return mesh[corner]; });
        std::ranges::copy_if(mesh->around(m_corners.front()), std::back_inserter(m_triangles),
                             [&](std::uint32_t triangle) { return isIn(mesh->corners(triangle)); });
    }

    const glm::dvec3 &place() const { return m_place; }
    /// The triangles that the end lies in or on.
    const std::vector<std::uint32_t> &triangles() const { return m_triangles; }
    bool isIn(std::uint32_t triangle) const { return std::ranges::find(m_triangles, triangle) != m_triangles.end(); }

private:
    bool isIn(const std::array<std::uint32_t, 3> &corners) const
    {
        return std::ranges::all_of(
            m_corners, [&](std::uint32_t corner) { return std::ranges::find(corners, corner) != corners.end(); });
    }

    std::vector<std::uint32_t> m_corners;
    std::vector<double> m_weights;
    std::vector<std::uint32_t> m_triangles;
    glm::dvec3 m_place{0.0};
};

} // namespace unprojector::curves
