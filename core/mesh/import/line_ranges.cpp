#include "core/mesh/import/line_ranges.h"

#include <algorithm>

namespace unprojector::mesh::reader {

std::vector<LineRange> lineRanges(std::string_view text, std::size_t begin, std::size_t bytesEach)
{
    std::vector<LineRange> ranges;
    while (begin < text.size()) {
        std::size_t end = std::min(text.size(), begin + bytesEach);
        end = std::min(text.find_first_of("\n\r", end), text.size());
        if (end < text.size())
            end += text.substr(end).starts_with("\r\n") ? 2U : 1U;
        LineRange range;
        range.begin = begin;
        range.end = end;
        ranges.push_back(range);
        begin = end;
    }
    return ranges;
}

void countLines(std::string_view text, LineRange &range)
{
    bool isFilled = false;
    for (std::size_t at = range.begin; at < range.end; ++at) {
        const char c = text[at];
        if (c == '\n' || (c == '\r' && !(at + 1 < text.size() && text[at + 1] == '\n'))) {
            range.filledLines += isFilled ? 1U : 0U;
            ++range.lines;
            isFilled = false;
        } else {
            // The same blanks as in TextScanner.
            isFilled = isFilled || !(c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0' || c == '\r');
        }
    }
    range.filledLines += isFilled ? 1U : 0U;
}

} // namespace unprojector::mesh::reader
