#pragma once

#include "core/ray/scene_rays.h"

#include <optional>
#include <string>

namespace unprojector::ray {

/// The visible vertex, edge or face that a click snaps to.
/// @param snap  not Surface
std::optional<SceneHit> snapped(const SceneRays &rays, const geometry::DevicePoint &position, Snap snap);

/// The reason why a click found nothing, in the language of base::tr().
std::string nothingText(Snap snap);

} // namespace unprojector::ray
