#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::text {

/// A line as a terminal shows it, whatever names and files' texts are in it: a control character (controlAt), which could
/// colour, erase or turn round what stands there, is written out as "\x1b" or "\u202e". Tabs stay; bytes that are no
/// UTF-8 are written out too.
std::string printableLine(std::string_view line);

/// The same of the beginning of what stands in a wrong place, for a message that quotes it: blanks other than ASCII's, which
/// look like these, are written out too.
/// @param most  characters that are shown; of more, a … stands behind them
std::string printableBeginning(std::string_view text, std::size_t most);

/// The same of a text whose line ends stay.
std::string printableLines(std::string_view text);

} // namespace unprojector::text
