#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace unprojector::ray {

/// The numbers 0 … count - 1 in an order in which neighbours in the list are neighbours in space: along a Z curve (Morton), which
/// gets finer where many crowd.
/// @param place  of a number, in [-1, 1]^3; called from several threads
std::vector<std::uint32_t> placeOrder(std::uint32_t count, std::size_t group,
                                      const std::function<glm::vec3(std::uint32_t)> &place);

} // namespace unprojector::ray
