#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

/// Whole lines of a text, to be read beside others.
struct LineRange {
    std::size_t begin = 0, end = 0; ///< in the text
    std::size_t lines = 0;          ///< ends of lines
    std::size_t filledLines = 0;    ///< lines of more than blanks
    // For who reads them.
    std::size_t line = 1;             ///< the first one's number
    std::size_t first = 0, count = 0; ///< of the elements in them
};

/// Parts a text from a place on into whole lines, each range about so many bytes long. Line ends: LF, CRLF or CR.
std::vector<LineRange> lineRanges(std::string_view text, std::size_t begin, std::size_t bytesEach);
/// Counts a range's lines.
void countLines(std::string_view text, LineRange &range);

} // namespace unprojector::mesh::reader
