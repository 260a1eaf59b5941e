#pragma once

#include "gui/view/highlight_marks.h"

#include <QString>

namespace unprojector::gui {

// The marks of one term of the pick's formulas in the two views. The terms have the names of
// formulasOf:
//
//   n, f           the near and the far plane
//   l, r, b, t     the edges of the near plane's window
//   x, y           the point's distance from the view axis along s and u
//   z, d           the distance along the view axis from the eye to the point
//   px, py         the clicked pixel from the edges of the window
//   H              the window's height
//   vx, vy, width, height   the viewport
//   eye, s, u, forward      the eye and its axes
//   world          the point
//   near, way      of a pick on the background: the ray's entry into the view volume, and
//                  its segment through the volume
//
// Views and marks show the current camera, not the click's.

/// The marks in the main view; none without a pick, and for other terms.
HighlightMarks termInView(const SceneDocument &document, const QString &term);
/// The marks in View from Outside. It has no window; the edges of the near plane stand for the
/// viewport's width and height.
HighlightMarks termFromOutside(const SceneDocument &document, const ObserverPicture &picture, const QString &term);

} // namespace unprojector::gui
