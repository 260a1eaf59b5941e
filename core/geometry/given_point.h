#pragma once

#include "core/geometry/spaces.h"

#include <string>
#include <variant>

namespace unprojector::geometry {

/// A point in numbers that somebody gives, in the space that they have it in. From there it is followed both ways.
struct GivenPoint {
    std::variant<ObjectPoint, WorldPoint, EyePoint, ClipPoint, NdcPoint, WindowPoint> point = WorldPoint();
    std::string object = {}; ///< whose space an object point is in, by name; empty: worldFromObject is the identity
    friend bool operator==(const GivenPoint &, const GivenPoint &) = default;
};

} // namespace unprojector::geometry
