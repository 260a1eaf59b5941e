#pragma once

#include "gui/view/painters/line_painter.h"

#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// How curves are drawn, world space: a little in front of the surface that they lie on, so that it does not hide them.
struct CurveShapes {
    std::vector<LineSegment> lines;  ///< as they go now, in the colour of their first point
    std::vector<LineSegment> former; ///< as they went before their points moved: they are being worked out
    std::vector<LineSegment> dots;   ///< semilandmarks, a line hardly longer than a point each
};
/// Curves of which a point is hidden are left out; the way along the surface that is measured is among them.
CurveShapes curveShapes(const SceneDocument &document);

} // namespace unprojector::gui
