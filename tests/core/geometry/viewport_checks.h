#pragma once

#include "core/geometry/viewport.h"
#include "tests/support/is_near.h"

#include <QtGlobal>

#include <cmath>
#include <limits>

/// Checks that the tests of the viewport's two halves share: before and behind NDC.
namespace viewport_checks {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A few roundings of numbers up to 4000.
inline constexpr double kRoundingPixels = 1e-11;
inline constexpr double kRoundingNdc = 1e-14;

inline const unprojector::geometry::Error &errorOf(const auto &result)
{
    Q_ASSERT(!result);
    return result.error();
}

/// Same number, or both NaN.
inline bool isSame(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

} // namespace viewport_checks
