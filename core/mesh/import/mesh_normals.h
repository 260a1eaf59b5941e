#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace unprojector::mesh {

/// Numbers positions so that equal ones share a number; -0 equals 0.
class PositionIndex {
public:
    explicit PositionIndex(std::size_t expectedCount = 0);
    /// The number of a position: shared with the first equal position, else the next free number.
    std::uint32_t add(const glm::vec3 &position);
    std::size_t size() const { return m_positions.size(); }

private:
    void grow();

    std::vector<glm::vec3> m_positions;
    std::vector<std::uint32_t> m_slots;
};

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
