#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::text {

/// How many columns of a terminal a UTF-8 text takes: Chinese, Japanese and Korean characters and full-width signs take
/// two, others one.
/// Source: Unicode Standard Annex 11, its ranges of wide characters, emoji left out.
std::size_t columnsOf(std::string_view text);

/// As much of a text's beginning as so many columns have room for.
std::string_view firstColumns(std::string_view text, std::size_t columns);

/// A text with blanks behind it, as many as it needs to take so many columns.
std::string padded(std::string text, std::size_t columns);

/// The same with the blanks in front.
std::string paddedLeft(const std::string &text, std::size_t columns);

/// A text with line ends put in, so that each line takes at most so many columns where that can be. Lines end at blanks and
/// between wide characters, but not before a closing sign or behind an opening one. Line ends that are there stay.
/// @param indent  blanks in front of every line that is begun here
std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent = 0);

} // namespace unprojector::text
