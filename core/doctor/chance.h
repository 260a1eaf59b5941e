#pragma once

#include "core/doctor/hypotheses.h"

#include <span>

namespace unprojector::doctor {

/// The chance that one of the hypotheses explains a point that comes from none of them.
///
/// It is measured near the point, not assumed. Let m hypotheses lie within a distance R of it,
/// evenly spread. Then one of them comes as close as t with a chance of m (t / R)^k. The result is
/// the greatest of these for m = 4, 8, … 64. k counts the numbers that had to agree: three
/// coordinates; two for a point with the right depth or an unknown depth. It is one for a point on
/// the right ray, because the answers of all depth mistakes lie on it. Several points multiply k.
///
/// @param all       all hypotheses tried
/// @param best      the one that explains the point; more complicated ones and ones with its answer
///         do not count
/// @param within    t, units of the last digit
/// @param agreeing  k
double chanceOf(std::span<const Hypothesis> all, const Hypothesis &best, double within, int agreeing);

/// The chance that a mistake with solved values explains a point that does not come from it.
///
/// Each value uses up one of the numbers that had to agree. For the others, an answer of the
/// mistake comes as close as t to a point at a distance D from the right one with a chance of
/// (2 t / D)^k. The roundness of the values is further evidence.
///
/// @param families   number of mistakes whose values are solved for
/// @param apart      D, units of the last digit
/// @param within, agreeing  see chanceOf; the solved values are not subtracted yet
double chanceOfSolved(const Hypothesis &best, std::size_t families, double apart, double within, int agreeing);

} // namespace unprojector::doctor
