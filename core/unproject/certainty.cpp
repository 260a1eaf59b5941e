#include "core/unproject/certainty.h"

#include "core/geometry/angle.h"
#include "core/geometry/proportions.h"

#include <glm/common.hpp>

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

Uncertainty uncertaintyOf(const Picture &picture, const EyePoint &eye, const Certainty &certainty)
{
    // Along the ray through the pixel, for a unit of distance in front of the eye.
    glm::dvec3 ray(0.0, 0.0, -1.0);
    if (const auto *oblique = std::get_if<Oblique>(&picture.projection()))
        ray = {cotangent(oblique->thetaRadians), cotangent(oblique->phiRadians), -1.0};
    else if (isPerspective(picture.projection()))
        ray = eye.coordinates() / -eye.z;
    const glm::dvec3 parts[] = {ray * certainty.halfDepthStep,
                                {certainty.footprintWidth / 2.0, 0.0, 0.0},
                                {0.0, certainty.footprintHeight / 2.0, 0.0}};
    const EyeFrame frame = eyeFrame(picture.camera()).value();
    glm::dvec3 inEye(0.0), inWorld(0.0);
    for (const glm::dvec3 &part : parts) {
        inEye += glm::abs(part);
        inWorld += glm::abs(part.x * frame.side.coordinates() + part.y * frame.upward.coordinates()
                            - part.z * frame.forward.coordinates());
    }
    return {EyeVector(inEye), WorldVector(inWorld)};
}

} // namespace unprojector::unproject
