#pragma once

#include "core/doctor/hypotheses.h"

#include <functional>
#include <optional>
#include <span>

namespace unprojector::doctor {

/// True if two hypotheses give the same answers to all clicks of the targets.
bool isSameHere(const Given &given, const Hypothesis &a, const Hypothesis &b);

/// The extent to which a hypothesis cannot be distinguished from the best one.
/// @param best  of ranked(), explains all points
Alike alikeOf(const Given &given, const Hypothesis &best, const Hypothesis &other);

/// True if a pair is equivalent to the best mistake: two mistakes of one stage, one of which undoes
/// part of the other; or the two that a mistake consists of by name. Examples: depth 0, reversed,
/// is depth 1; OpenCV's axes are y not flipped and z positive.
bool isRestated(const Given &given, const Hypothesis &best, const Hypothesis &pair);

/// The common intermediate result of two hypotheses that give the same answer.
Shared sharedOf(const Given &given, const Click &click, const Hypothesis &a, const Hypothesis &b);

/// A click that distinguishes hypotheses.
struct NextClick {
    geometry::DevicePoint pixel; ///< the pixel's centre
    double apart = 0.0;          ///< least distance of the first hypothesis's answer from any other
};

/// The pixel, on a grid over the viewport, where the first hypothesis's answer is farthest from all
/// others. Hypotheses with the same answers on the whole grid are skipped.
/// @param like      a click of the same program: its space, and its depth if there is no mesh
/// @param depthAt   depth of a mesh, see depthOnMesh(); may be empty
/// @param tellable  least distance of distinguishable points, units of their space
/// @return empty if no click distinguishes them
std::optional<NextClick> nextClick(const Given &given, const Click &like, std::span<const Hypothesis> hypotheses,
                                   const std::function<std::optional<double>(const geometry::DevicePoint &)> &depthAt,
                                   double tellable);

} // namespace unprojector::doctor
