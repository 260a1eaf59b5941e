#pragma once

#include "core/doctor/hypotheses.h"

#include <optional>
#include <span>

namespace unprojector::doctor {

/// True if two hypotheses give the same answers to all clicks of the targets.
bool isSameHere(const Given &given, std::span<const Target> points, const Hypothesis &a, const Hypothesis &b);

/// The extent to which a hypothesis cannot be distinguished from the best one.
/// @param best  of ranked(), explains all points
Alike alikeOf(const Given &given, std::span<const Target> points, const Hypothesis &best, const Hypothesis &other);

/// True if a pair is equivalent to the best mistake: two mistakes of one stage, one of which undoes
/// part of the other; or the two that a mistake consists of by name. Examples: depth 0, reversed,
/// is depth 1; OpenCV's axes are y not flipped and z positive.
bool isRestated(const Given &given, std::span<const Target> points, const Hypothesis &best, const Hypothesis &pair);

/// The common intermediate result of two hypotheses that give the same answer.
Shared sharedOf(const Given &given, const Click &click, const Hypothesis &a, const Hypothesis &b);

} // namespace unprojector::doctor
