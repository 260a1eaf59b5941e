#pragma once

#include <QOpenGLExtraFunctions>

namespace unprojector::gui {

/// The largest distance by which this OpenGL moves the corners of a triangle before it interpolates
/// its depths, pixels along x and y. Graphics cards snap corners to a grid, and the surface moves
/// along; software renderers may snap them for coverage only. OpenGL reports no number for this. So
/// the function draws a steep triangle between the pixels and reads its depths. Rounded up to a
/// power of two; 0 below 1/16384.
///
/// Measured once for each kind of OpenGL, in a millisecond. Restores all bindings.
/// @param grid  corners in a pixel, to simulate such a grid; 0: OpenGL's own
/// @return DepthSample's own bound if OpenGL cannot draw the test image
/// @pre an OpenGL context is current
double measuredCornerShift(QOpenGLExtraFunctions &gl, double grid = 0.0);

} // namespace unprojector::gui
