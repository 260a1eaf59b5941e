#pragma once

#include "core/ray/scene_hit.h"
#include "core/unproject/pick.h"

#include <optional>

namespace unprojector::ray {

/// What a click's ray meets, beside what the frame says of its pixel. Both are of the pixel's centre, and as far apart as what is
/// stated of either's certainty they may be one.
struct RayComparison {
    enum class Kind {
        SameSurface, ///< no farther apart than that explains
        OtherPart,   ///< farther: the frame has another part of the same object
        OtherObject, ///< the frame has another object
        SameDepth,   ///< so it has, but as deep as what the ray meets: two surfaces at one place
        OnlyFrame,   ///< the ray meets nothing
        OnlyRay,     ///< the frame has the background
        TooFar,      ///< so it has, as the depth buffer rounds the depth of what the ray meets to that of the far plane
        Nothing,     ///< both
        CloudPoint,  ///< the ray has taken a point near by, which need not be behind the pixel
    };
    Kind kind = Kind::Nothing;
    double distance = 0.0;   ///< from the formula's point to the ray's, world units; 0 where one of them is missing
    double depthSteps = 0.0; ///< how much deeper the ray's lies, in steps of the depth buffer; 0 where one is missing
};

/// @param pick          with what is known of its surface, once it is known
/// @param hit           of the ray through the pixel's centre, in the scene as it was at the click
/// @param isSameObject  whether that is on the object of the pick
RayComparison compared(const unproject::Pick &pick, const std::optional<SceneHit> &hit, bool isSameObject);

} // namespace unprojector::ray
