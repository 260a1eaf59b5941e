#include "core/curves/surface_mesh.h"

#include "core/mesh/numbering.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace unprojector::curves {
using namespace landmarks;
using namespace mesh;

namespace {

/// Triangles between calls of progress.
constexpr std::size_t kStep = 1 << 16;

std::optional<SurfacePlace> onTriangleWith(const SurfaceMesh &mesh, std::uint32_t a, std::uint32_t b, double share)
{
    if (a == SurfaceMesh::kNone || b == SurfaceMesh::kNone)
        return std::nullopt;
    for (const std::uint32_t triangle : mesh.around(a)) {
        const std::array<std::uint32_t, 3> &corners = mesh.corners(triangle);
        const auto ofA = std::find(corners.begin(), corners.end(), a) - corners.begin();
        const auto ofB = std::find(corners.begin(), corners.end(), b) - corners.begin();
        if (ofB == 3)
            continue;
        SurfacePlace place{triangle, glm::dvec3(0.0)};
        place.barycentric[static_cast<int>(ofA)] += 1.0 - share;
        place.barycentric[static_cast<int>(ofB)] += share;
        return place;
    }
    return std::nullopt;
}

} // namespace

std::shared_ptr<const SurfaceMesh> SurfaceMesh::build(const Model &model, const base::Progress &progress)
{
    const auto goesOn = [&](double share) { return !progress || progress(share); };
    auto surface = std::make_shared<SurfaceMesh>();
    const std::size_t vertices = std::max(model.fileVertices, model.vertexCount());
    surface->m_ofVertex.assign(vertices, kNone);
    const std::size_t triangles = model.triangleCount();
    surface->m_corners.reserve(triangles);
    Numbering<glm::dvec3> numbers(std::min<std::size_t>(vertices, 3 * triangles));
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        const Mesh &mesh = model.meshes[m];
        for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
            if (i % kStep == 0 && !goesOn(0.7 * double(surface->m_corners.size()) / double(triangles)))
                return nullptr;
            std::array<std::uint32_t, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t vertex = mesh.vertexAt(3 * i + k);
                std::uint32_t &corner = surface->m_ofVertex[model.vertexNumber(m, vertex)];
                if (corner == kNone)
                    corner = numbers.add(mesh.position(vertex));
                corners[k] = corner;
            }
            surface->m_corners.push_back(corners);
        }
    }
    surface->m_places = std::move(numbers.keys());
    if (!goesOn(0.7))
        return nullptr;
    // Triangles without three distinct corners are skipped; their neighbours are adjacent to each
    // other.
    std::vector<std::uint32_t> &starts = surface->m_starts;
    starts.assign(surface->m_places.size() + 1, 0);
    const auto eachCorner = [&](const auto &visit) {
        for (std::uint32_t i = 0; i < surface->m_corners.size(); ++i) {
            if (surface->isFlat(i))
                continue;
            for (const std::uint32_t corner : surface->m_corners[i])
                visit(i, corner);
        }
    };
    eachCorner([&](std::uint32_t, std::uint32_t corner) { ++starts[corner + 1]; });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    surface->m_around.resize(starts.back());
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    eachCorner([&](std::uint32_t triangle, std::uint32_t corner) { surface->m_around[next[corner]++] = triangle; });
    return goesOn(1.0) ? surface : nullptr;
}

bool SurfaceMesh::isFlat(std::uint32_t triangle) const
{
    const std::array<std::uint32_t, 3> &c = m_corners[triangle];
    return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

std::uint32_t SurfaceMesh::cornerOfVertex(std::uint32_t vertex) const
{
    return vertex < m_ofVertex.size() ? m_ofVertex[vertex] : kNone;
}

std::uint32_t SurfaceMesh::thirdCorner(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const
{
    for (const std::uint32_t corner : m_corners[triangle]) {
        if (corner != a && corner != b)
            return corner;
    }
    return a;
}

std::uint32_t SurfaceMesh::onlyAcross(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const
{
    std::uint32_t found = kNone;
    int count = 0;
    across(triangle, a, b, [&](std::uint32_t other) {
        found = other;
        ++count;
    });
    return count == 1 ? found : kNone;
}

std::optional<SurfacePlace> placeOf(const Anchor &anchor, const SurfaceMesh &mesh)
{
    if (const auto *on = std::get_if<OnTriangle>(&anchor)) {
        const glm::dvec3 weights = glm::max(on->barycentric, glm::dvec3(0.0));
        const double sum = weights[0] + weights[1] + weights[2];
        if (on->triangle >= mesh.triangleCount() || !(sum > 0.0) || !std::isfinite(sum))
            return std::nullopt;
        if (!mesh.isFlat(on->triangle))
            return SurfacePlace{on->triangle, on->barycentric};
        // Use its edge, which a neighbour has too.
        const std::array<std::uint32_t, 3> &c = mesh.corners(on->triangle);
        const glm::dvec3 &w = on->barycentric;
        return c[0] == c[1] ? onTriangleWith(mesh, c[0], c[2], w[2]) : onTriangleWith(mesh, c[0], c[1], w[1]);
    }
    if (const auto *at = std::get_if<AtVertex>(&anchor)) {
        const std::uint32_t corner = mesh.cornerOfVertex(at->vertex);
        return onTriangleWith(mesh, corner, corner, 0.0);
    }
    if (const auto *edge = std::get_if<OnEdge>(&anchor))
        return onTriangleWith(mesh, mesh.cornerOfVertex(edge->vertices[0]), mesh.cornerOfVertex(edge->vertices[1]),
                              edge->share);
    return std::nullopt;
}

} // namespace unprojector::curves
