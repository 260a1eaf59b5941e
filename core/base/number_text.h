#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace unprojector::base {

/// Appends the fewest digits that read back to the same double: 4000000 is "4e+06".
inline void appendNumber(std::string &text, double value)
{
    std::array<char, 32> digits;
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), written.ptr);
}

/// Returns whether a number is written with zeros rather than a power of ten: from 1e5 up to 1e10,
/// so that the coordinates of a survey stay readable.
inline bool isWrittenOut(double value)
{
    const double size = std::abs(value);
    return size >= 1e5 && size < 1e10;
}

/// The fewest digits that read back to the same double, for people: 4000000 is written in full, and a
/// NaN has no sign.
inline std::string shortestText(double value)
{
    if (std::isnan(value))
        return "nan";
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

/// The fewest digits of a number that differs from the value by less than `off`, the value's
/// uncertainty: further digits would be noise. If `off` is 0, NaN or infinite, as
/// shortestText(value).
inline std::string shortestText(double value, double off)
{
    if (off > 0.0 && std::isfinite(off)) {
        std::array<char, 32> digits;
        constexpr int kMostDecimals = 16;
        for (int decimals = 0; decimals < kMostDecimals; ++decimals) {
            const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                               std::chars_format::scientific, decimals);
            double rounded = value;
            std::from_chars(digits.data(), written.ptr, rounded);
            if (std::abs(rounded - value) < off)
                return shortestText(rounded);
        }
    }
    return shortestText(value);
}

/// The value with at most the given number of significant digits.
inline std::string significantText(double value, int digits)
{
    std::array<char, 32> text;
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value + 0.0, std::chars_format::general, digits);
    return {text.data(), written.ptr};
}

/// An upper bound in two digits, rounded up.
/// @param bound  not below 0
inline std::string boundText(double bound)
{
    if (!(bound > 0.0) || !std::isfinite(bound))
        return shortestText(bound);
    const double unit = std::pow(10.0, std::floor(std::log10(bound)) - 1.0);
    return shortestText(std::ceil(bound / unit) * unit, unit / 10.0);
}

} // namespace unprojector::base
