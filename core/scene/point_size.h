#pragma once

#include "core/geometry/viewport.h"

#include <algorithm>
#include <cmath>

namespace unprojector::scene {

/// How wide and high the dot is that a point is drawn as, in device pixels: a single pixel is hardly seen, and harder to
/// click. The point lies in its middle.
inline double pointPixels(const geometry::Surface &surface)
{
    constexpr double kLogicalPixels = 3.0;
    return std::max(kLogicalPixels, std::round(kLogicalPixels * surface.devicePixelRatio));
}

} // namespace unprojector::scene
