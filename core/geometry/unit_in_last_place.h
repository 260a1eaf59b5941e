#pragma once

#include <cmath>
#include <limits>

namespace unprojector::geometry {

/// A unit in the last place: the distance to the next larger number of the same precision.
/// @param size  0 or above
/// @return above 0; infinite at the largest number, NaN for infinity and NaN
template <class Real>
Real unitInLastPlace(Real size)
{
    return std::nextafter(size, std::numeric_limits<Real>::infinity()) - size;
}

} // namespace unprojector::geometry
