#pragma once

#include "core/geometry/numbers.h"
#include "core/geometry/result.h"
#include "core/geometry/setup.h"
#include "core/geometry/way_forward.h"

#include <glm/vec4.hpp>

#include <cmath>
#include <optional>

namespace unprojector::geometry {

/// Unprojects with 32 digits and a bound on the error, for a setup of any form. It solves the
/// equations of WayForward, refines the solution once, and bounds the rest by its residual.
class WayBack {
public:
    /// @return the errors of WayForward::of and check(depthRange); SingularMatrix, also if 32 digits
    ///         bound no error
    static Result<WayBack> of(const Setup &setup);

    /// A world point before the division by w, relative to `origin`.
    struct Solution {
        DoubleDouble4 point;
        glm::dvec4 error{0.0}; ///< the largest deviation of each number

        /// Returns whether the point is at infinity as far as 32 digits tell.
        bool isAtInfinity() const { return !(std::abs(point[3].value) > 2.0 * error.w); }
    };
    /// A world point, rounded to doubles.
    struct Bounded {
        WorldPoint point;
        WorldVector error; ///< the largest deviation of each coordinate before this rounding
    };

    /// The last number is 1 / w of the clip point, so its sign is the sign of w.
    /// @return NotFinite
    Result<Solution> solution(const WindowPoint &window) const;
    /// @return PointAtInfinity
    Result<Bounded> world(const Solution &solution) const;
    /// The common point of all lines of sight; nothing if they are parallel.
    std::optional<WorldPoint> eye() const;

private:
    explicit WayBack(const WayForward &way) : m_way(way) {}
    Solution solved(const DoubleDouble4 &clip) const;

    WayForward m_way;
    DepthRange m_depthRange;
    MatrixRows<DoubleDouble> m_worldFromClip{};
    glm::dmat4 m_magnitudes{0.0}; ///< of m_worldFromClip
    glm::dmat4 m_roundings{0.0};  ///< |clipFromEye| |eyeFromWorld|, times the error of a sum of products
    glm::dmat4 m_remainder{0.0};  ///< bounds |1 - worldFromClip clipFromWorld|
};

} // namespace unprojector::geometry
