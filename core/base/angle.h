#pragma once

#include "core/base/double_double.h"

#include <charconv>

namespace unprojector::base {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadiansPerDegree = 0.017453292519943295;
inline constexpr DoubleDouble kPreciseRadiansPerDegree(kRadiansPerDegree, 2.9486522708701687e-19);

constexpr double radiansFromDegrees(double degrees)
{
    return degrees * kRadiansPerDegree;
}

/// The degrees with the fewest digits that convert back to exactly these radians, so that 45 stays
/// 45. Where no double does, the nearest one.
inline double degreesFromRadians(double radians)
{
    constexpr int kUnambiguous = 15; // so few digits give these radians in one way only, however they are rounded
    const double degrees = radians / kRadiansPerDegree;
    for (int digits = 12; digits <= 17; ++digits) {
        char text[32];
        const auto written = std::to_chars(text, text + sizeof text, degrees, std::chars_format::general, digits);
        double rounded = degrees;
        std::from_chars(text, written.ptr, rounded);
        if (radiansFromDegrees(rounded) == radians
            || (digits <= kUnambiguous && (rounded * kPreciseRadiansPerDegree).value == radians))
            return rounded;
    }
    return degrees;
}

/// An angle exactly as it was given: degrees are not rounded to radians. The tangent of a field of
/// view of 179 degrees would magnify that rounding a hundredfold.
struct Angle {
    DoubleDouble radians;

    Angle(double givenRadians) : radians(givenRadians) {} // formulas and OpenGL's callers count in radians
    static Angle fromDegrees(double degrees)
    {
        Angle angle(0.0);
        angle.radians = degrees * kPreciseRadiansPerDegree;
        return angle;
    }

    /// The degrees that were given. For radians, the degrees with the fewest digits whose rounded
    /// radians are these: `fromDegrees` of them may be another angle.
    double degrees() const
    {
        const double nearest = (radians / kPreciseRadiansPerDegree).value;
        return fromDegrees(nearest) == *this ? nearest : degreesFromRadians(radians.value);
    }

    friend bool operator==(const Angle &, const Angle &) = default;
};

} // namespace unprojector::base
