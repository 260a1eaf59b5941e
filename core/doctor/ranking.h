#pragma once

#include "core/doctor/hypotheses.h"

#include <span>
#include <string>
#include <vector>

namespace unprojector::doctor {

/// The id of a hypothesis: "right", its mistake's, or both mistakes' joined by a plus.
std::string idOf(const Hypothesis &hypothesis);

/// Hypotheses ranked by how well they explain the points, the best first. Each pair of mistakes
/// occurs once, with its best variant.
///
/// The order is:
/// - hypotheses of fixed form that explain all digits as rounded: no mistake, a mistake, a pair,
/// - hypotheses of fixed form that explain all digits as truncated, in the same order,
/// - mistakes with expected values, and then with other solved values,
/// - the others by their distance.
///
/// Equal hypotheses are sorted by the number of reports of such mistakes, solved ones by roundness
/// first. A pair is omitted if one of its mistakes, or none at all, explains the points as well.
/// Solved values are omitted if fewer values explain the points, or if one mistake of fixed form,
/// or none, does so. Expected values stay if the fixed form explains the points as truncated only.
std::vector<Hypothesis> ranked(std::span<const Hypothesis> hypotheses);

/// The number of digits of a given coordinate, without leading zeros; at least 1.
int digitsOf(double coordinate, double lastDigit);
/// The number of those digits that an answer explains.
/// @param off  see unitsOff()
int digitsExplained(double coordinate, double lastDigit, double off);

/// What the chance of an explanation follows from.
struct Evidence {
    std::span<const Hypothesis> all; ///< all hypotheses tried
    double apart = 0.0;              ///< distance of the points from the right ones, units of the last digit
    /// The count of numbers that had to agree: three coordinates; two for a point with the right
    /// depth or an unknown depth. It is one for a point on the right ray, because the answers of all
    /// depth mistakes lie on it. Several points multiply their chances.
    int agreeing = 0;
};

/// The chance that one of the hypotheses explains a point that comes from none of them. It is not
/// assumed but measured near the point.
/// @param best  the one that explains the point
double chanceOf(const Evidence &evidence, const Hypothesis &best);

} // namespace unprojector::doctor
