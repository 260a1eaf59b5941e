#pragma once

#include "core/doctor/hypotheses.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::doctor {

/// A click that tells hypotheses apart.
struct NextClick {
    geometry::DevicePoint pixel; ///< its centre
    double apart = 0.0;          ///< how far the first hypothesis's answer is from that of any other, at least
};

/// Clicks of the same program on a grid over the viewport, where something is seen.
/// @param like     see nextClick
/// @param depthAt  see nextClick
std::vector<Click>
clicksOverViewport(const Given &given, const Click &like,
                   const std::function<std::optional<double>(const geometry::DevicePoint &)> &depthAt);

/// The pixel, of a grid over the viewport, where the answer of the first hypothesis is farthest from those of all others. Others
/// that give the same points all over the grid are passed over.
/// @param like      a click of the same program: its space, and its depth where there is no mesh
/// @param depthAt   of a mesh, see Case::depthOnMesh; may be empty
/// @param tellable  how far apart two points must be to be told apart, units of their space
/// @return nothing where nothing tells them apart
std::optional<NextClick> nextClick(const Given &given, const Click &like, std::span<const Hypothesis> hypotheses,
                                   const std::function<std::optional<double>(const geometry::DevicePoint &)> &depthAt,
                                   double tellable);

} // namespace unprojector::doctor
