#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <vector>

namespace unprojector::mesh {

/// The mean curvature of a model's surface, one over units of the object. It is positive on ridges
/// and negative in valleys, seen from the front sides of the triangles.
struct Curvature {
    std::vector<std::vector<float>> meshes; ///< one value a vertex of each mesh; empty for points
    /// The absolute value that nine tenths of the surface stay below; 0: all of it is flat.
    double usual = 0.0;
    /// The distance that is smoothed over, units of the object.
    double smoothingDistance = 0.0;
};

/// Computes the mean curvature H = (k1 + k2) / 2 as half the divergence of the surface's normals:
/// 1/r on a sphere, 1/(2 r) on a cylinder, 0 on a plane and on a minimal surface.
///
/// It is smoothed so that noise of the scanner does not hide the shape. Vertices at equal positions
/// count as one. A grid gathers them in clusters; clusters are neighbours where a triangle connects
/// them, so opposite sides of a thin wall stay apart. A normal is the weighted mean over a vertex's
/// cluster and its neighbours, and so is the integral of the divergence over the triangles. The
/// size of the cells follows from the size of the surface, but is at least the distance of
/// vertices. Triangles without an area, or with numbers that are not finite, do not count. It is
/// only for display.
/// @return without meshes if cancelled
Curvature curvatureOf(const Model &model, const base::Progress &progress = {});

} // namespace unprojector::mesh
