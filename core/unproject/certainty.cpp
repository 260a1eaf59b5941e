#include "core/unproject/certainty.h"

#include "core/geometry/angle.h"
#include "core/geometry/proportions.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace unprojector::unproject {
namespace {

/// Parts of an error, as vectors of eye space, on each axis: added up, since all of them can be off at once.
Uncertainty summed(const Picture &picture, const EyePoint &eye, const WorldPoint &world,
                   std::span<const glm::dvec3> parts)
{
    constexpr double kHalfUlp = 0x1p-53;
    const EyeFrame frame = eyeFrame(picture.camera()).value();
    glm::dvec3 inEye = kHalfUlp * glm::abs(eye.coordinates()), inWorld = kHalfUlp * glm::abs(world.coordinates());
    for (const glm::dvec3 &part : parts) {
        inEye += glm::abs(part);
        inWorld += glm::abs(part.x * frame.side.coordinates() + part.y * frame.upward.coordinates()
                            - part.z * frame.forward.coordinates());
    }
    return {EyeVector(inEye), WorldVector(inWorld)};
}

/// Along the ray through the point, as far as the certainty's distance.
glm::dvec3 alongRay(const Picture &picture, const EyePoint &eye, const Certainty &certainty)
{
    glm::dvec3 ray(0.0, 0.0, -1.0); // for a unit of distance in front of the eye
    if (const auto *oblique = std::get_if<Oblique>(&picture.projection()))
        ray = {cotangent(oblique->thetaRadians), cotangent(oblique->phiRadians), -1.0};
    else if (isPerspective(picture.projection()))
        ray = eye.coordinates() / -eye.z;
    return ray * certainty.distance;
}

} // namespace

Certainty certaintyAt(const Picture &picture, double distance, const DepthError &error)
{
    const ProjectionWindow w = projectionWindow(picture.projection());
    const double n = w.nearDistance, f = w.farDistance;
    const double range = std::abs(picture.depthRange.atFar - picture.depthRange.atNear);
    double whole = error.whole() / range * (f - n), step = error.rounding / range * (f - n);
    if (isPerspective(picture.projection())) {
        const double ofUnit = distance / (f * n); // relative, of an error of `whole` in a box
        const double rest = 1.0 - ofUnit * whole;
        whole = rest > 0.0 ? distance * ofUnit * whole / rest : f - n;
        step *= distance * ofUnit;
    }
    whole = std::min(whole, std::max({f - distance, distance - n, step}));
    const glm::dvec2 footprint = pixelFootprint(picture, distance);
    return {step, footprint.x, footprint.y, whole};
}

Uncertainty uncertaintyOf(const Picture &picture, const EyePoint &eye, const WorldPoint &world,
                          const Certainty &certainty)
{
    const std::array parts{alongRay(picture, eye, certainty)};
    return summed(picture, eye, world, parts);
}

Uncertainty withinPixel(const Picture &picture, const EyePoint &eye, const WorldPoint &world,
                        const Certainty &certainty)
{
    const std::array parts{alongRay(picture, eye, certainty), glm::dvec3(certainty.footprintWidth / 2.0, 0.0, 0.0),
                           glm::dvec3(0.0, certainty.footprintHeight / 2.0, 0.0)};
    return summed(picture, eye, world, parts);
}

} // namespace unprojector::unproject
