#include "core/geometry/drawable.h"

#include <cmath>

namespace unprojector::geometry {

namespace {

/// A single-precision number as a double. It is read back from memory because GCC 12 at -O3 removes
/// two adjacent conversions and so keeps the digits that were rounded away.
double exactDouble(float number)
{
    const volatile float stored = number;
    return static_cast<double>(stored);
}

} // namespace

Check checkViewportNumber(double pixels)
{
    if (!std::isfinite(pixels))
        return Error{ErrorCode::NotFinite, pixels};
    if (pixels != std::floor(pixels))
        return Error{ErrorCode::ViewportNotWhole, pixels};
    if (std::abs(pixels) > kMostDrawnPixels)
        return Error{ErrorCode::ViewportTooLarge, pixels, double(kMostDrawnPixels)};
    return std::monostate{};
}

Check checkDepthRangeEnd(double depth)
{
    if (!std::isfinite(depth))
        return Error{ErrorCode::NotFinite, depth};
    if (!(depth >= 0.0 && depth <= 1.0))
        return Error{ErrorCode::DepthRangeNotDrawable, depth};
    return std::monostate{};
}

Result<Drawable> drawable(const Setup &setup)
{
    if (const Check valid = check(setup); !valid)
        return valid.error();
    const auto &[surface, viewport, range, lens, pose] = setup;
    if (surface.widthPixels > kMostDrawnPixels || surface.heightPixels > kMostDrawnPixels)
        return Error{ErrorCode::FramebufferTooLarge, double(surface.widthPixels), double(surface.heightPixels)};
    for (const double pixels : {viewport.x, viewport.y, viewport.width, viewport.height}) {
        if (const Check valid = checkViewportNumber(pixels); !valid)
            return valid.error();
    }
    for (const double depth : {range.atNear, range.atFar}) {
        if (const Check valid = checkDepthRangeEnd(depth); !valid)
            return valid.error();
    }
    Drawable result{setup,
                    static_cast<std::int32_t>(viewport.x),
                    static_cast<std::int32_t>(viewport.y),
                    static_cast<std::int32_t>(viewport.width),
                    static_cast<std::int32_t>(viewport.height),
                    static_cast<float>(range.atNear),
                    static_cast<float>(range.atFar)};
    if (result.depthAtNear == result.depthAtFar)
        return Error{ErrorCode::EmptyDepthRange, range.atNear};
    result.setup.depthRange = {exactDouble(result.depthAtNear), exactDouble(result.depthAtFar)};
    return result;
}

} // namespace unprojector::geometry
