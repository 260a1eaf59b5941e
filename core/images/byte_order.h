#pragma once

#include <algorithm>
#include <array>
#include <bit>

namespace unprojector::images {

/// Converts a value from one byte order to the other.
template <class Number>
Number withSwappedBytes(Number value)
{
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    std::ranges::reverse(bytes);
    return std::bit_cast<Number>(bytes);
}

} // namespace unprojector::images
