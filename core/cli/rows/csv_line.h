#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::cli {

// A row of comma-separated values, cell by cell, as RFC 4180 has it: a comma or a line break in quotes separates nothing; two
// quotes in quotes are one. Quotes are a cell's where it begins with one; whatever else it has of them is text.

/// Without the blanks around it.
std::string_view trimmed(std::string_view text);
/// Without blanks and the quotes around it.
std::string_view unquoted(std::string_view text);

/// Where a cell ends: at the next comma that is in no quotes, or with its line.
std::size_t cellEnd(std::string_view line, std::size_t start);

/// Where a row ends.
struct RowEnd {
    std::size_t end = 0;  ///< of its line break, or of the text
    bool isClosed = true; ///< where it is not, a quote is open in it, and `end` is that of its first line
    bool isKnown = true;  ///< where it is not, more text could close the quote
    std::size_t cell = 0; ///< whose quote is open
};
RowEnd rowEnd(std::string_view text, std::size_t start);

/// The row that starts at a place of a text, its end left out.
std::string_view rowAt(std::string_view text, std::size_t start);

/// A cell as another line can have it: as it is, or in quotes of its own where its quotes are not closed.
std::string passedCell(std::string_view cell);

/// A cell as JSON: a number where it is written as one, null where it is empty, else a string of what it says.
std::string jsonOfCell(std::string_view cell);
/// A text as JSON, in quotes. What is no UTF-8 is replaced.
std::string jsonOfText(std::string_view text);

} // namespace unprojector::cli
