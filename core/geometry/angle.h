#pragma once

#include <charconv>

namespace unprojector::geometry {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadiansPerDegree = 0.017453292519943295;

constexpr double radiansFromDegrees(double degrees)
{
    return degrees * kRadiansPerDegree;
}

/// The degrees with the fewest digits that convert back to exactly these radians, so that 45 stays
/// 45. Where no double does, the nearest one.
inline double degreesFromRadians(double radians)
{
    const double degrees = radians / kRadiansPerDegree;
    for (int digits = 12; digits <= 17; ++digits) {
        char text[32];
        const auto written = std::to_chars(text, text + sizeof text, degrees, std::chars_format::general, digits);
        double rounded = degrees;
        std::from_chars(text, written.ptr, rounded);
        if (radiansFromDegrees(rounded) == radians)
            return rounded;
    }
    return degrees;
}

} // namespace unprojector::geometry
