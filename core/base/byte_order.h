#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace unprojector::base {

/// Converts a value from one byte order to the other.
template <class Number>
Number withSwappedBytes(Number value)
{
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    std::ranges::reverse(bytes);
    return std::bit_cast<Number>(bytes);
}

/// The number at a place in a file's bytes.
template <class Number>
Number numberAt(const std::uint8_t *bytes, std::endian order = std::endian::little)
{
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return order == std::endian::native ? number : withSwappedBytes(number);
}

} // namespace unprojector::base
