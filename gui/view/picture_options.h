#pragma once

#include "core/geometry/viewport.h"

namespace unprojector::gui {

/// The marks drawn over the objects. The crosshair and the snap mark belong to the pointer: no
/// image has them.
struct PictureMarks {
    bool pick = true;      ///< the pick, the user's point and the points of other programs
    bool landmarks = true; ///< with their names and the chosen measure
    bool curves = true;
    bool grid = true; ///< the ground and the clip planes
    bool axes = true; ///< the world's and the corner's, with the letters of a lesson
    bool map = true;  ///< if the view shows one
};

/// An image of the scene, drawn at a size of its own.
struct PictureOptions {
    geometry::Surface surface; ///< its pixels; lines, marks and letters scale with its pixel ratio
    PictureMarks marks;
    bool isTransparent = false; ///< without a background behind the objects
};

} // namespace unprojector::gui
