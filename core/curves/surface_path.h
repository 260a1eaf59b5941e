#pragma once

#include "core/curves/surface_mesh.h"
#include "core/geometry/result.h"

#include <glm/mat4x4.hpp>

#include <functional>
#include <vector>

namespace unprojector::curves {

/// A line that stays on the surface: straight within each triangle.
struct SurfacePath {
    std::vector<geometry::WorldPoint> places; ///< from, where it crosses edges and passes corners, to
    double length = 0.0;                      ///< world units
};

/// Why there is no path.
enum class PathError {
    NotConnected, ///< the surface between both is not in one piece
    NoSection,    ///< the plane's section from one does not lead to the other, or there is no such plane
    Stopped,
};

/// Asked again and again; false ends the work.
using GoesOn = std::function<bool()>;

/// A geodesic: the path that cannot be made shorter by moving it a little, as a thread pulled tight. It is exact to rounding for
/// the triangles; which of several such there are, left or right around a hole, is that of the shortest way over a net of places on
/// the edges, which is at most some percent longer than the shortest path.
///
///   A* over three places an edge gives a strip of triangles. Unfolded into the plane, the shortest path in it is found by the
///   funnel (Lee and Preparata, 1984). Wherever that bends about a corner which has less than half a turn on its other side, the
///   strip is led around there instead, until it bends no more so (Xin and Wang, 2007).
///
/// @param worldFromObject  the length is measured in the world
/// @param goesOn           may be empty
geometry::Result<SurfacePath, PathError> geodesic(const SurfaceMesh &mesh, const SurfacePlace &from,
                                                  const SurfacePlace &to, const glm::dmat4 &worldFromObject,
                                                  const GoesOn &goesOn);

/// Where a plane cuts the surface: the one through both places along the mean of the normals there. Of the two ways around that
/// lead from one to the other the shorter one.
geometry::Result<SurfacePath, PathError> planeSection(const SurfaceMesh &mesh, const SurfacePlace &from,
                                                      const SurfacePlace &to, const glm::dmat4 &worldFromObject,
                                                      const GoesOn &goesOn);

} // namespace unprojector::curves
