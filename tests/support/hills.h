#pragma once

#include "tests/support/mesh_model.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

/// A million triangles: hills and valleys over a square of side 4 in the x-y plane.
inline std::shared_ptr<const unprojector::mesh::Model> hills()
{
    constexpr std::uint32_t kSide = 708;
    unprojector::mesh::Mesh mesh;
    for (std::uint32_t j = 0; j <= kSide; ++j) {
        for (std::uint32_t i = 0; i <= kSide; ++i) {
            const float x = 4.0f * float(i) / kSide - 2.0f, y = 4.0f * float(j) / kSide - 2.0f;
            mesh.positions.emplace_back(x, y, 0.3f * std::sin(5.0f * x) * std::cos(4.0f * y));
        }
    }
    for (std::uint32_t j = 0; j < kSide; ++j) {
        for (std::uint32_t i = 0; i < kSide; ++i) {
            const std::uint32_t a = j * (kSide + 1) + i, b = a + 1, c = a + kSide + 1, d = c + 1;
            for (const std::uint32_t corner : {a, b, c, c, b, d})
                mesh.indices.push_back(corner);
        }
    }
    return modelOf(std::move(mesh));
}
