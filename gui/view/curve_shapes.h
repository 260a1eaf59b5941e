#pragma once

#include "gui/view/painters/line_painter.h"

#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// The drawn shapes of curves, world space: slightly in front of their surface, so that it does not
/// hide them.
struct CurveShapes {
    std::vector<LineSegment> lines;  ///< up-to-date lines, in the colour of their first landmark
    std::vector<LineSegment> former; ///< lines from before their landmarks moved; new ones are being computed
    std::vector<LineSegment> dots;   ///< semilandmarks, each a line hardly longer than a point
};
/// Curves with a hidden landmark are left out; the measured geodesic is included.
CurveShapes curveShapes(const SceneDocument &document);

} // namespace unprojector::gui
