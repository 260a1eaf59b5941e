#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

/// Whole lines of a text, to be read in parallel with others.
struct LineRange {
    std::size_t begin = 0, end = 0; ///< in the text
    std::size_t lines = 0;          ///< the number of line ends
    std::size_t filledLines = 0;    ///< the number of lines with more than blanks
    // Set by the readers.
    std::size_t line = 1;             ///< the number of the first line
    std::size_t first = 0, count = 0; ///< the elements in the lines
};

/// Splits a text from `begin` on into ranges of whole lines, each about `bytesEach` bytes long.
/// Line ends: LF, CRLF or CR.
std::vector<LineRange> lineRanges(std::string_view text, std::size_t begin, std::size_t bytesEach);
/// Counts a range's lines.
void countLines(std::string_view text, LineRange &range);

} // namespace unprojector::mesh::reader
