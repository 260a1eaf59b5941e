#pragma once

#include "core/geometry/box.h"
#include "core/geometry/setup.h"
#include "core/unproject/depth_sample.h"

#include <optional>
#include <span>

namespace unprojector::unproject {

/// The distribution of depths over the distances in front of the eye.
struct DepthScale {
    bool isPerspective = true;  ///< else depth is linear in the distance, as in glOrtho
    double nearDistance = 1.0;  ///< > 0 in a perspective
    double farDistance = 100.0; ///< may be infinite in a perspective
    geometry::DepthRange range;

    friend bool operator==(const DepthScale &, const DepthScale &) = default;
};

/// @pre the setup is valid and by parameters
DepthScale depthScaleOf(const geometry::Setup &setup);

/// The share of the range from the near plane's depth to the far plane's, in [0, 1]:
///
///   perspective  f (z - n) / (z (f - n)), which is 1 - n / z for a far plane at infinity
///   box          (z - n) / (f - n)
///
/// @param distance  z, eye units; between near and far
double unitDepthAt(const DepthScale &scale, double distance);

/// The error of the distance along the view due to rounding the depth, to first order: half a step
/// of the buffer there, divided by |dd/dz|. It covers only the rounding; see Certainty for all
/// errors.
///
///   perspective  h / |df - dn| z^2 (f - n) / (f n), which is z^2 / n for a far plane at infinity
///   box          h / |df - dn| (f - n)
///
/// @param distance  z, eye units; between near and far
/// @return eye units
/// Source: the derivative of the depth; h is DepthFormat::halfStep at the window depth of z.
double halfDepthStepAt(const DepthScale &scale, const DepthFormat &format, double distance);

/// The distance along the view from the eye to the nearest of some boxes.
/// @param boxes  world space; empty ones and those wholly behind the eye are ignored
/// @return eye units; nothing without a box, or if one reaches behind the eye
/// @pre the setup is valid and by parameters
std::optional<double> nearestDistance(const geometry::Setup &setup, std::span<const geometry::Box> boxes);

/// A better near distance for a perspective: one digit, greater than the current one, and at least
/// a hundredth nearer than all boxes.
/// @return eye units; nothing if it improves depths by less than half, and for a box, where it has
///         no effect
/// @pre the setup is valid and by parameters
std::optional<double> betterNear(const geometry::Setup &setup, std::span<const geometry::Box> boxes);

} // namespace unprojector::unproject
