#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh {

/// Whether triangles are the whole skin of one or more bodies, and turn their front sides outwards: along every edge as
/// many of them run one way as the other, and no piece that hangs together encloses a negative volume. Seen from outside,
/// a back side of such a surface is always hidden by a front side.
/// @param triangles    corners as numbers of vertices: what touches has the same. None has a corner twice
/// @param leastVolume  of a piece that counts, cubic units
bool isClosedOutwards(std::span<const std::array<std::uint32_t, 3>> triangles, const std::vector<glm::dvec3> &positions,
                      double leastVolume);

} // namespace unprojector::mesh
