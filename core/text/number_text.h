#pragma once

#include <array>
#include <charconv>
#include <string>

namespace unprojector::text {

/// Appends the fewest digits that read back to the same double.
inline void appendNumber(std::string &text, double value)
{
    std::array<char, 32> digits;
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), written.ptr);
}

inline std::string shortestText(double value)
{
    std::string text;
    appendNumber(text, value);
    return text;
}

} // namespace unprojector::text
