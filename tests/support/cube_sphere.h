#pragma once

#include "core/mesh/mesh.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

/// A closed surface of 12 n^2 triangles, counter-clockwise from outside, every vertex shared: the
/// six sides of a cube projected onto a sphere of radius 1, with hills of the given height.
inline std::shared_ptr<unprojector::mesh::Model> cubeSphere(std::uint32_t n, double hills = 0.05)
{
    auto model = std::make_shared<unprojector::mesh::Model>();
    model->name = "cube sphere";
    unprojector::mesh::Mesh mesh;
    // The points of the cube's surface, numbered layer by layer; those inside have no number.
    const auto isInside = [n](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return i > 0 && i < n && j > 0 && j < n && k > 0 && k < n;
    };
    const std::uint32_t side = n + 1;
    // The first and the last layer are full, those between them have their rims only.
    const auto numberOf = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        if (k == 0)
            return j * side + i;
        const std::uint32_t before = side * side + (k - 1) * 4 * n;
        if (k == n)
            return before + j * side + i;
        if (j == 0)
            return before + i;
        if (j == n)
            return before + side + 2 * (n - 1) + i;
        return before + side + 2 * (j - 1) + (i == 0 ? 0 : 1);
    };
    mesh.positions.resize(std::size_t{2} * side * side + std::size_t{4} * n * (n - 1));
    const auto place = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        const auto along = [n](std::uint32_t step) { return std::tan((2.0 * step / n - 1.0) * std::atan(1.0)); };
        const glm::dvec3 p = glm::normalize(glm::dvec3(along(i), along(j), along(k)));
        const double height = 1.0 + hills * std::sin(9.0 * p.x) * std::sin(11.0 * p.y) * std::sin(10.0 * p.z + 0.5);
        mesh.positions[numberOf(i, j, k)] = glm::vec3(p * height);
    };
    for (std::uint32_t k = 0; k <= n; ++k) {
        for (std::uint32_t j = 0; j <= n; ++j) {
            for (std::uint32_t i = 0; i <= n; ++i) {
                if (!isInside(i, j, k))
                    place(i, j, k);
                else
                    i = n - 1; // to the other rim
            }
        }
    }
    mesh.indices.reserve(std::size_t{36} * n * n);
    const auto square = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    };
    for (std::uint32_t v = 0; v < n; ++v) {
        for (std::uint32_t u = 0; u < n; ++u) {
            const std::uint32_t p = u + 1, q = v + 1;
            square(numberOf(u, v, n), numberOf(p, v, n), numberOf(p, q, n), numberOf(u, q, n));
            square(numberOf(u, q, 0), numberOf(p, q, 0), numberOf(p, v, 0), numberOf(u, v, 0));
            square(numberOf(n, u, v), numberOf(n, p, v), numberOf(n, p, q), numberOf(n, u, q));
            square(numberOf(0, u, q), numberOf(0, p, q), numberOf(0, p, v), numberOf(0, u, v));
            square(numberOf(v, n, p), numberOf(q, n, p), numberOf(q, n, u), numberOf(v, n, u));
            square(numberOf(v, 0, u), numberOf(q, 0, u), numberOf(q, 0, p), numberOf(v, 0, p));
        }
    }
    model->meshes.push_back(std::move(mesh));
    model->bounds = boundsOf(model->meshes);
    return model;
}
