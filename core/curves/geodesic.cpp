#include "core/curves/triangle_strip.h"
#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace unprojector::curves {
using namespace geometry;

namespace {

using Edge = TriangleStrip::Edge;

bool isSameEdge(const Edge &a, const Edge &b)
{
    return a == b || (a[0] == b[1] && a[1] == b[0]);
}

/// Removes triangles that are left by the edge they were entered by, and triangles before the last
/// one that contains the start. Does the same at the other end.
void shorten(TriangleStrip &strip, const PathEnd &from, const PathEnd &to)
{
    TriangleStrip kept;
    for (std::size_t i = 0; i < strip.triangles.size(); ++i) {
        const std::uint32_t triangle = strip.triangles[i];
        if (i > 0)
            kept.edges.push_back(strip.edges[i - 1]);
        kept.triangles.push_back(triangle);
        const auto last = [&] { return kept.edges.size() - 1; };
        while (kept.edges.size() >= 2 && isSameEdge(kept.edges[last()], kept.edges[last() - 1])) {
            kept.triangles.erase(kept.triangles.end() - 2);
            kept.edges.pop_back();
            if (kept.triangles.back() == kept.triangles[kept.triangles.size() - 2]) {
                kept.triangles.pop_back();
                kept.edges.pop_back();
            }
        }
    }
    std::size_t first = 0, end = kept.triangles.size();
    for (std::size_t i = 1; i < end; ++i) {
        if (from.isIn(kept.triangles[i]))
            first = i;
    }
    for (std::size_t i = end - 1; i-- > first;) {
        if (to.isIn(kept.triangles[i]))
            end = i + 1;
    }
    const std::span triangles = std::span(kept.triangles).subspan(first, end - first);
    strip.triangles.assign(triangles.begin(), triangles.end());
    const std::span edges = std::span(kept.edges).subspan(first, end - 1 - first);
    strip.edges.assign(edges.begin(), edges.end());
}

double angleAt(const PlacedMesh &mesh, std::uint32_t triangle, std::uint32_t corner)
{
    std::array<glm::dvec3, 2> legs{};
    std::size_t count = 0;
    for (const std::uint32_t other : mesh->corners(triangle)) {
        if (other != corner)
            legs[count++] = mesh[other] - mesh[corner];
    }
    return std::atan2(glm::length(glm::cross(legs[0], legs[1])), glm::dot(legs[0], legs[1]));
}

/// The triangles around a corner on the side that a strip does not pass.
struct OtherSide {
    std::vector<std::uint32_t> triangles; ///< between the strip's first and last triangle at the corner
    std::vector<Edge> edges;              ///< one more than triangles
    double angle = 0.0;                   ///< angle at the corner in total, on both sides
};

/// @return empty where the surface has a boundary there, or is no single sheet
std::optional<OtherSide> otherSideOf(const StripPath::Bend &bend, const TriangleStrip &strip, const PlacedMesh &mesh)
{
    OtherSide side;
    for (std::size_t i = bend.first; i <= bend.last + 1; ++i)
        side.angle += angleAt(mesh, strip.triangles[i], bend.corner);
    const std::uint32_t goal = strip.triangles[bend.last + 1];
    std::uint32_t triangle = strip.triangles[bend.first];
    const auto outerOf = [&](const Edge &edge) { return edge[0] == bend.corner ? edge[1] : edge[0]; };
    std::uint32_t entered = outerOf(strip.edges[bend.first]);
    const std::size_t most = mesh->around(bend.corner).size();
    for (std::size_t steps = 0; steps <= most; ++steps) {
        entered = mesh->thirdCorner(triangle, bend.corner, entered);
        side.edges.push_back({bend.corner, entered});
        triangle = mesh->onlyAcross(triangle, bend.corner, entered);
        if (triangle == goal)
            return side;
        if (triangle == SurfaceMesh::kNone)
            return std::nullopt;
        side.triangles.push_back(triangle);
        side.angle += angleAt(mesh, triangle, bend.corner);
    }
    return std::nullopt;
}

template <class Item>
void replace(std::vector<Item> &list, std::size_t first, std::size_t end, const std::vector<Item> &by)
{
    const auto at =
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(first), list.begin() + static_cast<std::ptrdiff_t>(end));
    list.insert(at, by.begin(), by.end());
}

/// Reroutes a strip around the other sides of corners where that is shorter.
/// @return whether anything was changed
bool rerouteAroundBends(TriangleStrip &strip, const StripPath &path, const PlacedMesh &mesh)
{
    constexpr double kStraight = 1e-9; // an angle that close to half a turn gains nothing in double precision
    bool isChanged = false;
    std::size_t free = strip.triangles.size(); // triangles from here on are replaced already
    for (std::size_t i = path.bends.size(); i-- > 0;) {
        const StripPath::Bend &bend = path.bends[i];
        if (bend.last + 1 >= free)
            continue;
        const std::optional<OtherSide> side = otherSideOf(bend, strip, mesh);
        if (!side || !(side->angle - bend.angle < kPi - kStraight))
            continue;
        replace(strip.triangles, bend.first + 1, bend.last + 1, side->triangles);
        replace(strip.edges, bend.first, bend.last + 1, side->edges);
        free = bend.first;
        isChanged = true;
    }
    return isChanged;
}

/// The geodesic that a strip leads to.
StripPath straightened(TriangleStrip strip, const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to,
                       const Report &report)
{
    std::optional<StripPath> best;
    for (;;) {
        report(0.0);
        shorten(strip, from, to);
        StripPath path = shortestIn(strip, mesh, from, to);
        // Every pass shortens the path until rounding dominates.
        if (best && !(path.length < best->length))
            break;
        best = std::move(path);
        if (!rerouteAroundBends(strip, *best, mesh))
            break;
    }
    return *std::move(best);
}

/// A geodesic with the triangles that it passes.
struct Straight {
    StripPath path;
    Corridor triangles;
};

/// The geodesic of the strip that A* finds in a corridor.
Straight straightWithin(const Corridor &corridor, const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to,
                        const Report &report)
{
    const TriangleStrip strip = *stripBetween(mesh, from, to, report, &corridor);
    return {straightened(strip, mesh, from, to, report), strip.triangles};
}

/// The geodesic of a long way: of the one along the wave, of the one in the rings around the wave,
/// and of those in the rings around the best one, the shortest.
StripPath alongWave(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to, const Report &report)
{
    constexpr double kWave = 0.7; // share of the time
    Corridor middle = corridorBetween(mesh, from, to, [&](double share) { report(kWave * share); });
    double left = 1.0 - kWave;
    const Report within = [&](double share) { report(1.0 - left * (1.0 - share / 2.0)); };
    std::optional<Straight> best;
    try {
        best = straightWithin(middle, mesh, from, to, within);
    } catch (const NotConnected &) { // the wave passed a corner at which sheets touch without a common edge
        best.reset();
    }
    if (!best)
        return straightened(*stripBetween(mesh, from, to, within, nullptr), mesh, from, to, within);
    for (bool isFirst = true;; isFirst = false) {
        left /= 2.0;
        constexpr double kShorter = 1e-9;
        Straight next = straightWithin(corridorAbout(mesh, std::move(middle)), mesh, from, to, within);
        const bool isShorter = next.path.length < (1.0 - kShorter) * best->path.length;
        if (!isShorter && !isFirst)
            return std::move(best->path);
        if (isShorter)
            best = std::move(next);
        middle = best->triangles;
    }
}

} // namespace

std::optional<SurfacePath> geodesic(const SurfaceMesh &mesh, const SurfacePlace &from, const SurfacePlace &to,
                                    const glm::dmat4 &worldFromObject, const base::Progress &progress,
                                    std::size_t mostEdges)
try {
    const PlacedMesh placed(mesh, worldFromObject);
    const PathEnd start(placed, from), goal(placed, to);
    // The limit of edges is reached early on a long way.
    constexpr double kShort = 0.1;
    base::Reporter reporter(progress);
    const std::optional<TriangleStrip> nearby =
        stripBetween(placed, start, goal, reporter.part(0.0, kShort), nullptr, mostEdges);
    const StripPath found = nearby ? straightened(*nearby, placed, start, goal, reporter.part())
                                   : alongWave(placed, start, goal, reporter.part(kShort));
    SurfacePath path;
    path.length = found.length;
    const double least = 1e-12 * found.length;
    for (const glm::dvec3 &place : found.places) {
        if (path.places.empty() || glm::distance(path.places.back().coordinates(), place) > least)
            path.places.push_back(WorldPoint(place));
    }
    if (path.places.size() > 1)
        path.places.back() = WorldPoint(goal.place());
    return path;
} catch (const NotConnected &) {
    return std::nullopt;
}

} // namespace unprojector::curves
