#include "core/ray/ray_comparison.h"

#include <algorithm>

namespace unprojector::ray {
using namespace geometry;
using namespace unproject;

using Kind = RayComparison::Kind;

namespace {

/// Returns whether a click's depth buffer cannot distinguish a point from the far plane.
bool isKeptAsFar(const Pick &pick, const WorldPoint &world)
{
    const Result<WindowPoint> window = windowFromWorld(pick.setup, world);
    const auto &[atNear, atFar] = pick.setup.depthRange;
    if (!window || atNear == atFar)
        return false;
    const double depth = std::clamp((window->z - atNear) / (atFar - atNear), 0.0, 1.0);
    return pick.sample.format.kept(depth) == 1.0;
}

} // namespace

RayComparison compared(const Pick &pick, const std::optional<SceneHit> &hit, bool isSameObject)
{
    RayComparison comparison;
    const Result<WorldPoint> &formula = pick.point.world[Method::Formula];
    const Result<EyeFrame> frame = eyeFrame(pick.setup.camera());
    const double step = 2.0 * pick.certainty.halfDepthStep;
    const bool hasBoth = hit && pick.hit() && formula && frame;
    if (hasBoth) {
        comparison.distance = distance(*formula, hit->world);
        const double deeper = eyeFromWorld(*frame, *formula).z - eyeFromWorld(*frame, hit->world).z;
        comparison.depthSteps = step > 0.0 ? deeper / step : 0.0;
    }
    if (!hit) {
        comparison.kind = pick.hit() ? Kind::OnlyFrame : Kind::Nothing;
    } else if (!hit->triangle) {
        comparison.kind = Kind::CloudPoint;
    } else if (!hasBoth) {
        comparison.kind = isKeptAsFar(pick, hit->world) ? Kind::TooFar : Kind::OnlyRay;
    } else {
        const bool isOne = comparison.distance <= length(pick.uncertainty.world) + length(hit->uncertainty);
        comparison.kind = isSameObject ? (isOne ? Kind::SameSurface : Kind::OtherPart)
                                       : (isOne ? Kind::SameDepth : Kind::OtherObject);
    }
    return comparison;
}

} // namespace unprojector::ray
