#pragma once

#include "core/geometry/spaces.h"

#include <cstdint>

namespace unprojector::gui {

class SceneDocument;

// Clip planes through points that the user picked. Each is one step of undo.

/// The reason why a plane was not added.
enum class CutFault : std::uint8_t {
    None,
    TooMany,     ///< the scene has kMostClipPlanes already
    NoDirection, ///< both points cover the same pixel: no plane is across the view
    Refused      ///< the scene cannot have this plane
};

/// Adds a plane through a point, across the direction of view. It cuts away what is in front of the
/// point.
CutFault cutAcrossView(SceneDocument &document, const geometry::WorldPoint &point);
/// Adds a plane through two points that is a line in the view: it contains the rays of both
/// points. It keeps the side with the middle of the objects.
CutFault cutAlongView(SceneDocument &document, const geometry::WorldPoint &a, const geometry::WorldPoint &b);
/// Turns over the last plane that cuts, or removes it.
/// @return false without such a plane
bool flipLastCut(SceneDocument &document);
bool removeLastCut(SceneDocument &document);

} // namespace unprojector::gui
