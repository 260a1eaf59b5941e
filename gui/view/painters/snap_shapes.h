#pragma once

#include "gui/view/painters/face_painter.h"
#include "gui/view/painters/line_painter.h"
#include "gui/view/painters/snap_mark.h"

#include <optional>
#include <vector>

namespace unprojector::gui {

/// How a mark is drawn, world space: a face with its rim, an edge, a point.
struct SnapShape {
    std::vector<Face> faces;
    std::vector<LineSegment> lines;
    std::optional<geometry::WorldPoint> point;
};
SnapShape snapShape(const SnapMark &mark);

extern const glm::vec4 kSnapColor;
/// The same lines, dark: the rim around them, so that they show on any colour.
std::vector<LineSegment> dark(std::vector<LineSegment> lines);

} // namespace unprojector::gui
