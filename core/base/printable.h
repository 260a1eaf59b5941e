#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::base {

/// A line that is safe for a terminal with any names and file texts in it. A control character
/// (controlAt), which could colour, erase or reverse the output, is escaped as "\x1b" or "\u202e".
/// Tabs stay; bytes that are no UTF-8 are escaped too.
std::string printableLine(std::string_view line);

/// The beginning of an unexpected text, for a message that quotes it. Escaped as in printableLine;
/// blanks other than ASCII's, which look the same, are escaped too.
/// @param most  maximum number of characters shown; a longer text ends in …
std::string printableBeginning(std::string_view text, std::size_t most);

/// The same for a text whose line ends stay.
std::string printableLines(std::string_view text);

} // namespace unprojector::base
