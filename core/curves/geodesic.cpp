#include "core/curves/triangle_strip.h"
#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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
    const auto way = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    strip.triangles.assign(kept.triangles.begin() + way(first), kept.triangles.begin() + way(end));
    strip.edges.assign(kept.edges.begin() + way(first), kept.edges.begin() + way(end - 1));
}

double angleAt(const PlacedMesh &mesh, std::uint32_t triangle, std::uint32_t corner)
{
    std::array<glm::dvec3, 2> legs{};
    std::size_t count = 0;
    for (const std::uint32_t other : mesh.mesh().corners(triangle)) {
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
    const auto [begin, end] = mesh.mesh().around(bend.corner);
    for (std::ptrdiff_t steps = 0; steps <= end - begin; ++steps) {
        const std::array<std::uint32_t, 3> &corners = mesh.mesh().corners(triangle);
        const auto leaving = std::find_if(corners.begin(), corners.end(), [&](std::uint32_t corner) {
            return corner != bend.corner && corner != entered;
        });
        side.edges.push_back({bend.corner, *leaving});
        entered = *leaving;
        triangle = mesh.mesh().onlyAcross(triangle, bend.corner, entered);
        if (triangle == goal)
            return side;
        if (triangle == SurfaceMesh::kNone)
            return std::nullopt;
        side.triangles.push_back(triangle);
        side.angle += angleAt(mesh, triangle, bend.corner);
    }
    return std::nullopt;
}

/// Reroutes a strip around the other side of a corner.
void leadAround(TriangleStrip &strip, const StripPath::Bend &bend, const OtherSide &side)
{
    const auto way = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    const auto triangle = strip.triangles.erase(strip.triangles.begin() + way(bend.first + 1),
                                                strip.triangles.begin() + way(bend.last + 1));
    strip.triangles.insert(triangle, side.triangles.begin(), side.triangles.end());
    const auto edge =
        strip.edges.erase(strip.edges.begin() + way(bend.first), strip.edges.begin() + way(bend.last + 1));
    strip.edges.insert(edge, side.edges.begin(), side.edges.end());
}

/// @return whether anything was changed
bool leadAroundBends(TriangleStrip &strip, const StripPath &path, const PlacedMesh &mesh)
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
        leadAround(strip, bend, *side);
        free = bend.first;
        isChanged = true;
    }
    return isChanged;
}

/// The geodesic that a strip leads to.
Result<StripPath, PathError> straightened(TriangleStrip strip, const PlacedMesh &mesh, const PathEnd &from,
                                          const PathEnd &to, const Progress &goesOn)
{
    std::optional<StripPath> best;
    for (;;) {
        if (!goesOn(0.0))
            return PathError::Stopped;
        shorten(strip, from, to);
        StripPath path = shortestIn(strip, mesh, from, to);
        // Every pass shortens the path until rounding dominates.
        if (best && !(path.length < best->length))
            break;
        best = std::move(path);
        if (!leadAroundBends(strip, *best, mesh))
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
Result<Straight, PathError> straightWithin(const Corridor &corridor, const PlacedMesh &mesh, const PathEnd &from,
                                           const PathEnd &to, const Progress &goesOn)
{
    const Result<TriangleStrip, PathError> strip = stripWithin(corridor, mesh, from, to, goesOn);
    if (!strip)
        return strip.error();
    Result<StripPath, PathError> path = straightened(*strip, mesh, from, to, goesOn);
    if (!path)
        return path.error();
    return Straight{std::move(path).value(), strip->triangles};
}

/// The geodesic of a long way: of the one along the wave, of the one in the rings around the wave,
/// and of those in the rings around the best one, the shortest.
Result<StripPath, PathError> alongWave(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to,
                                       const Progress &goesOn)
{
    constexpr double kWave = 0.7; // share of the time
    const Result<Corridor, PathError> wave =
        corridorBetween(mesh, from, to, [&](double share) { return goesOn(kWave * share); });
    if (!wave)
        return wave.error();
    double left = 1.0 - kWave;
    const Progress within = [&](double share) { return goesOn(1.0 - left * (1.0 - share / 2.0)); };
    Result<Straight, PathError> best = straightWithin(*wave, mesh, from, to, within);
    if (!best && best.error() == PathError::NotConnected) {
        // The wave passed a corner at which sheets touch without a common edge.
        const auto whole = stripBetween(mesh, from, to, within, std::numeric_limits<std::size_t>::max());
        if (!whole)
            return whole.error();
        return straightened(**whole, mesh, from, to, within);
    }
    Corridor middle = *wave;
    for (bool isFirst = true; best; isFirst = false) {
        left /= 2.0;
        constexpr double kShorter = 1e-9;
        Result<Straight, PathError> next =
            straightWithin(corridorAbout(mesh.mesh(), std::move(middle)), mesh, from, to, within);
        if (!next)
            return next.error();
        const bool isShorter = next->path.length < (1.0 - kShorter) * best->path.length;
        if (!isShorter && !isFirst)
            break;
        if (isShorter)
            best = std::move(next);
        middle = best->triangles;
    }
    if (!best)
        return best.error();
    return std::move(best).value().path;
}

} // namespace

Result<SurfacePath, PathError> geodesic(const SurfaceMesh &mesh, const SurfacePlace &from, const SurfacePlace &to,
                                        const glm::dmat4 &worldFromObject, const Progress &goesOn,
                                        std::size_t mostEdges)
{
    const PlacedMesh placed(mesh, worldFromObject);
    const PathEnd start(placed, from), goal(placed, to);
    // The limit of edges is reached early on a long way.
    constexpr double kShort = 0.1;
    double done = 0.0; // shares never decrease
    const auto goes = [&](double first, double last) -> Progress {
        return [&, first, last](double share) {
            done = std::max(done, first + (last - first) * share);
            return !goesOn || goesOn(done);
        };
    };
    const Result<std::optional<TriangleStrip>, PathError> nearby =
        stripBetween(placed, start, goal, goes(0.0, kShort), mostEdges);
    if (!nearby)
        return nearby.error();
    const Result<StripPath, PathError> found = *nearby ? straightened(**nearby, placed, start, goal, goes(0.0, 1.0))
                                                       : alongWave(placed, start, goal, goes(kShort, 1.0));
    if (!found)
        return found.error();
    SurfacePath path;
    path.length = found->length;
    const double least = 1e-12 * found->length;
    for (const glm::dvec3 &place : found->places) {
        if (path.places.empty() || glm::distance(path.places.back().coordinates(), place) > least)
            path.places.push_back(WorldPoint(place));
    }
    if (path.places.size() > 1)
        path.places.back() = WorldPoint(goal.place());
    return path;
}

} // namespace unprojector::curves
