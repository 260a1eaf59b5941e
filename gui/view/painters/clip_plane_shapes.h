#pragma once

#include "core/geometry/box.h"
#include "gui/view/painters/face_painter.h"
#include "gui/view/painters/line_painter.h"

#include <vector>

namespace unprojector::gui {

/// How a user clip plane is shown: a faint square with a border. World space.
struct ClipPlaneShape {
    std::vector<Face> faces;
    std::vector<LineSegment> border;
};

/// A square of the plane as large as the box, where the plane is nearest to the box's middle.
/// @param plane   (A, B, C, D) with a normal
/// @param box     of the scene; without any there is nothing to show
/// @param bounds  planes that the shape ends at: what lies on the negative side of one is left out
ClipPlaneShape clipPlaneShape(const glm::dvec4 &plane, const geometry::Box &box,
                              const std::vector<glm::dvec4> &bounds = {});

} // namespace unprojector::gui
