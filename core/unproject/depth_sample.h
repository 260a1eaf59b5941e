#pragma once

#include <cstddef>
#include <optional>

namespace unprojector::unproject {

/// How a depth buffer keeps depths: as whole steps of 1 / (2^bits - 1), or as floats.
struct DepthFormat {
    int bits = 24;
    bool isFloat = false; ///< of single precision, whatever `bits` says

    constexpr DepthFormat(int fixedPointBits = 24) : bits(fixedPointBits) {}
    static constexpr DepthFormat floatingPoint()
    {
        DepthFormat format(32);
        format.isFloat = true;
        return format;
    }

    /// Half the way between two depths that can be kept, at a depth in [0, 1].
    double halfStep(double depth) const;
    /// What is kept of a depth in [0, 1]: the nearest that can be.
    double kept(double depth) const;

    friend bool operator==(const DepthFormat &, const DepthFormat &) = default;
};

/// By how much the window depth of a surface changes from pixel to pixel, along x and along y. Neither is below 0.
struct DepthSlope {
    double perPixelX = 0.0;
    double perPixelY = 0.0;
};

/// Corners are put on a grid of 1/256 of a pixel before it is decided which pixels a triangle covers (GL_SUBPIXEL_BITS is 8 on
/// the graphics cards of today and in Mesa's software renderers): each is moved by no more than half of that along x and y.
constexpr double kCornerShiftPixels = 0x1p-9;

/// What the framebuffer says of one pixel.
struct DepthSample {
    double depth = 1.0; ///< in the depth range: as read on a surface, that of the far plane on background
    std::optional<std::size_t> object = {}; ///< whose surface, its place in the scene's list; nothing: background
    DepthFormat format = {};
    /// As the depths around it tell; nothing where they do not.
    std::optional<DepthSlope> slope = {};
    /// How far a triangle's corners are moved before its depths are interpolated, pixels, at most: kCornerShiftPixels on
    /// graphics cards, 0 in a renderer that interpolates between the corners as they were.
    double cornerShiftPixels = kCornerShiftPixels;
    /// How wide what was read is drawn at the least, device pixels: more than 1 where the object is a cloud whose points
    /// are dots. A dot has the depth of its point everywhere, and the point in its middle.
    double dotPixels = 1.0;

    bool hit() const { return object.has_value(); }
};

} // namespace unprojector::unproject
