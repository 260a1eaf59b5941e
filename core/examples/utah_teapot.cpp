#include "core/base/resource.h"
#include "core/examples/solids.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <cassert>
#include <cstddef>

namespace unprojector::examples {
using namespace mesh;

namespace {

/// The cubic Bernstein polynomials at t, exact at 0 and 1, where patches that share an edge must
/// agree.
std::array<double, 4> weights(double t)
{
    const double s = 1.0 - t;
    return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

std::array<double, 4> weightDerivatives(double t)
{
    const double s = 1.0 - t;
    return {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t};
}

glm::dvec3 combined(const BezierPatch &patch, const std::array<double, 4> &alongU, const std::array<double, 4> &alongV)
{
    glm::dvec3 sum{0.0};
    for (std::size_t v = 0; v < 4; ++v) {
        for (std::size_t u = 0; u < 4; ++u)
            sum += alongV[v] * alongU[u] * patch[v][u];
    }
    return sum;
}

glm::dvec3 normalAt(const BezierPatch &patch, double u, double v)
{
    const glm::dvec3 alongU = combined(patch, weightDerivatives(u), weights(v));
    const glm::dvec3 alongV = combined(patch, weights(u), weightDerivatives(v));
    const glm::dvec3 normal = glm::cross(alongU, alongV);
    // Sixteen rounded terms need not cancel to zero on an edge that is one point.
    constexpr double kNoLength = 1e-12;
    if (v > 0.0 || glm::length(alongU) > kNoLength)
        return glm::normalize(normal);
    // Near v = 0 dP/du is v d2P/dudv there, and the positive v does not change the direction.
    return glm::normalize(glm::cross(combined(patch, weightDerivatives(u), weightDerivatives(v)), alongV));
}

void addPatch(Mesh &mesh, const BezierPatch &patch, int divisions)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = 0; row <= divisions; ++row) {
        for (int column = 0; column <= divisions; ++column) {
            const double u = static_cast<double>(column) / divisions;
            const double v = static_cast<double>(row) / divisions;
            mesh.positions.emplace_back(combined(patch, weights(u), weights(v)));
            mesh.normals.emplace_back(normalAt(patch, u, v));
        }
    }

    const auto addTriangle = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto &p = mesh.positions;
        if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a])
            mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    const auto stride = static_cast<std::uint32_t>(divisions) + 1;
    for (std::uint32_t row = 0; row + 1 < stride; ++row) {
        for (std::uint32_t column = 0; column + 1 < stride; ++column) {
            const std::uint32_t corner = first + row * stride + column;
            addTriangle(corner, corner + 1, corner + stride);
            addTriangle(corner + 1, corner + stride + 1, corner + stride);
        }
    }
}

} // namespace

std::vector<BezierPatch> utahTeapotPatches()
{
    const auto json = nlohmann::json::parse(base::resource("examples/utah_teapot.json"));
    const auto points = json.at("points").get<std::vector<std::array<double, 3>>>();
    std::vector<BezierPatch> patches;
    for (const auto &indices : json.at("patches").get<std::vector<std::array<std::size_t, 16>>>()) {
        BezierPatch &patch = patches.emplace_back();
        for (std::size_t i = 0; i < indices.size(); ++i)
            patch[i / 4][i % 4] = glm::make_vec3(points.at(indices[i]).data());
    }
    return patches;
}

Mesh utahTeapotMesh(int divisionsPerSide)
{
    assert(divisionsPerSide >= 2);
    Mesh mesh;
    for (const BezierPatch &patch : utahTeapotPatches())
        addPatch(mesh, patch, divisionsPerSide);
    return mesh;
}

} // namespace unprojector::examples
