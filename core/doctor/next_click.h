#pragma once

#include "core/doctor/hypotheses.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::doctor {

/// A click that distinguishes hypotheses.
struct NextClick {
    geometry::DevicePoint pixel; ///< the pixel's centre
    double apart = 0.0;          ///< least distance of the first hypothesis's answer from any other
};

/// Clicks of the same program on a grid over the viewport, where a surface is visible.
/// @param like     see nextClick
/// @param depthAt  see nextClick
std::vector<Click>
clicksOverViewport(const Given &given, const Click &like,
                   const std::function<std::optional<double>(const geometry::DevicePoint &)> &depthAt);

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
