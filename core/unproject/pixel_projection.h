#pragma once

#include "core/geometry/way_forward.h"
#include "core/unproject/batch/line_constants.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace unprojector::unproject {

/// Projects points to pixels, prepared once for a setup: a point in each space, with 32 digits, and
/// the pixel and depth that unproject to it.
class PixelProjection {
public:
    struct Point {
        geometry::PreciseStages way;   ///< not finite from the first stage on that has no answer
        geometry::DoubleDouble px, py; ///< device position, origin top-left
        /// The window depth; the nearer end of the depth range where the depth is outside by no
        /// more than the rounding of a point that was computed in double.
        double depth;
    };

    /// @param space  of the points
    /// @return the errors of WayForward::of
    static geometry::Result<PixelProjection> of(const geometry::Setup &setup, const BatchSpace &space);

    Point at(const glm::dvec3 &point) const;

private:
    explicit PixelProjection(const geometry::WayForward &way) : m_way(way) {}

    double depthUncertainty(const glm::dvec4 &point, const glm::dvec4 &eye, const glm::dvec4 &clip) const;

    geometry::WayForward m_way;
    BatchSpace m_space;
    geometry::Surface m_surface;
    geometry::DepthRange m_depthRange;
    glm::dmat4 m_clipMagnitudes; ///< of clipFromEye
    glm::dmat4 m_eyeMagnitudes;  ///< magnitudes of the terms that sum up to eye coordinates
};

} // namespace unprojector::unproject
