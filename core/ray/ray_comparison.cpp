#include "core/ray/ray_comparison.h"

namespace unprojector::ray {

using Kind = RayComparison::Kind;

RayComparison compared(const Pick &pick, const std::optional<SceneHit> &hit, bool isSameObject)
{
    RayComparison comparison;
    const Result<WorldPoint> &formula = pick.point.world[Method::Formula];
    const Result<EyeFrame> frame = eyeFrame(pick.geometry.camera());
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
        comparison.kind = Kind::OnlyRay;
    } else {
        const bool isOne = comparison.distance <= length(pick.uncertainty.world) + length(hit->uncertainty);
        comparison.kind = isSameObject ? (isOne ? Kind::SameSurface : Kind::OtherPart)
                                       : (isOne ? Kind::SameDepth : Kind::OtherObject);
    }
    return comparison;
}

} // namespace unprojector::ray
