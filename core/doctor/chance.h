#pragma once

#include "core/doctor/hypotheses.h"

#include <span>

namespace unprojector::doctor {

/// The chance that a point which comes from none of the hypotheses is met by one of them all the same.
///
/// It is counted where the point is, not assumed: with m hypotheses within a distance R of it, evenly spread, one of them
/// comes as close as t by a chance of m (t / R)^k. Taken is the greatest of these for m = 4, 8, … 64. k is the number of
/// numbers that had to agree: three coordinates; two of a point that has the right depth or whose depth is not known; one of
/// a point on the right ray, since the answers of all mistakes of the depth lie on it. Several points multiply k.
///
/// @param all       that were tried
/// @param best      what explains the point; only what is no more complicated counts, and nothing that has its answer
/// @param within    t, units of the last digit
/// @param agreeing  k
double chanceOf(std::span<const Hypothesis> all, const Hypothesis &best, double within, int agreeing);

} // namespace unprojector::doctor
