#include "core/unproject/pixel_projection.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::unproject {
using namespace geometry;
namespace {

glm::dmat4 magnitudes(glm::dmat4 m)
{
    for (int column = 0; column < 4; ++column)
        m[column] = glm::abs(m[column]);
    return m;
}

/// The magnitudes of a view matrix. The entries of its translation are sums of products as large as
/// the translation is long.
glm::dmat4 viewMagnitudes(const glm::dmat4 &eyeFromWorld)
{
    glm::dmat4 m = magnitudes(eyeFromWorld);
    m[3] = glm::dvec4(glm::dvec3(glm::length(glm::dvec3(m[3]))), m[3].w);
    return m;
}

/// The depth, or the nearer end of the depth range where the depth is outside by no more than the
/// uncertainty.
double depthWithin(const DepthRange &range, double depth, double uncertainty)
{
    const double nearest = std::clamp(depth, std::min(range.atNear, range.atFar), std::max(range.atNear, range.atFar));
    return std::abs(depth - nearest) <= uncertainty ? nearest : depth;
}

} // namespace

Result<PixelProjection> PixelProjection::of(const Setup &setup, const BatchSpace &space)
{
    const Result<WayForward> way = WayForward::of(setup);
    if (!way)
        return way.error();
    PixelProjection result(*way);
    result.m_space = space;
    result.m_surface = setup.surface;
    result.m_depthRange = setup.depthRange;
    result.m_clipMagnitudes = magnitudes(clipFromEye(setup).value());
    result.m_eyeMagnitudes = space.kind == BatchSpace::Kind::Eye ? glm::dmat4(1.0)
                                                                 : viewMagnitudes(eyeFromWorld(setup).value())
                                                                       * magnitudes(space.worldFromObject.rounded());
    return result;
}

PixelProjection::Point PixelProjection::at(const glm::dvec3 &point) const
{
    const PreciseStages way = m_space.kind == BatchSpace::Kind::Eye
                                  ? m_way.fromEye(precise(point))
                                  : m_way.fromWorld(m_space.worldFromObject.at(point));
    const glm::dvec4 eye(way.eye[0].value, way.eye[1].value, way.eye[2].value, 1.0);
    const glm::dvec4 clip(way.clip[0].value, way.clip[1].value, way.clip[2].value, way.clip[3].value);
    const double depth =
        depthWithin(m_depthRange, way.window[2].value, depthUncertainty(glm::dvec4(point, 1.0), eye, clip));
    return {way, way.window[0], flippedY(m_surface, way.window[1]), depth};
}

/// The possible rounding error of a point's depth. The point was computed in double before, so it
/// has an error of a few units in the last place of each term. That error is propagated to the
/// depth. 0 in the plane of the eye, where rounding dominates; the near and far planes are
/// elsewhere.
double PixelProjection::depthUncertainty(const glm::dvec4 &point, const glm::dvec4 &eye, const glm::dvec4 &clip) const
{
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
    const glm::dvec4 ofEye = kRounding * (m_eyeMagnitudes * glm::abs(point));
    const glm::dvec4 ofClip = m_clipMagnitudes * (kRounding * glm::abs(eye) + ofEye);
    if (!(1000.0 * ofClip.w <= std::abs(clip.w)))
        return 0.0;
    const double ofNdc = (ofClip.z + std::abs(clip.z / clip.w) * ofClip.w) / std::abs(clip.w);
    const auto &[atNear, atFar] = m_depthRange;
    return ofNdc * std::abs(atFar - atNear) + kRounding * std::max(std::abs(atNear), std::abs(atFar));
}

} // namespace unprojector::unproject
