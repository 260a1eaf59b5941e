#pragma once

#include "core/ray/scene_hit.h"
#include "core/unproject/pick.h"

#include <optional>

namespace unprojector::ray {

/// Compares the hit of a click's ray with the frame at its pixel. Both are for the pixel's centre.
/// If their distance is within their uncertainties, they may be the same point.
struct RayComparison {
    enum class Kind {
        SameSurface, ///< the uncertainties explain the distance
        OtherPart,   ///< farther apart: the frame shows another part of the same object
        OtherObject, ///< the frame shows another object
        SameDepth,   ///< the frame shows another object at the same depth: two coincident surfaces
        OnlyFrame,   ///< the ray hits nothing
        OnlyRay,     ///< the frame shows the background
        TooFar,      ///< the frame shows the background, because the depth buffer rounds the hit's depth to the far
                     ///< plane's
        Nothing,     ///< neither has a surface
        CloudPoint,  ///< the ray took a point near by, which need not be behind the pixel
    };
    Kind kind = Kind::Nothing;
    double distance = 0.0;   ///< from the formula's point to the ray's, world units; 0 if one is missing
    double depthSteps = 0.0; ///< how much deeper the ray's hit lies, in steps of the depth buffer; 0 if one is missing
};

/// @param pick          with its surface, once that is known
/// @param hit           of the ray through the pixel's centre, in the scene as it was at the click
/// @param isSameObject  whether the hit is on the object of the pick
RayComparison compared(const unproject::Pick &pick, const std::optional<SceneHit> &hit, bool isSameObject);

} // namespace unprojector::ray
