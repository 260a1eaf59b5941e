#pragma once

#include "core/ray/scene_rays.h"

#include <array>

namespace unprojector::gui {

/// What a click would take, to be marked.
struct SnapMark {
    ray::Snap snap = ray::Snap::Surface;
    ray::SceneHit hit;
    std::array<geometry::WorldPoint, 3> corners; ///< of its triangle; of a point of a cloud they mean nothing
};

} // namespace unprojector::gui
