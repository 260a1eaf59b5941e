#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"

#include <cstddef>
#include <optional>
#include <span>

namespace unprojector::landmarks {

/// A length (world units) or an angle (radians), and its largest error to first order. Each
/// coordinate of each point may be off by its uncertainty, all at once and in the worse direction,
/// so
///
///   error = sum over points and axes of |d value / d coordinate| * uncertainty
///
/// If points may be off by their distance, the direction between them is undefined. The error is
/// then the sum of what each point can cause in any direction. Empty if the uncertainty of one of
/// the points is unknown.
struct Measure {
    double value = 0.0;
    std::optional<double> error;
};

/// The reason why a measure is undefined.
struct MeasureError {
    enum class Code {
        Missing,   ///< point: has no position
        TooFew,    ///< a length along fewer than two points
        SamePoint, ///< point: coincides with the angle's vertex, so the leg to it has no direction
        NoPlane,   ///< the three points lie on one line, or may do so
    };
    Code code;
    std::size_t point = 0; ///< index among the given points
};

using Measured = geometry::Result<Measure, MeasureError>;

/// The distance of two points. If it is within both uncertainties, the direction between them is
/// undefined. The error is then the sum of the lengths of both uncertainties.
Measured distanceOf(const Landmark &a, const Landmark &b);

/// The length of the path along points in their order. A point between two others moves both its
/// pieces. Their errors are not added; the error follows from the point's movement.
Measured lengthAlong(std::span<const Landmark *const> points);

/// The angle at `vertex` between the directions to a and c, in [0, pi]. Where it may be 0 or pi,
/// any movement to the side opens it. The errors are then the lengths of the uncertainties over the
/// lengths of the legs. The error is limited to the range from 0 to pi.
Measured angleAt(const Landmark &vertex, const Landmark &a, const Landmark &c);

/// The height of a point above the plane of three others. It is above 0 on the side from which
/// these run counter-clockwise.
///
/// Three points have no plane if one of them may lie on the line of the others: its distance from
/// it is within all uncertainties.
///
///   h = n . (p - a);   dh/dp = n;   dh/da = -l_a n and so on, l the barycentric coordinates of p's
///   foot in the triangle
Measured heightOver(const Landmark &a, const Landmark &b, const Landmark &c, const Landmark &landmark);

} // namespace unprojector::landmarks
