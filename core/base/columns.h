#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::base {

/// The number of terminal columns that a UTF-8 text takes: two for Chinese, Japanese and Korean
/// characters and full-width signs, one for others.
/// Source: Unicode Standard Annex 11, its ranges of wide characters, emoji left out.
std::size_t columnsOf(std::string_view text);

/// The beginning of a text that fits into the given number of columns.
std::string_view firstColumns(std::string_view text, std::size_t columns);

/// The text, padded with trailing blanks to the given number of columns.
std::string padded(std::string text, std::size_t columns);

/// The same with the blanks in front.
std::string paddedLeft(const std::string &text, std::size_t columns);

} // namespace unprojector::base
