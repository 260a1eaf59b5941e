#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace unprojector::mesh {

/// The values at some indices; none if there are no values.
template <class Value>
std::vector<Value> gathered(const std::vector<Value> &values, std::span<const std::uint32_t> indices)
{
    std::vector<Value> chosen;
    chosen.reserve(values.empty() ? 0 : indices.size());
    for (std::size_t i = 0; i < indices.size() && !values.empty(); ++i)
        chosen.push_back(values[indices[i]]);
    return chosen;
}
/// Replaces a mesh's vertices by some of them, in this order; the indices stay.
void gatherVertices(Mesh &mesh, std::span<const std::uint32_t> vertices);

/// Merges vertices with equal position, number, normal, colour and texture coordinate, in the order
/// of first use. Drops vertices that no triangle uses. Afterwards the mesh has indices.
void mergeEqualVertices(Mesh &mesh);

/// Replaces the mesh's normals by smooth ones: the area-weighted mean of the faces around a
/// position, shared by all vertices at that position. An edge whose faces differ by more than the
/// crease angle of 60 degrees stays hard: its vertices are split. The copies are appended, so existing vertices
/// keep their numbers.
///
/// Faces without area are ignored. A vertex that has only such faces gets (0, 0, 1).
/// @param report  called with the share done in [0, 1]; may throw
void makeNormals(Mesh &mesh, const std::function<void(double)> &report);

} // namespace unprojector::mesh
