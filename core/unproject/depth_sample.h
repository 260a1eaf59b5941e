#pragma once

#include <cstddef>
#include <optional>

namespace unprojector::unproject {

/// The storage of depths in a depth buffer: whole steps of 1 / (2^bits - 1), or floats.
struct DepthFormat {
    int bits = 24;
    bool isFloat = false; ///< single precision; `bits` is ignored

    constexpr DepthFormat(int fixedPointBits = 24) : bits(fixedPointBits) {}
    static constexpr DepthFormat floatingPoint()
    {
        DepthFormat format(32);
        format.isFloat = true;
        return format;
    }

    /// Half the distance between two adjacent stored depths, at a depth in [0, 1].
    double halfStep(double depth) const;
    /// The nearest stored depth to a depth in [0, 1].
    double kept(double depth) const;

    friend bool operator==(const DepthFormat &, const DepthFormat &) = default;
};

/// The change of a surface's window depth from pixel to pixel, along x and along y. Neither is
/// below 0.
struct DepthSlope {
    double perPixelX = 0.0;
    double perPixelY = 0.0;
};

/// The largest shift of a triangle's corners along x and y, in pixels. Rasterisers snap corners to
/// a grid of 1/256 of a pixel (GL_SUBPIXEL_BITS is 8 on current graphics cards and in Mesa's
/// software renderers); the shift is half of that.
constexpr double kCornerShiftPixels = 0x1p-9;

/// The framebuffer's contents at one pixel.
struct DepthSample {
    double depth = 1.0;                     ///< in the depth range: as read on a surface, the far plane's on background
    std::optional<std::size_t> object = {}; ///< index in the scene's list of the surface's object; nothing: background
    DepthFormat format = {};
    /// Derived from the depths around it; nothing if they do not allow it.
    std::optional<DepthSlope> slope = {};
    /// The largest shift of a triangle's corners before its depths are interpolated, in pixels:
    /// kCornerShiftPixels on graphics cards, 0 in a renderer that interpolates between the exact
    /// corners.
    double cornerShiftPixels = kCornerShiftPixels;
    /// The minimum width of the drawn element, device pixels: more than 1 if the object is a cloud
    /// whose points are dots. A dot has the depth of its point everywhere, and the point in its
    /// middle.
    double dotPixels = 1.0;

    bool hit() const { return object.has_value(); }
};

} // namespace unprojector::unproject
