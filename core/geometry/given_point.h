#pragma once

#include "core/geometry/spaces.h"

#include <string>
#include <variant>

namespace unprojector::geometry {

/// A point that the user gives in numbers, in a space of their choice. It is followed from there in
/// both directions.
struct GivenPoint {
    std::variant<ObjectPoint, WorldPoint, EyePoint, ClipPoint, NdcPoint, WindowPoint> point = WorldPoint();
    std::string object = {}; ///< name of the object that an object point belongs to; empty: worldFromObject = identity
    friend bool operator==(const GivenPoint &, const GivenPoint &) = default;
};

} // namespace unprojector::geometry
