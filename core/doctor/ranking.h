#pragma once

#include "core/doctor/hypotheses.h"

#include <span>
#include <string>
#include <vector>

namespace unprojector::doctor {

/// The id of a hypothesis: "right", that of its mistake, or those of both with a plus.
std::string idOf(const Hypothesis &hypothesis);
/// In which ways its mistakes are made, where there are several.
std::vector<VariantName> waysOf(const Hypothesis &hypothesis);

/// Hypotheses by how well they explain the points, the best first, each pair of mistakes once, by its best variant.
///
/// First come those that explain all digits as rounded, then those that do as cut off, each by their simplicity and then by
/// how often such mistakes are reported; then the others by their distance. A pair is left
/// out where one of its mistakes, or none at all, explains the points as well.
std::vector<Hypothesis> ranked(std::span<const Hypothesis> hypotheses);

/// How many digits a coordinate was given with, those before the first that is not 0 left out; at least 1.
int digitsOf(double coordinate, double lastDigit);
/// How many of them an answer explains.
/// @param off  as unitsOff()
int digitsExplained(double coordinate, double lastDigit, double off);

} // namespace unprojector::doctor
