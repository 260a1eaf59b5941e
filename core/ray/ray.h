#pragma once

#include "core/geometry/spaces.h"

namespace unprojector::ray {

/// A part of a straight line: from + t along, low <= t <= high. `along` has any length but 0, and t counts in lengths of it:
/// since objects are placed by affine transforms, a point of a ray has one and the same t in world space and in the space
/// of each object, and hits on different objects compare.
template <class Space>
struct Ray {
    geometry::Point<Space> from;
    geometry::Vector<Space> along;
    double low = 0.0;
    double high = 1.0; ///< infinity: no end

    geometry::Point<Space> at(double t) const { return from + along * t; }
};

} // namespace unprojector::ray
