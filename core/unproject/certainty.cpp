#include "core/unproject/certainty.h"

#include "core/geometry/proportions.h"

#include <algorithm>
#include <cmath>

namespace unprojector::unproject {

double Certainty::radius() const
{
    return std::max({halfDepthStep, footprintWidth / 2.0, footprintHeight / 2.0});
}

Certainty certaintyAt(const Picture &picture, double distance, int depthBits)
{
    const ProjectionWindow w = projectionWindow(picture.projection());
    const double n = w.nearDistance, f = w.farDistance;
    const auto &[atNear, atFar] = picture.depthRange;
    const double steps = (std::ldexp(1.0, depthBits) - 1.0) * std::abs(atFar - atNear);
    const double step =
        isPerspective(picture.projection()) ? distance * distance * (f - n) / (f * n) / steps : (f - n) / steps;
    const glm::dvec2 footprint = pixelFootprint(picture, distance);
    return {step / 2.0, footprint.x, footprint.y};
}

} // namespace unprojector::unproject
