// Fast marching from corner to corner: finds the corridor of triangles for a long geodesic.

#include "core/curves/triangle_strip.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

namespace unprojector::curves {
namespace {

constexpr std::uint32_t kNone = SurfaceMesh::kNone;

/// A triangle by the lengths of its sides: an edge from A to B, and from both to the corner C.
struct Sides {
    double edge, toA, toB;
};

/// The distance of a corner beyond an edge whose ends' distances are known: from the source's image
/// in the corner's plane. It is exact where the wave comes from one point over flat triangles.
struct Beyond {
    double distance = std::numeric_limits<double>::infinity();
    bool isNearerA = true; ///< the shortest way passes the edge nearer to A
};
Beyond beyondEdge(const Sides &sides, double atA, double atB)
{
    const auto &[edge, toA, toB] = sides;
    const Beyond around = atA + toA <= atB + toB ? Beyond{atA + toA, true} : Beyond{atB + toB, false};
    if (!(edge > 0.0))
        return around;
    // The plane has A at the origin and B at (edge, 0); the source is below it, the corner above.
    const double sourceX = (atA * atA - atB * atB + edge * edge) / (2.0 * edge);
    const double cornerX = (toA * toA - toB * toB + edge * edge) / (2.0 * edge);
    const double sourceSquare = atA * atA - sourceX * sourceX, cornerSquare = toA * toA - cornerX * cornerX;
    if (!(sourceSquare >= 0.0 && cornerSquare > 0.0))
        return around;
    const double below = std::sqrt(sourceSquare), above = std::sqrt(cornerSquare);
    const double crossing = (sourceX * above + cornerX * below) / (above + below);
    if (crossing < 0.0 || crossing > edge)
        return around;
    const double across = cornerX - sourceX, up = above + below;
    return {std::sqrt(across * across + up * up), crossing <= edge / 2.0};
}

/// The straight distance between the corners on both sides of an edge, unfolded into a plane;
/// nothing if the line passes outside the edge.
std::optional<double> acrossEdge(const Sides &one, const Sides &other)
{
    const auto beyond = beyondEdge(other, one.toA, one.toB);
    const double x = (one.toA * one.toA - one.toB * one.toB + one.edge * one.edge) / (2.0 * one.edge);
    const bool isFlat = !(one.edge > 0.0) || !(one.toA * one.toA - x * x >= 0.0);
    const bool isAround = beyond.distance == std::min(one.toA + other.toA, one.toB + other.toB);
    return isFlat || isAround ? std::nullopt : std::optional(beyond.distance);
}

void sort(std::vector<std::uint32_t> &numbers)
{
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// The corners of triangles, each once, sorted.
std::vector<std::uint32_t> cornersOf(const PlacedMesh &mesh, const std::vector<std::uint32_t> &triangles)
{
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t triangle : triangles)
        corners.insert(corners.end(), mesh->corners(triangle).begin(), mesh->corners(triangle).end());
    sort(corners);
    return corners;
}

class Wave {
public:
    Wave(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to, const Report &report)
        : m_mesh(mesh), m_from(from), m_to(to), m_report(report), m_corners(mesh->cornerCount())
    {
    }

    Corridor run()
    {
        for (const std::uint32_t triangle : m_from.triangles()) {
            for (const std::uint32_t corner : m_mesh->corners(triangle))
                offer(corner, glm::distance(m_from.place(), m_mesh[corner]), kNone);
        }
        const std::vector<std::uint32_t> goals = cornersOf(m_mesh, m_to.triangles());
        std::size_t left = goals.size();
        double nearest = std::numeric_limits<double>::infinity(); // to the goal in a straight line
        for (std::size_t steps = 0; left > 0; ++steps) {
            if (m_open.empty())
                throw NotConnected{};
            const auto [distance, corner] = m_open.top();
            m_open.pop();
            if (m_corners[corner].isDone)
                continue;
            m_corners[corner].isDone = true;
            left -= std::binary_search(goals.begin(), goals.end(), corner) ? 1u : 0u;
            nearest = std::min(nearest, glm::distance(m_mesh[corner], m_to.place()));
            constexpr std::size_t kStepsBetweenReports = 1 << 12;
            if (steps % kStepsBetweenReports == 0)
                m_report(distance / (distance + nearest));
            spread(corner);
        }
        return way();
    }

private:
    struct Corner {
        double distance = std::numeric_limits<double>::infinity();
        std::uint32_t parent = kNone; ///< the corner nearest to the way from the source; none: at the source
        bool isDone = false;
    };

    void offer(std::uint32_t corner, double distance, std::uint32_t parent)
    {
        Corner &known = m_corners[corner];
        if (known.isDone || !(distance < known.distance))
            return;
        known.distance = distance;
        known.parent = parent;
        m_open.emplace(distance, corner);
    }

    /// Offers distances to the corners beside a corner that has its own.
    void spread(std::uint32_t corner)
    {
        const glm::dvec3 place = m_mesh[corner];
        const double distance = m_corners[corner].distance;
        for (const std::uint32_t triangle : m_mesh->around(corner)) {
            const std::array<std::uint32_t, 3> &corners = m_mesh->corners(triangle);
            const std::size_t k = corners[0] == corner ? 0 : corners[1] == corner ? 1 : 2;
            const std::array others{corners[(k + 1) % 3], corners[(k + 2) % 3]};
            // A triangle's positions and lengths serve all offers in it.
            const std::array places{m_mesh[others[0]], m_mesh[others[1]]};
            const Sides own{glm::distance(places[0], places[1]), glm::distance(places[0], place),
                            glm::distance(places[1], place)};
            const std::array isDone{m_corners[others[0]].isDone, m_corners[others[1]].isDone};
            for (std::size_t i = 0; i < 2; ++i) {
                if (isDone[i])
                    continue;
                const double leg = i == 0 ? own.toA : own.toB, thirdLeg = i == 0 ? own.toB : own.toA;
                if (isDone[1 - i])
                    pass(corner, others[1 - i], others[i], {thirdLeg, leg, own.edge});
                else
                    offer(others[i], distance + leg, corner);
            }
            spreadAcross(corner, triangle, others, places, own);
        }
    }

    /// Offers a distance from two corners that have theirs.
    void pass(std::uint32_t a, std::uint32_t b, std::uint32_t corner, const Sides &sides)
    {
        const Beyond beyond = beyondEdge(sides, m_corners[a].distance, m_corners[b].distance);
        offer(corner, beyond.distance, beyond.isNearerA ? a : b);
    }

    /// Offers distances to the corner on the other side of an opposite edge: an obtuse triangle
    /// there lacks the wave from its own corners.
    /// @param ends  the positions of the edge's ends
    /// @param own   the triangle's sides, from the edge to the corner
    void spreadAcross(std::uint32_t corner, std::uint32_t triangle, const std::array<std::uint32_t, 2> &edge,
                      const std::array<glm::dvec3, 2> &ends, const Sides &own)
    {
        const std::uint32_t other = m_mesh->onlyAcross(triangle, edge[0], edge[1]);
        if (other == kNone)
            return;
        const std::uint32_t next = m_mesh->thirdCorner(other, edge[0], edge[1]);
        if (m_corners[next].isDone)
            return;
        const glm::dvec3 place = m_mesh[next];
        const Sides beyond{own.edge, glm::distance(ends[0], place), glm::distance(ends[1], place)};
        const std::optional<double> straight = acrossEdge(own, beyond);
        if (!straight)
            return;
        offer(next, m_corners[corner].distance + *straight, corner);
        for (std::size_t i = 0; i < 2; ++i) {
            const double toEnd = i == 0 ? own.toA : own.toB, fromEnd = i == 0 ? beyond.toA : beyond.toB;
            if (m_corners[edge[i]].isDone)
                pass(corner, edge[i], next, {toEnd, *straight, fromEnd});
        }
    }

    /// The triangles along the way, and those of both ends.
    Corridor way() const
    {
        double least = std::numeric_limits<double>::infinity();
        std::uint32_t corner = kNone;
        for (const std::uint32_t each : cornersOf(m_mesh, m_to.triangles())) {
            const double whole = m_corners[each].distance + glm::distance(m_mesh[each], m_to.place());
            if (std::exchange(least, std::min(least, whole)) > whole)
                corner = each;
        }
        Corridor triangles(m_from.triangles());
        triangles.insert(triangles.end(), m_to.triangles().begin(), m_to.triangles().end());
        for (; corner != kNone; corner = m_corners[corner].parent) {
            const auto around = m_mesh->around(corner);
            triangles.insert(triangles.end(), around.begin(), around.end());
        }
        sort(triangles);
        return triangles;
    }

    const PlacedMesh &m_mesh;
    const PathEnd &m_from, &m_to;
    const Report &m_report;
    std::vector<Corner> m_corners;
    using Open = std::pair<double, std::uint32_t>; ///< distance, corner
    std::priority_queue<Open, std::vector<Open>, std::greater<>> m_open;
};

} // namespace

Corridor corridorBetween(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to, const Report &report)
{
    return Wave(mesh, from, to, report).run();
}

Corridor corridorAbout(const PlacedMesh &mesh, Corridor triangles)
{
    sort(triangles); // those of a path come in its order
    constexpr int kRings = 12;
    Corridor last = triangles; // only the last ring has neighbours outside
    for (int ring = 0; ring < kRings; ++ring) {
        Corridor touched;
        for (const std::uint32_t corner : cornersOf(mesh, last)) {
            const auto around = mesh->around(corner);
            touched.insert(touched.end(), around.begin(), around.end());
        }
        sort(touched);
        last.clear();
        std::set_difference(touched.begin(), touched.end(), triangles.begin(), triangles.end(),
                            std::back_inserter(last));
        const auto middle = triangles.insert(triangles.end(), last.begin(), last.end());
        std::inplace_merge(triangles.begin(), middle, triangles.end());
    }
    return triangles;
}

} // namespace unprojector::curves
