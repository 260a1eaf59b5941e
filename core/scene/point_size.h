#pragma once

#include "core/geometry/viewport.h"

#include <algorithm>
#include <cmath>

namespace unprojector::scene {

/// The width and height of the dot that a point is drawn as, in device pixels. A single pixel is
/// hard to see and to click. The point lies in its middle.
inline double pointPixels(const geometry::Surface &surface)
{
    constexpr double kLogicalPixels = 3.0;
    return std::max(kLogicalPixels, std::round(kLogicalPixels * surface.devicePixelRatio));
}

} // namespace unprojector::scene
