#pragma once

#include "core/mesh/mesh.h"

#include <cstddef>
#include <functional>

namespace unprojector::mesh {

/// Called with the share done in [0, 1], never falling; returning false ends the work.
using StandInProgress = std::function<bool(double share)>;

/// A coarse model that looks like this one from some way off, to be drawn while the view moves: of all vertices of a mesh
/// that lie in one cell of a grid their mean is left, and of the triangles those whose corners lie in three cells
/// (Rossignac and Borrel 1993). Its normals are the means of the triangles' own. Positions are relative to the same
/// origins; points are thinned out by the same grid. It is for looks alone: no coordinate may be read from it. Of meshes that are
/// closed it says so.
/// @param most  about how many triangles and points it has
/// @param progress  may be empty
/// @return without meshes when it was ended
Model standInFor(const Model &model, std::size_t most, const StandInProgress &progress = {});

} // namespace unprojector::mesh
