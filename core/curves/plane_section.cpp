#include "core/curves/surface_ends.h"
#include "core/curves/surface_path.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace unprojector::curves {
using namespace geometry;

namespace {

glm::dvec3 normalAt(const PlacedMesh &mesh, const PathEnd &end)
{
    glm::dvec3 sum(0.0);
    for (const std::uint32_t triangle : end.triangles()) {
        const std::array<std::uint32_t, 3> &c = mesh->corners(triangle);
        sum += glm::cross(mesh[c[1]] - mesh[c[0]], mesh[c[2]] - mesh[c[0]]);
    }
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : sum;
}

/// Walks from triangle to triangle where a plane cuts them. A corner on the plane counts as above
/// it, so that the section never passes through a corner and always continues.
class SectionWalk {
public:
    SectionWalk(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to, const glm::dvec3 &normal)
        : m_mesh(mesh), m_from(from), m_to(to), m_normal(normal)
    {
    }

    std::optional<SurfacePath> shortest(base::Reporter &reporter) const
    {
        std::optional<SurfacePath> best;
        for (const std::uint32_t triangle : m_from.triangles()) {
            const std::array<std::uint32_t, 3> &c = m_mesh->corners(triangle);
            for (std::size_t side = 0; side < 3; ++side) {
                const std::uint32_t a = c[side], b = c[(side + 1) % 3];
                const std::uint32_t next = m_mesh->onlyAcross(triangle, a, b);
                if (!isCut(a, b) || next == SurfaceMesh::kNone || m_from.isIn(next))
                    continue;
                std::optional<SurfacePath> path = walked(next, a, b, reporter);
                if (path && (!best || path->length < best->length))
                    best = std::move(path);
            }
        }
        return best;
    }

private:
    static constexpr std::uint32_t kStepsBetweenReports = 1 << 12;

    double above(std::uint32_t corner) const { return glm::dot(m_normal, m_mesh[corner] - m_from.place()); }
    bool isCut(std::uint32_t a, std::uint32_t b) const { return (above(a) >= 0.0) != (above(b) >= 0.0); }

    std::optional<SurfacePath> walked(std::uint32_t triangle, std::uint32_t a, std::uint32_t b,
                                      base::Reporter &reporter) const
    {
        SurfacePath path;
        path.places.push_back(WorldPoint(m_from.place()));
        const auto goTo = [&path](const glm::dvec3 &place) {
            const double step = glm::distance(path.places.back().coordinates(), place);
            path.length += step;
            if (step > 0.0)
                path.places.push_back(WorldPoint(place));
        };
        for (std::uint32_t steps = 0; steps < m_mesh->triangleCount(); ++steps) {
            if (steps % kStepsBetweenReports == 0)
                reporter.report(0.0);
            const double aboveA = above(a), aboveB = above(b);
            const double share = aboveA / (aboveA - aboveB);
            goTo((1.0 - share) * m_mesh[a] + share * m_mesh[b]);
            if (m_to.isIn(triangle)) {
                goTo(m_to.place());
                return path;
            }
            if (m_from.isIn(triangle))
                break; // back at the start
            const std::uint32_t third = m_mesh->thirdCorner(triangle, a, b);
            (isCut(a, third) ? b : a) = third;
            triangle = m_mesh->onlyAcross(triangle, a, b);
            if (triangle == SurfaceMesh::kNone)
                break; // at the boundary
        }
        return std::nullopt;
    }

    const PlacedMesh &m_mesh;
    const PathEnd &m_from, &m_to;
    glm::dvec3 m_normal;
};

} // namespace

std::optional<SurfacePath> planeSection(const SurfaceMesh &mesh, const SurfacePlace &from, const SurfacePlace &to,
                                        const glm::dmat4 &worldFromObject, const base::Progress &progress)
{
    const PlacedMesh placed(mesh, worldFromObject);
    const PathEnd start(placed, from), goal(placed, to);
    if (std::ranges::any_of(start.triangles(), [&](std::uint32_t triangle) { return goal.isIn(triangle); }))
        return SurfacePath{{WorldPoint(start.place()), WorldPoint(goal.place())},
                           glm::distance(start.place(), goal.place())};
    const glm::dvec3 way = goal.place() - start.place(), up = normalAt(placed, start) + normalAt(placed, goal);
    const glm::dvec3 normal = glm::cross(way, up);
    const double length = glm::length(normal);
    constexpr double kParallel = 1e-6; // the sine of an angle below which rounding determines the plane
    if (!(length > kParallel * glm::length(way)))
        return std::nullopt;
    base::Reporter reporter(progress);
    return SectionWalk(placed, start, goal, normal / length).shortest(reporter);
}

} // namespace unprojector::curves
