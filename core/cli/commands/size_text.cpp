#include "core/cli/commands/size_text.h"

#include "core/base/translation.h"
#include "core/cli/rows/byte_stream.h"

#include <charconv>

namespace unprojector::cli {
using base::tr;

std::optional<SizeGiven> sizeGiven(const std::string &option, const std::string &text)
{
    SizeGiven size{};
    const char *end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    const bool hasCross = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
    const auto height = std::from_chars(hasCross ? width.ptr + 1 : end, end, size.height);
    if (hasCross && height.ec == std::errc{} && height.ptr == end)
        return size;
    complain(tr("%1: give width and height in pixels, as in 800x600", option + ' ' + text));
    return std::nullopt;
}

} // namespace unprojector::cli
