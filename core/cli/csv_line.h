#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::cli {

// A line of comma-separated values, cell by cell. A comma in quotes separates nothing; two quotes in quotes are one.

/// Without the blanks around it.
std::string_view trimmed(std::string_view text);
/// Without blanks and the quotes around it.
std::string_view unquoted(std::string_view text);

/// Where a cell ends: at the next comma that is in no quotes, or with its line.
std::size_t cellEnd(std::string_view line, std::size_t start);

/// The line that starts at a place of a text, its end left out.
std::string_view lineAt(std::string_view text, std::size_t start);

/// A cell as another line can have it: as it is, or in quotes of its own where its quotes are not closed.
std::string passedCell(std::string_view cell);

/// A cell as JSON: a number where it is written as one, null where it is empty, else a string of what it says.
std::string jsonOfCell(std::string_view cell);
/// A text as JSON, in quotes. What is no UTF-8 is replaced.
std::string jsonOfText(std::string_view text);

} // namespace unprojector::cli
