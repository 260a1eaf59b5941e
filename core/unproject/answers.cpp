#include "core/unproject/answers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::unproject {

double ulpOfLargest(const Components<3> &point)
{
    const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

} // namespace unprojector::unproject
