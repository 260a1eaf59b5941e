#pragma once

#include "core/curves/surface_ends.h"
#include "core/curves/surface_path.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace unprojector::curves {

/// Triangles, each adjacent to the previous one across an edge.
struct TriangleStrip {
    using Edge = std::array<std::uint32_t, 2>; ///< its corners, in any order

    std::vector<std::uint32_t> triangles;
    std::vector<Edge> edges; ///< one fewer than triangles
};

/// Thrown where no path leads from one end to the other.
struct NotConnected {};

/// Receives the share done; throws base::Stopped.
using Report = std::function<void(double)>;
/// Triangles, sorted.
using Corridor = std::vector<std::uint32_t>;

/// A strip around a short path from one end to the other, found by A* over points on the edges.
/// @param corridor  searched only; null: the whole surface
/// @param mostEdges  see geodesic
/// @return nothing if the search would visit more edges
std::optional<TriangleStrip> stripBetween(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to,
                                          const Report &report, const Corridor *corridor,
                                          std::size_t mostEdges = std::numeric_limits<std::size_t>::max());

/// The triangles about a short path from one end to the other. A wave spreads from corner to corner
/// by fast marching until it reaches the goal (Kimmel and Sethian, 1998); a corner's distance
/// follows from two others by the image of the source (Novotni and Klein, 2002). It needs 16 bytes
/// per corner.
Corridor corridorBetween(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to, const Report &report);
/// Some rings of triangles around others, which may come in any order.
Corridor corridorAbout(const PlacedMesh &mesh, Corridor triangles);

/// The shortest path within a strip.
struct StripPath {
    /// A bend: about a corner, while the path crosses the edges from `first` to `last`.
    struct Bend {
        std::uint32_t corner = 0;
        std::size_t first = 0, last = 0;
        double angle = 0.0; ///< on the strip's side, radians; at least half a turn
    };
    std::vector<glm::dvec3> places;
    std::vector<Bend> bends;
    double length = 0.0;
};
StripPath shortestIn(const TriangleStrip &strip, const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to);

} // namespace unprojector::curves
