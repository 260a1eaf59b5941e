#pragma once

#include <cstddef>
#include <string_view>

namespace unprojector::text {

/// Where a text stops being UTF-8: the first byte of what is none, npos where all of it is. Overlong forms, surrogates and what
/// lies beyond U+10FFFF are none.
/// Source: The Unicode Standard, table 3-7.
std::size_t firstNotUtf8(std::string_view text);

} // namespace unprojector::text
