#pragma once

#include <string>
#include <string_view>

namespace unprojector::text {

/// A line as a terminal shows it, whatever names and files' texts are in it: a control character (controlAt), which could
/// colour, erase or turn round what stands there, is written out as "\x1b" or "\u202e". Tabs stay; bytes that are no
/// UTF-8 are written out too.
std::string printableLine(std::string_view line);

/// The same of a text whose line ends stay.
std::string printableLines(std::string_view text);

} // namespace unprojector::text
