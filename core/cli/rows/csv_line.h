#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unprojector::cli {

// A row of comma-separated values, cell by cell, as in RFC 4180. A comma or a line break in quotes
// does not separate; two quotes in quotes are one. Quotes enclose a cell only if it begins with
// one; otherwise they are text.

/// The text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);
/// The text without blanks and the quotes around it.
std::string_view unquoted(std::string_view text);

/// The end of a cell: the next comma outside quotes, or the end of the line.
std::size_t cellEnd(std::string_view line, std::size_t start);

/// The end of a row.
struct RowEnd {
    std::size_t end = 0;  ///< position of its line break, or the end of the text
    bool isClosed = true; ///< false: a quote is open in the row, and `end` is the end of its first line
    bool isKnown = true;  ///< false: more text could close the quote
    std::size_t cell = 0; ///< position of the cell with the open quote
};
RowEnd rowEnd(std::string_view text, std::size_t start);

/// The row that starts at a position of a text, without its line end.
std::string_view rowAt(std::string_view text, std::size_t start);

/// A cell in a form that another line can contain: unchanged, or in quotes of its own where its
/// quotes are not closed.
std::string passedCell(std::string_view cell);

/// A cell as JSON: a number where it is written as one, null where it is empty, else a string of
/// its text.
std::string jsonOfCell(std::string_view cell);
/// A text as JSON, in quotes. Invalid UTF-8 is replaced.
std::string jsonOfText(std::string_view text);

} // namespace unprojector::cli
