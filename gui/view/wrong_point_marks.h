#pragma once

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/view/painters/line_painter.h"
#include "gui/view/painters/pick_painter.h"

#include <span>

namespace unprojector::gui {

/// Draws the points computed by other programs, with the right points and the lines between them,
/// over everything. The OpenGL context is current, and there is no depth test.
/// @param viewportPixels  width and height of the current viewport
void drawWrongPoints(std::span<const WrongPointMark> points, const glm::dmat4 &clipFromWorld,
                     const glm::vec2 &viewportPixels, float pixelRatio, LinePainter &lines, PickPainter &marks);

} // namespace unprojector::gui
