#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace unprojector::mesh {

/// Merges vertices with equal position, number, normal, colour and texture coordinate, in the order
/// of first use. Drops vertices that no triangle uses. Afterwards the mesh has indices.
void mergeEqualVertices(Mesh &mesh);

/// Replaces the mesh's normals by smooth ones: the area-weighted mean of the faces around a
/// position, shared by all vertices at that position. An edge whose faces differ by more than the
/// crease angle stays hard: its vertices are split. The copies are appended, so existing vertices
/// keep their numbers.
///
/// Faces without area are ignored. A vertex that has only such faces gets (0, 0, 1).
/// @param cosineOfCrease  cosine of the crease angle; the default is 60 degrees
/// @param report  called with the share done in [0, 1]; may throw
void makeNormals(Mesh &mesh, float cosineOfCrease = 0.5f, const std::function<void(double)> &report = {});

} // namespace unprojector::mesh
