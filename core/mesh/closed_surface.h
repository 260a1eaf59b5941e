#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh {

/// Returns whether triangles form the whole surface of one or more bodies with their front sides
/// outwards. That is: each edge has equally many triangles in both directions, and no connected
/// piece has a negative volume. Seen from outside, a front side always hides the back sides of such
/// a surface.
/// @param triangles    vertex numbers of the corners: touching triangles share them. No triangle
///         has a corner twice
/// @param leastVolume  of a piece that counts, cubic units
bool isClosedOutwards(std::span<const std::array<std::uint32_t, 3>> triangles, const std::vector<glm::dvec3> &positions,
                      double leastVolume);

} // namespace unprojector::mesh
