#pragma once

#include "core/doctor/hypotheses.h"

#include <optional>
#include <span>

namespace unprojector::doctor {

/// Whether two hypotheses give the same answers to all clicks that the points were sought with.
bool isSameHere(const Given &given, std::span<const Target> points, const Hypothesis &a, const Hypothesis &b);

/// How far a hypothesis cannot be told from the best one.
/// @param best  of ranked(), explains all points
Alike alikeOf(const Given &given, std::span<const Target> points, const Hypothesis &best, const Hypothesis &other);

/// Whether a pair is the best mistake said in other words: two mistakes of one stage, of which one undoes a part of the other, as
/// depth 0 turned round is depth 1.
bool isRestated(const Given &given, std::span<const Target> points, const Hypothesis &best, const Hypothesis &pair);

/// What two hypotheses that give the same answer have in common on their way there.
Shared sharedOf(const Given &given, const Click &click, const Hypothesis &a, const Hypothesis &b);

} // namespace unprojector::doctor
