#pragma once

#include "core/geometry/viewport.h"

namespace unprojector::gui {

/// What is drawn over the objects. The crosshair and the mark under the pointer are the hand's: no picture has them.
struct PictureMarks {
    bool pick = true;      ///< the picked point, the point that is followed and those of other programs
    bool landmarks = true; ///< with their names and the chosen measure
    bool curves = true;
    bool grid = true; ///< the ground and the clip planes
    bool axes = true; ///< of the world and in the corner, with the letters of a lesson
    bool map = true;  ///< where the view shows one
};

/// A picture of the scene, to be drawn at a size of its own.
struct PictureOptions {
    geometry::Surface surface; ///< its pixels; lines, marks and letters are as many pixels large as its ratio says
    PictureMarks marks;
    bool isTransparent = false; ///< nothing is drawn behind the objects
};

} // namespace unprojector::gui
