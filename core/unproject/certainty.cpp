#include "core/unproject/certainty.h"

#include "core/geometry/numbers.h"
#include "core/geometry/parallel_projection.h"
#include "core/geometry/proportions.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::unproject {
using namespace geometry;

Certainties::Certainties(const Setup &setup)
    : m_window(projectionWindow(setup.projection())), m_isPerspective(isPerspective(setup.projection())),
      m_parallel(shearOf(setup.projection()), -1.0),
      m_range(std::abs(setup.depthRange.atFar - setup.depthRange.atNear)), m_footprint(pixelFootprint(setup, 1.0)),
      m_frame(eyeFrame(setup.camera()).value())
{
}

glm::dvec3 Certainties::alongRay(const EyePoint &eye, const Certainty &certainty) const
{
    return (m_isPerspective ? eye.coordinates() / -eye.z : m_parallel) * certainty.distance;
}

Uncertainty Certainties::summed(const EyePoint &eye, const WorldPoint &world,
                                std::initializer_list<glm::dvec3> parts) const
{
    constexpr double kHalfUlp = 0x1p-53;
    glm::dvec3 inEye = kHalfUlp * glm::abs(eye.coordinates()), inWorld = kHalfUlp * glm::abs(world.coordinates());
    for (const glm::dvec3 &part : parts) {
        inEye += glm::abs(part);
        inWorld += glm::abs(part.x * m_frame.side.coordinates() + part.y * m_frame.upward.coordinates()
                            - part.z * m_frame.forward.coordinates());
    }
    return {EyeVector(inEye), WorldVector(inWorld)};
}

Certainty Certainties::at(double distance, const DepthError &error) const
{
    const double n = m_window.nearDistance, f = m_window.farDistance;
    double whole = error.whole() / m_range * (f - n), step = error.rounding / m_range * (f - n);
    if (m_isPerspective) {
        const double ofUnit = distance / (f * n); // relative, for an error of `whole` in a box
        const double rest = 1.0 - ofUnit * whole;
        whole = rest > 0.0 ? distance * ofUnit * whole / rest : f - n;
        step *= distance * ofUnit;
    }
    whole = std::min(whole, std::max({f - distance, distance - n, step}));
    const glm::dvec2 footprint = m_isPerspective ? m_footprint * distance : m_footprint;
    return {step, footprint.x, footprint.y, whole};
}

Uncertainty Certainties::of(const EyePoint &eye, const WorldPoint &world, const Certainty &certainty) const
{
    return summed(eye, world, {alongRay(eye, certainty)});
}

Uncertainty Certainties::withinPixel(const EyePoint &eye, const WorldPoint &world, const Certainty &certainty) const
{
    return summed(eye, world,
                  {alongRay(eye, certainty), glm::dvec3(certainty.footprintWidth / 2.0, 0.0, 0.0),
                   certainty.footprintHeight / 2.0 * glm::dvec3(-m_window.skew, 1.0, 0.0)});
}

} // namespace unprojector::unproject
