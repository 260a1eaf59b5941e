#pragma once

#include "core/geometry/box.h"
#include "gui/view/painters/face_painter.h"
#include "gui/view/painters/line_painter.h"

#include <vector>

namespace unprojector::gui {

/// The shape of a user clip plane: a faint square with a border. World space.
struct ClipPlaneShape {
    std::vector<Face> faces;
    std::vector<LineSegment> border;
};

/// A square of the plane, as large as the box, at the plane's closest point to the box's centre.
/// @param plane   (A, B, C, D) with a normal
/// @param box     of the scene; if empty, nothing is shown
/// @param bounds  planes that cut the shape: the part on their negative side is left out
ClipPlaneShape clipPlaneShape(const glm::dvec4 &plane, const geometry::Box &box,
                              const std::vector<glm::dvec4> &bounds = {});

} // namespace unprojector::gui
