#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace unprojector::ray {

/// The numbers 0 … count - 1, ordered so that neighbours in the list are neighbours in space. The
/// order is a Z curve (Morton), which is refined in dense regions.
/// @param place  the position of a number, in [-1, 1]^3; called from several threads
std::vector<std::uint32_t> placeOrder(std::uint32_t count, std::size_t group,
                                      const std::function<glm::vec3(std::uint32_t)> &place);

} // namespace unprojector::ray
