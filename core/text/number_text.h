#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace unprojector::text {

/// Appends the fewest digits that read back to the same double: 4000000 is "4e+06".
inline void appendNumber(std::string &text, double value)
{
    std::array<char, 32> digits;
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), written.ptr);
}

/// Whether a number is written out where zeros take more room than a power of ten would: up to ten thousand million, so that
/// the coordinates of a survey can be read.
inline bool isWrittenOut(double value)
{
    const double size = std::abs(value);
    return size >= 1e5 && size < 1e10;
}

/// The fewest digits that read back to the same double, for people: 4000000 is written out.
inline std::string shortestText(double value)
{
    std::string text;
    if (!isWrittenOut(value)) {
        appendNumber(text, value);
        return text;
    }
    std::array<char, 32> digits;
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
    text.append(digits.data(), written.ptr);
    return text;
}

} // namespace unprojector::text
