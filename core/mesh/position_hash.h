#pragma once

#include <glm/vec3.hpp>

#include <bit>
#include <cstdint>

namespace unprojector::mesh {

inline std::uint64_t mixed(std::uint64_t hash, std::uint32_t word)
{
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
    return hash ^ (hash >> 29);
}

inline std::uint64_t hashOf(const glm::vec3 &v, std::uint64_t hash = 0x2545f4914f6cdd1dull)
{
    // Adding 0 turns -0 into 0: equal numbers must hash alike.
    hash = mixed(hash, std::bit_cast<std::uint32_t>(v.x + 0.0f));
    hash = mixed(hash, std::bit_cast<std::uint32_t>(v.y + 0.0f));
    return mixed(hash, std::bit_cast<std::uint32_t>(v.z + 0.0f));
}

} // namespace unprojector::mesh
