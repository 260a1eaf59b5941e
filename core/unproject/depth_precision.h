#pragma once

#include "core/geometry/box.h"
#include "core/geometry/setup.h"
#include "core/unproject/depth_sample.h"

#include <optional>
#include <span>

namespace unprojector::unproject {

/// How depths are spread over the distances in front of the eye.
struct DepthScale {
    bool isPerspective = true;  ///< else depth grows by the same all the way, as in glOrtho
    double nearDistance = 1.0;  ///< > 0 in a perspective
    double farDistance = 100.0; ///< may be infinite in a perspective
    geometry::DepthRange range;

    friend bool operator==(const DepthScale &, const DepthScale &) = default;
};

/// @pre the setup is valid and by parameters
DepthScale depthScaleOf(const geometry::Setup &setup);

/// The share of the way from the near plane's depth to the far plane's, in [0, 1]:
///
///   perspective  f (z - n) / (z (f - n)), which is 1 - n / z for a far plane at infinity;   box  (z - n) / (f - n)
///
/// @param distance  z, eye units; between near and far
double unitDepthAt(const DepthScale &scale, double distance);

/// How far along the view a surface may be from where its rounded depth says, to first order: half a step of the buffer there,
/// divided by |dd/dz|. Nothing but the rounding; see Certainty for all of it.
///
///   perspective  h / |df - dn| z^2 (f - n) / (f n), which is z^2 / n for a far plane at infinity;   box  h / |df - dn| (f - n)
///
/// @param distance  z, eye units; between near and far
/// @return eye units
/// Source: the derivative of the depth; h is DepthFormat::halfStep at the window depth of z.
double halfDepthStepAt(const DepthScale &scale, const DepthFormat &format, double distance);

/// How close to the eye the nearest of some boxes comes, along the view.
/// @param boxes  world space; empty ones and those that lie wholly behind the eye do not count
/// @return eye units; nothing where there is none, or one reaches behind the eye
/// @pre the setup is valid and by parameters
std::optional<double> nearestDistance(const geometry::Setup &setup, std::span<const geometry::Box> boxes);

/// A near plane of one digit that lies farther away than the one of a perspective and cuts none of some boxes, by a hundredth
/// and more.
/// @return eye units; nothing where none would make depths at least half as good again, and in a box, where it does nothing
/// @pre the setup is valid and by parameters
std::optional<double> betterNear(const geometry::Setup &setup, std::span<const geometry::Box> boxes);

} // namespace unprojector::unproject
