#pragma once

#include "core/geometry/camera.h"
#include "core/mesh/mesh.h"
#include "gui/view/painters/line_painter.h"

#include <vector>

namespace unprojector::gui {

/// A grid on the bottom of the box, at multiples of the spacing, every tenth line stronger. World
/// space.
std::vector<LineSegment> groundLines(const geometry::Box &ground, double spacing);

/// The world axes from the origin, x red, y green, z blue, as long as the ground extends from
/// there.
std::vector<LineSegment> axisLines(const geometry::Box &ground);

/// Lines from a point along each axis to the coordinate planes: the plane x = 0, the ground, the
/// plane z = 0. If the origin lies outside the ground, the ground's lowest corner replaces it.
/// World space.
std::vector<LineSegment> dropLines(const geometry::WorldPoint &point, const geometry::Box &ground);

/// The same lines, faint: for lines hidden behind a surface.
std::vector<LineSegment> faded(std::vector<LineSegment> lines);

/// The directions of the world axes with their letters, for a corner of the view. Eye axes, about
/// one unit in size.
std::vector<LineSegment> triadLines(const geometry::EyeFrame &frame);

} // namespace unprojector::gui
