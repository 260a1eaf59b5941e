#pragma once

#include <QOpenGLExtraFunctions>

namespace unprojector::gui {

/// How far this OpenGL moves the corners of a triangle before it interpolates its depths, pixels along x and y, at most.
/// Graphics cards put corners on a grid, and the surface goes along; software renderers may put them there for what is
/// covered alone. No number of OpenGL's tells which: a steep triangle is drawn at places between the pixels, and its depths
/// tell. Rounded up to a power of two; 0 where it is less than 1/16384.
///
/// Drawn once for each kind of OpenGL, in a millisecond. Leaves nothing bound but what was.
/// @param grid  corners in a pixel: as it would be measured with such a grid; 0: OpenGL's own
/// @return DepthSample's own bound where OpenGL draws no such picture
/// @pre an OpenGL context is current
double measuredCornerShift(QOpenGLExtraFunctions &gl, double grid = 0.0);

} // namespace unprojector::gui
