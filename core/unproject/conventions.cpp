#include "core/unproject/conventions.h"

#include "core/geometry/angle.h"

#include <cmath>
#include <utility>

namespace unprojector::unproject {
namespace {

/// The surface as a program has it that counts every pixel once.
Surface inLogicalPixels(const Surface &surface)
{
    return {logicalFromDevice(surface, surface.widthPixels), logicalFromDevice(surface, surface.heightPixels), 1.0};
}

/// (i, j) where the program looks, before any half pixel, and the surface whose height it flips with.
struct Looked {
    Result<DevicePixel> pixel;
    Surface flippedWith;
};

Looked pixelOfClick(const Surface &surface, Conventions::PixelRatio ratio, const WidgetPoint &widget)
{
    using Ratio = Conventions::PixelRatio;
    switch (ratio) {
    case Ratio::Applied: break;
    case Ratio::Forgotten: return {devicePixelFromWidget(inLogicalPixels(surface), widget), surface};
    case Ratio::ForgottenInFlipToo: {
        const Surface logical = inLogicalPixels(surface);
        return {devicePixelFromWidget(logical, widget), logical};
    }
    case Ratio::AppliedTwice: {
        if (const Result<DevicePixel> once = devicePixelFromWidget(surface, widget); !once)
            return {once, surface};
        const DevicePoint twice =
            deviceFromWidget(surface, WidgetPoint(deviceFromWidget(surface, widget).coordinates()));
        return {DevicePixel{int(std::floor(twice.x)), int(std::floor(twice.y))}, surface};
    }
    }
    return {devicePixelFromWidget(surface, widget), surface};
}

} // namespace

Result<WindowPoint> windowOfClick(const Picture &picture, const Conventions &conventions, const WidgetPoint &widget,
                                  double depth)
{
    const auto [pixel, flippedWith] = pixelOfClick(picture.surface, conventions.pixelRatio, widget);
    if (!pixel)
        return pixel.error();
    DevicePoint position = pixelCenter(*pixel);
    switch (conventions.pixelPart) {
    case Conventions::PixelPart::Centre: break;
    case Conventions::PixelPart::Corner: position = DevicePoint(pixel->i, pixel->j); break;
    case Conventions::PixelPart::RowAbove: position = pixelCenter({pixel->i, pixel->j - 1}); break;
    }
    WindowPoint window = windowFromDevice(flippedWith, position, depth);
    switch (conventions.flip) {
    case Conventions::Flip::ByFramebufferHeight: break;
    case Conventions::Flip::Left: window.y = position.y; break;
    case Conventions::Flip::ByViewportHeight: window.y = picture.viewport.height - position.y; break;
    }
    return window;
}

Picture misread(const Picture &picture, const Conventions &conventions)
{
    Picture result = picture;
    switch (conventions.viewportOffset) {
    case Conventions::ViewportOffset::Taken: break;
    case Conventions::ViewportOffset::Forgotten: result.viewport.x = result.viewport.y = 0.0; break;
    case Conventions::ViewportOffset::WholeWindow: result.viewport = wholeSurface(picture.surface); break;
    }
    auto &[atNear, atFar] = result.depthRange;
    if (conventions.reversed)
        std::swap(atNear, atFar);
    // z_n = d is z_n = 2 d' - 1 with d' = (d + 1) / 2: a depth range whose near end lies as far below as its far end above.
    switch (conventions.ndcDepth) {
    case Conventions::NdcDepthTaken::ByThePicture: break;
    case Conventions::NdcDepthTaken::AsItIs: atNear -= atFar - atNear; break;
    case Conventions::NdcDepthTaken::Stretched: atNear = (atNear + atFar) / 2.0; break;
    }
    auto *projection = std::get_if<Projection>(&result.lens);
    if (auto *p = projection ? std::get_if<Perspective>(projection) : nullptr) {
        double tangent = std::tan(p->verticalFovRadians / 2.0);
        if (conventions.angleUnit == Conventions::AngleUnit::DegreesTakenForRadians)
            tangent = std::tan(degreesFromRadians(p->verticalFovRadians) / 2.0);
        if (conventions.fovAxis == Conventions::FovAxis::VerticalTakenForHorizontal)
            tangent /= p->aspect;
        // A tangent of such an angle may be negative, which no perspective has but a frustum can.
        if (conventions.angleUnit != Conventions::AngleUnit::Radians
            || conventions.fovAxis != Conventions::FovAxis::Vertical) {
            const double top = p->nearDistance * tangent, right = top * p->aspect;
            result.lens = Projection(Frustum{-right, right, -top, top, p->nearDistance, p->farDistance});
        }
    }
    return result;
}

} // namespace unprojector::unproject
