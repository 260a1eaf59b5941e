#include "core/unproject/answers.h"

#include "core/geometry/unit_in_last_place.h"

#include <algorithm>
#include <cmath>

namespace unprojector::unproject {
using namespace geometry;

double ulpOfLargest(const Components<3> &point)
{
    return unitInLastPlace(std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}));
}

} // namespace unprojector::unproject
