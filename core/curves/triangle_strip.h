#pragma once

#include "core/curves/surface_ends.h"
#include "core/curves/surface_path.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace unprojector::curves {

/// Triangles, each adjacent to the previous one across an edge.
struct TriangleStrip {
    using Edge = std::array<std::uint32_t, 2>; ///< its corners, in any order

    std::vector<std::uint32_t> triangles;
    std::vector<Edge> edges; ///< one fewer than triangles
};

/// A strip around a short path from one end to the other, found by A* over points on the edges.
/// @return NotConnected, Stopped
geometry::Result<TriangleStrip, PathError> stripBetween(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to,
                                                        const GoesOn &goesOn);

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
