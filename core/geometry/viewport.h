#pragma once

#include "core/geometry/numbers.h"
#include "core/geometry/result.h"
#include "core/geometry/spaces.h"

#include <glm/mat4x4.hpp>

namespace unprojector::geometry {

/// The surface that a view draws into: its framebuffer in device pixels and the device pixels per
/// logical pixel (fractional ratios such as 1.25 exist).
struct Surface {
    int widthPixels = 0;
    int heightPixels = 0;
    double devicePixelRatio = 1.0;
    friend bool operator==(const Surface &, const Surface &) = default;
};

/// The surface of a widget of this size in logical pixels: width * ratio and height * ratio,
/// rounded to whole pixels (halves up), as Qt sizes the framebuffer of an OpenGL widget.
Surface surfaceFromWidget(int widthLogical, int heightLogical, double devicePixelRatio);

/// The arguments of glViewport(x, y, width, height), device pixels, origin at the bottom-left
/// corner of the framebuffer. It need not fill the window.
struct Viewport {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    friend bool operator==(const Viewport &, const Viewport &) = default;
};

/// Device pixels converted to logical ones and rounded to whole ones: the inverse of
/// surfaceFromWidget.
int logicalFromDevice(const Surface &surface, int pixels);

Viewport wholeSurface(const Surface &surface);

/// Width / height, the aspect of a projection that follows the viewport: not rounded to a double.
DoubleDouble aspectOf(const Viewport &viewport);

/// The arguments of glDepthRange(atNear, atFar): the window depths of the near and far planes. They
/// may be reversed, not equal.
struct DepthRange {
    double atNear = 0.0;
    double atFar = 1.0;
    friend bool operator==(const DepthRange &, const DepthRange &) = default;
};

/// The NDC depths that the near and far ends of the depth range map to: OpenGL's [-1, 1], or [0, 1]
/// as in Direct3D, Vulkan and glClipControl(GL_ZERO_TO_ONE).
enum class NdcDepth { MinusOneToOne, ZeroToOne };

/// @return NotFinite; EmptyViewport (width or height not above 0); EmptyDepthRange
Check check(const Viewport &viewport);
Check check(const DepthRange &range);
/// @return EmptyFramebuffer; PixelRatioNotPositive (NaN and infinity included)
Check check(const Surface &surface);

// ---- widget <-> device <-> window: the y flip, the pixel ratio and half a pixel -----------------

/// Continuous device position (px, py) of a widget position: widget * ratio. px and py are the
/// inputs of formulas (7) to (12): origin top-left, the centre of pixel (i, j) at (i + 1/2, j +
/// 1/2).
DevicePoint deviceFromWidget(const Surface &surface, const WidgetPoint &position);
WidgetPoint widgetFromDevice(const Surface &surface, const DevicePoint &position);

/// The position on the surface of a position in a view. Where a ratio is not whole, Qt rounds the
/// view's corner, and with it the surface, to the nearest whole device pixel. A position that this
/// moves over the edge is clamped to the surface.
/// @param corner  corner of the view in its window, logical pixels
WidgetPoint widgetOnSurface(const Surface &surface, const WidgetPoint &position, const WidgetPoint &corner);

/// The pixel that contains a widget position: floor(widget * ratio). A product within 1e-6 of a
/// whole number counts as that number. With ratio 1.75 the widget position of device column 61 is
/// 61 / 1.75, whose product with 1.75 rounds to just below 61.
/// @return OutsideFramebuffer; the errors of check(surface); NotFinite
Result<DevicePixel> devicePixelFromWidget(const Surface &surface, const WidgetPoint &position);

/// The offset from a pixel's corner to its centre, in pixels.
constexpr double kHalfPixel = 0.5;

/// (i + 1/2, j + 1/2): where OpenGL samples, and where a click on the pixel is unprojected.
DevicePoint pixelCenter(const DevicePixel &pixel);

/// The framebuffer row of a pixel, counted from the bottom as glReadPixels counts: H - 1 - j.
int framebufferRow(const Surface &surface, const DevicePixel &pixel);

/// Flips y from window to device or back: H - y. This program's own points use it. Three others
/// write it out: the batch loops (unproject/batch), which take many points at once; framebufferRow,
/// for whole rows; and code for other programs, which may flip about another height
/// (api_conventions, doctor, unproject/other_programs).
template <class Number>
Number flippedY(const Surface &surface, const Number &y)
{
    return Number(static_cast<double>(surface.heightPixels)) - y;
}

/// (7) x_v = px and (8) y_v = rect.bottom - py, with rect.bottom = H, the framebuffer's height. The
/// paper and `zhangci` use an integer py in (8), which gives the pixel's upper edge. Here py is
/// continuous and includes the half pixel of a centre.
WindowPoint windowFromDevice(const Surface &surface, const DevicePoint &position, double depth);
/// The same unrounded: H - py need not be a double where py is no pixel's centre.
PrecisePoint<WindowSpace> preciseWindowFromDevice(const Surface &surface, const DevicePoint &position, double depth);
DevicePoint deviceFromWindow(const Surface &surface, const WindowPoint &point);

// ---- NDC <-> window -----------------------------------------------------------------------------

/// The viewport transform:
///
///   x_w = vx + (x_n + 1) w / 2, y_w = vy + (y_n + 1) h / 2, d = dn + (z_n + 1) (df - dn) / 2;
///
/// If NDC depths go from 0 to 1, d = dn + z_n (df - dn).
/// @pre the viewport and the depth range are valid
WindowPoint windowFromNdc(const Viewport &viewport, const DepthRange &range, const NdcPoint &point,
                          NdcDepth ndcDepth = NdcDepth::MinusOneToOne);
NdcPoint ndcFromWindow(const Viewport &viewport, const DepthRange &range, const WindowPoint &point,
                       NdcDepth ndcDepth = NdcDepth::MinusOneToOne);

/// windowFromNdc as a matrix, the last factor of MVPW.
glm::dmat4 windowFromNdc(const Viewport &viewport, const DepthRange &range);

/// The depth mapped back to [0, 1], 0 on the near plane: (d - dn) / (df - dn).
/// @return DepthOutsideRange (NaN included; both ends are inside), EmptyDepthRange
Result<double> unitDepth(const DepthRange &range, double depth);

/// A depth as shares of the distance from the near and from the far plane, both in [0, 1]. They add
/// up to 1. 1 - fromNear would lose digits of a point close to the far plane when the range is
/// reversed or partial. A perspective's distance depends on those digits.
struct DepthShares {
    DoubleDouble fromNear; ///< (d - dn) / (df - dn), the unit depth
    DoubleDouble fromFar;  ///< (df - d) / (df - dn)
};

/// @return the errors of unitDepth
Result<DepthShares> depthShares(const DepthRange &range, double depth);

} // namespace unprojector::geometry
