#pragma once

#include "core/ray/ray_caster.h"
#include "tests/support/mesh_model.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

// Meshes that rays are aimed at, and the answer without any tree.
namespace ray_meshes {

using ObjectVector = unprojector::geometry::Vector<unprojector::geometry::ObjectSpace>;

using ::modelOf;

inline std::shared_ptr<unprojector::mesh::Model> modelOf(const std::vector<glm::vec3> &positions,
                                                         std::vector<std::uint32_t> indices = {})
{
    unprojector::mesh::Mesh mesh;
    mesh.positions = positions;
    mesh.indices = std::move(indices);
    return modelOf(std::move(mesh));
}

/// A surface over [0, 1] x [0, 1] whose rims meet, with every vertex shared: it has no open edge
/// where it wraps around.
inline std::shared_ptr<unprojector::mesh::Model> wrapped(std::uint32_t n,
                                                         const std::function<glm::dvec3(double, double)> &at)
{
    unprojector::mesh::Mesh mesh;
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i)
            mesh.positions.emplace_back(at(double(i) / n, double(j) / n));
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t p = (i + 1) % n, q = (j + 1) % n;
            const std::uint32_t a = j * n + i, b = j * n + p, c = q * n + p, d = q * n + i;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
    }
    return modelOf(std::move(mesh));
}

constexpr double kTurn = 6.283185307179586;

inline std::shared_ptr<unprojector::mesh::Model> torus(std::uint32_t n)
{
    return wrapped(n, [](double u, double v) {
        const double ring = 1.0 + 0.4 * std::cos(kTurn * v);
        return glm::dvec3(ring * std::cos(kTurn * u), ring * std::sin(kTurn * u), 0.4 * std::sin(kTurn * v));
    });
}

/// Triangles of all sizes and shapes anywhere, some of them without an area; in double precision.
inline std::shared_ptr<unprojector::mesh::Model> soup(std::size_t count, std::uint64_t seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> place(-1.0, 1.0), size(-4.0, -0.5);
    std::vector<glm::dvec3> positions;
    const auto anywhere = [&] { return glm::dvec3(place(engine), place(engine), place(engine)); };
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 center = anywhere();
        const double extent = std::pow(10.0, size(engine));
        const glm::dvec3 a = center + extent * anywhere(), b = center + extent * anywhere();
        positions.insert(positions.end(), {a, b, i % 16 == 0 ? a : i % 16 == 1 ? 2.0 * b - a : center});
    }
    unprojector::mesh::Mesh mesh;
    setPositions(mesh, glm::dvec3(0.0), positions);
    return modelOf(std::move(mesh));
}

/// The nearest of all triangles, each tested.
inline std::optional<unprojector::ray::TriangleHit>
testingAll(const unprojector::mesh::Model &model, const unprojector::ray::Ray<unprojector::geometry::ObjectSpace> &ray)
{
    unprojector::ray::NearestTriangle nearest(model, ray);
    std::uint32_t number = 0;
    for (std::uint32_t mesh = 0; mesh < model.meshes.size(); ++mesh) {
        for (std::uint32_t i = 0; i < model.meshes[mesh].triangleCount(); ++i)
            nearest.test(mesh, number++, unprojector::ray::cornersOf(model.meshes[mesh], i));
    }
    return nearest.hit();
}

inline bool isSame(const std::optional<unprojector::ray::TriangleHit> &a,
                   const std::optional<unprojector::ray::TriangleHit> &b)
{
    if (!a || !b)
        return !a && !b;
    return a->triangle == b->triangle && a->t == b->t && a->barycentric == b->barycentric;
}

/// Random numbers for rays.
class Aim {
public:
    explicit Aim(std::uint64_t seed) : m_engine(seed) {}

    glm::dvec3 direction()
    {
        return glm::normalize(glm::dvec3(m_normal(m_engine), m_normal(m_engine), m_normal(m_engine)));
    }
    double share() { return m_share(m_engine); }
    std::size_t below(std::size_t count) { return m_engine() % count; }

    /// A ray from somewhere around a centre to a point and as far again behind it.
    unprojector::ray::Ray<unprojector::geometry::ObjectSpace> at(const glm::dvec3 &target, const glm::dvec3 &center,
                                                                 double distance)
    {
        const glm::dvec3 eye = center + distance * direction();
        return {unprojector::geometry::ObjectPoint(eye), ObjectVector(target - eye), 0.0, 2.0};
    }

private:
    std::mt19937_64 m_engine;
    std::normal_distribution<double> m_normal;
    std::uniform_real_distribution<double> m_share;
};

} // namespace ray_meshes
