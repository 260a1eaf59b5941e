#pragma once

#include "gui/view/painters/face_painter.h"
#include "gui/view/painters/line_painter.h"
#include "gui/view/painters/snap_mark.h"

#include <optional>
#include <vector>

namespace unprojector::gui {

/// The shape of a snap mark, world space: a face with its rim, an edge, a point.
struct SnapShape {
    std::vector<Face> faces;
    std::vector<LineSegment> lines;
    std::optional<geometry::WorldPoint> point;
};
SnapShape snapShape(const SnapMark &mark);

extern const glm::vec4 kSnapColor;
/// The same lines in a dark colour: a rim that makes them visible on any colour.
std::vector<LineSegment> dark(std::vector<LineSegment> lines);

} // namespace unprojector::gui
