#pragma once

#include "gui/view/highlight_marks.h"

#include <QString>

namespace unprojector::gui {

// The quantities of the pick's formulas in the pictures, a term at a time, by the names that formulasOf has for them:
//
//   n, f           the near and the far plane
//   l, r, b, t     the edges of the near plane's window
//   x, y           how far the point is from the view axis
//   z, d           the distance along the view axis from the eye to the point
//   px, py         the clicked pixel from the edges of the window
//   H              the window's height
//   vx, vy, width, height   the viewport
//   eye, s, u, forward      the eye and its axes
//   world          the point
//   near, way      of the background: where the ray enters the view volume, and its way through it
//
// The pictures show the camera as it is now, and so do the marks.

/// @return none without a pick, and for other terms
HighlightMarks termInView(const SceneDocument &document, const QString &term);
/// The same in View from Outside. It has no window, and of the viewport the near plane's window stands for its size.
HighlightMarks termFromOutside(const SceneDocument &document, const ObserverPicture &picture, const QString &term);

} // namespace unprojector::gui
