#include "core/unproject/depth_precision.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::unproject {
using namespace geometry;

DepthScale depthScaleOf(const Setup &setup)
{
    const ProjectionWindow w = projectionWindow(setup.projection());
    return {isPerspective(setup.projection()), w.nearDistance, w.farDistance, setup.depthRange};
}

double unitDepthAt(const DepthScale &s, double distance)
{
    const double n = s.nearDistance, f = s.farDistance;
    if (!s.isPerspective)
        return (distance - n) / (f - n);
    const double stretch = std::isinf(f) ? 1.0 : f / (f - n);
    return std::clamp(stretch * (1.0 - n / distance), 0.0, 1.0);
}

double halfDepthStepAt(const DepthScale &s, const DepthFormat &format, double distance)
{
    const double n = s.nearDistance, f = s.farDistance;
    const double span = s.range.atFar - s.range.atNear;
    const double step = format.halfStep(s.range.atNear + unitDepthAt(s, distance) * span) / std::abs(span);
    if (!s.isPerspective)
        return step * (f - n);
    const double shrink = std::isinf(f) ? 1.0 : (f - n) / f;
    return step * distance * distance * shrink / n;
}

std::optional<double> nearestDistance(const Setup &setup, std::span<const Box> boxes)
{
    const EyeFrame frame = eyeFrame(setup.camera()).value();
    std::optional<double> nearest;
    for (const Box &box : boxes) {
        if (box.isEmpty())
            continue;
        double first = std::numeric_limits<double>::infinity(), last = -first;
        for (int corner = 0; corner < 8; ++corner) {
            const WorldPoint at((corner & 1) != 0 ? box.highest.x : box.lowest.x,
                                (corner & 2) != 0 ? box.highest.y : box.lowest.y,
                                (corner & 4) != 0 ? box.highest.z : box.lowest.z);
            const double distance = -eyeFromWorld(frame, at).z;
            first = std::min(first, distance);
            last = std::max(last, distance);
        }
        if (last <= 0.0)
            continue; // behind the eye
        if (first <= 0.0)
            return std::nullopt;
        nearest = std::min(nearest.value_or(first), first);
    }
    return nearest;
}

std::optional<double> betterNear(const Setup &setup, std::span<const Box> boxes)
{
    constexpr double kMargin = 0.99, kWorthwhile = 1.5;
    const DepthScale scale = depthScaleOf(setup);
    const std::optional<double> nearest = nearestDistance(setup, boxes);
    if (!scale.isPerspective || !nearest)
        return std::nullopt;
    const double most = kMargin * *nearest;
    const double unit = std::pow(10.0, std::floor(std::log10(most)));
    // A power of ten without an exact double may be rounded up.
    double better = std::floor(most / unit) * unit;
    if (better > most)
        better = std::floor(most / unit - 1.0) * unit;
    if (!(better >= kWorthwhile * scale.nearDistance) || better >= scale.farDistance)
        return std::nullopt;
    return better;
}

} // namespace unprojector::unproject
