#include "core/geometry/viewport.h"

#include "core/geometry/finite.h"

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {
namespace {

/// floor, but a value that rounding put just below a whole number counts as that number.
double floorSnapped(double value)
{
    constexpr double kSnapPixels = 1e-6;
    const double nearest = std::round(value);
    return std::abs(value - nearest) < kSnapPixels ? nearest : std::floor(value);
}

/// The edge of device pixels to which Qt rounds an edge in logical pixels; halves go up.
double deviceEdge(double logical, double devicePixelRatio)
{
    return std::floor(logical * devicePixelRatio + 0.5);
}

} // namespace

Surface surfaceFromWidget(int widthLogical, int heightLogical, double devicePixelRatio)
{
    return {static_cast<int>(deviceEdge(widthLogical, devicePixelRatio)),
            static_cast<int>(deviceEdge(heightLogical, devicePixelRatio)), devicePixelRatio};
}

int logicalFromDevice(const Surface &surface, int pixels)
{
    return static_cast<int>(std::lround(pixels / surface.devicePixelRatio));
}

Viewport wholeSurface(const Surface &surface)
{
    return {0.0, 0.0, static_cast<double>(surface.widthPixels), static_cast<double>(surface.heightPixels)};
}

DoubleDouble aspectOf(const Viewport &viewport)
{
    return DoubleDouble(viewport.width) / viewport.height;
}

Check check(const Viewport &viewport)
{
    if (const auto value = firstNotFinite({viewport.x, viewport.y, viewport.width, viewport.height}))
        return Error{ErrorCode::NotFinite, *value};
    if (!(viewport.width > 0.0 && viewport.height > 0.0))
        return Error{ErrorCode::EmptyViewport, viewport.width, viewport.height};
    return std::monostate{};
}

Check check(const DepthRange &range)
{
    if (const auto value = firstNotFinite({range.atNear, range.atFar}))
        return Error{ErrorCode::NotFinite, *value};
    if (range.atNear == range.atFar)
        return Error{ErrorCode::EmptyDepthRange, range.atNear};
    return std::monostate{};
}

Check check(const Surface &surface)
{
    if (surface.widthPixels <= 0 || surface.heightPixels <= 0)
        return Error{ErrorCode::EmptyFramebuffer, double(surface.widthPixels), double(surface.heightPixels)};
    if (!(std::isfinite(surface.devicePixelRatio) && surface.devicePixelRatio > 0.0))
        return Error{ErrorCode::PixelRatioNotPositive, surface.devicePixelRatio};
    return std::monostate{};
}

DevicePoint deviceFromWidget(const Surface &surface, const WidgetPoint &position)
{
    return DevicePoint(position.coordinates() * surface.devicePixelRatio);
}

WidgetPoint widgetFromDevice(const Surface &surface, const DevicePoint &position)
{
    return WidgetPoint(position.coordinates() / surface.devicePixelRatio);
}

WidgetPoint widgetOnSurface(const Surface &surface, const WidgetPoint &position, const WidgetPoint &corner)
{
    const double ratio = surface.devicePixelRatio;
    const auto corrected = [ratio](double logical, double origin, int pixels) {
        const double device = (logical + origin) * ratio - deviceEdge(origin, ratio);
        return std::clamp(device, 0.0, pixels - kHalfPixel) / ratio;
    };
    return WidgetPoint(corrected(position.x, corner.x, surface.widthPixels),
                       corrected(position.y, corner.y, surface.heightPixels));
}

Result<DevicePixel> devicePixelFromWidget(const Surface &surface, const WidgetPoint &position)
{
    if (const Check valid = check(surface); !valid)
        return valid.error();
    if (const auto value = firstNotFinite(position))
        return Error{ErrorCode::NotFinite, *value};
    const DevicePoint device = deviceFromWidget(surface, position);
    const double i = floorSnapped(device.x);
    const double j = floorSnapped(device.y);
    if (i < 0.0 || j < 0.0 || i >= surface.widthPixels || j >= surface.heightPixels)
        return Error{ErrorCode::OutsideFramebuffer, position.x, position.y};
    return DevicePixel{static_cast<int>(i), static_cast<int>(j)};
}

DevicePoint pixelCenter(const DevicePixel &pixel)
{
    return DevicePoint(pixel.i + kHalfPixel, pixel.j + kHalfPixel);
}

int framebufferRow(const Surface &surface, const DevicePixel &pixel)
{
    return surface.heightPixels - 1 - pixel.j;
}

WindowPoint windowFromDevice(const Surface &surface, const DevicePoint &position, double depth)
{
    return WindowPoint(position.x, flippedY(surface, position.y), depth);
}

PrecisePoint<WindowSpace> preciseWindowFromDevice(const Surface &surface, const DevicePoint &position, double depth)
{
    const double y = flippedY(surface, position.y);
    const double lost = std::isfinite(y) ? lostBySum(surface.heightPixels, -position.y) : 0.0;
    return {position.x, DoubleDouble(y, lost), depth};
}

DevicePoint deviceFromWindow(const Surface &surface, const WindowPoint &point)
{
    return DevicePoint(point.x, flippedY(surface, point.y));
}

WindowPoint windowFromNdc(const Viewport &v, const DepthRange &range, const NdcPoint &point, NdcDepth ndcDepth)
{
    const double depth = range.atFar - range.atNear;
    return WindowPoint(v.x + (point.x + 1.0) * v.width / 2.0, v.y + (point.y + 1.0) * v.height / 2.0,
                       ndcDepth == NdcDepth::ZeroToOne ? range.atNear + point.z * depth
                                                       : range.atNear + (point.z + 1.0) * depth / 2.0);
}

NdcPoint ndcFromWindow(const Viewport &v, const DepthRange &range, const WindowPoint &point, NdcDepth ndcDepth)
{
    const double fromNear = point.z - range.atNear, depth = range.atFar - range.atNear;
    return NdcPoint(2.0 * (point.x - v.x) / v.width - 1.0, 2.0 * (point.y - v.y) / v.height - 1.0,
                    ndcDepth == NdcDepth::ZeroToOne ? fromNear / depth : 2.0 * fromNear / depth - 1.0);
}

glm::dmat4 windowFromNdc(const Viewport &v, const DepthRange &range)
{
    glm::dmat4 m(1.0);
    m[0][0] = v.width / 2.0;
    m[1][1] = v.height / 2.0;
    m[2][2] = (range.atFar - range.atNear) / 2.0;
    m[3] = {v.x + v.width / 2.0, v.y + v.height / 2.0, (range.atNear + range.atFar) / 2.0, 1.0};
    return m;
}

Result<double> unitDepth(const DepthRange &range, double depth)
{
    if (const Check valid = check(range); !valid)
        return valid.error();
    const double unit = (depth - range.atNear) / (range.atFar - range.atNear);
    if (!(unit >= 0.0 && unit <= 1.0))
        return Error{ErrorCode::DepthOutsideRange, depth};
    return unit;
}

Result<DepthShares> depthShares(const DepthRange &range, double depth)
{
    const Result<double> fromNear = unitDepth(range, depth);
    if (!fromNear)
        return fromNear.error();
    const DoubleDouble d = depth, dn = range.atNear, df = range.atFar;
    return DepthShares{(d - dn) / (df - dn), (df - d) / (df - dn)};
}

} // namespace unprojector::geometry
