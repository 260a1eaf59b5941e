#pragma once

#include "core/ray/scene_rays.h"

#include <array>

namespace unprojector::gui {

/// The point, edge or face that a click would snap to, to be marked.
struct SnapMark {
    ray::Snap snap = ray::Snap::Surface;
    ray::SceneHit hit;
    std::array<geometry::WorldPoint, 3> corners; ///< of its triangle; meaningless for a point of a cloud
};

} // namespace unprojector::gui
