#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace unprojector::base {

/// The position of the first byte that is not UTF-8; npos for valid UTF-8. Overlong forms,
/// surrogates and values beyond U+10FFFF are invalid.
/// Source: The Unicode Standard, table 3-7.
std::size_t firstNotUtf8(std::string_view text);

/// Returns the first `count` UTF-8 characters of a text. Outside valid UTF-8, a byte and up to
/// three continuation bytes count as one character.
std::string_view firstCharacters(std::string_view text, std::size_t count);

/// Converts UTF-16 to UTF-8. Invalid UTF-16, such as half a surrogate pair or a single last byte,
/// becomes U+FFFD.
/// @param bytes  without a byte order mark
std::string utf8FromUtf16(std::span<const std::uint8_t> bytes, std::endian order);

/// A file's text in UTF-8: converts UTF-16 that begins with a byte order mark, as PowerShell's >
/// writes it. Returns any other text as it is.
std::string utf8FromFile(std::string text);

} // namespace unprojector::base
