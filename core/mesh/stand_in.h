#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <cstddef>

namespace unprojector::mesh {

/// Builds a coarse model to draw while the view moves. A grid cell merges the vertices of a mesh in
/// it into their mean; triangles with corners in three different cells remain (Rossignac and Borrel
/// 1993). Normals are the means of the triangles' own. Positions are relative to the same origins;
/// the same grid thins out points. Closed meshes stay marked as closed. It is only for display:
/// never read a coordinate from it.
/// @param most  approximate number of triangles and points
/// @param progress  may be empty
/// @return a model without meshes if cancelled
Model standInFor(const Model &model, std::size_t most, const base::Progress &progress = {});

} // namespace unprojector::mesh
