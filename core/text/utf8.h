#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace unprojector::text {

/// Where a text stops being UTF-8: the first byte of what is none, npos where all of it is. Overlong forms, surrogates and what
/// lies beyond U+10FFFF are none.
/// Source: The Unicode Standard, table 3-7.
std::size_t firstNotUtf8(std::string_view text);

/// Returns the first `count` UTF-8 characters of a text. Outside valid UTF-8, a byte and up to three continuation bytes count
/// as one character.
std::string_view firstCharacters(std::string_view text, std::size_t count);

/// A text in UTF-16 as UTF-8. What is no UTF-16, as half a pair of surrogates or a single last byte, becomes U+FFFD.
/// @param bytes  without a byte order mark
std::string utf8FromUtf16(std::span<const std::uint8_t> bytes, std::endian order);

} // namespace unprojector::text
