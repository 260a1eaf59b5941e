#pragma once

#include "core/geometry/spaces.h"

namespace unprojector::ray {

/// A part of a straight line: from + t along, low <= t <= high. `along` has any length but 0, and t
/// is in units of it. Affine transforms keep t: a point of a ray has the same t in world space and
/// in every object's space, so hits on different objects compare.
template <class Space>
struct Ray {
    geometry::Point<Space> from;
    geometry::Vector<Space> along;
    double low = 0.0;
    double high = 1.0; ///< infinity: the ray has no end
    /// The largest deviation of its points with t in [0, 1], beyond the rounding of `from` and
    /// `along` to doubles.
    geometry::Vector<Space> error = {};

    geometry::Point<Space> at(double t) const { return from + along * t; }
};

} // namespace unprojector::ray
