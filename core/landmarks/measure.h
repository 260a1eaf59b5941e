#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"

#include <cstddef>
#include <optional>
#include <span>

namespace unprojector::landmarks {

/// A length (world units) or an angle (radians), and how far it can be off at most, to first order: each coordinate of each
/// point may be off by its uncertainty, all of them at once and to the worse side, so
///
///   error = sum over points and axes of |d value / d coordinate| * uncertainty
///
/// Where points may be as far off as they lie apart, so that the direction between them is open, the error is the sum of what each
/// point can do whichever way it moves. Nothing where the uncertainty of one of the points is not known.
struct Measure {
    double value = 0.0;
    std::optional<double> error;
};

/// Why there is no such measure.
struct MeasureError {
    enum class Code {
        Missing,   ///< point: has no place
        TooFew,    ///< a length along fewer than two points
        SamePoint, ///< point: lies where the angle's vertex does, so the leg to it has no direction
        NoPlane,   ///< the three points lie on one line, or may
    };
    Code code;
    std::size_t point = 0; ///< place among those given
};

using Measured = geometry::Result<Measure, MeasureError>;

/// From one point to the other. Where that is no farther than both may be off, the direction between them is anything: the error is
/// then the sum of the lengths of both uncertainties.
Measured distanceOf(const Landmark &a, const Landmark &b);

/// The length of the way along points in their order. A point between two others moves both its pieces: their errors are
/// not added, but follow from where it moves.
Measured lengthAlong(std::span<const Landmark *const> points);

/// The angle at `vertex` between the directions to a and c, in [0, pi]. Where it may be 0 or pi any way to the side opens it: the
/// errors are then the lengths of the uncertainties over those of the legs. It is off by no more than to 0 and to pi.
Measured angleAt(const Landmark &vertex, const Landmark &a, const Landmark &c);

/// How high a point is over the plane of three others; above 0 on the side from which these go round counter-clockwise.
///
/// Three points of which one may lie on the line of the others, since they are no farther from it than all may be off, have no plane.
///
///   h = n . (p - a);   dh/dp = n;   dh/da = -l_a n and so on, l the barycentric coordinates of p's foot in the triangle
Measured heightOver(const Landmark &a, const Landmark &b, const Landmark &c, const Landmark &landmark);

} // namespace unprojector::landmarks
