#pragma once

#include "core/geometry/picture.h"

namespace unprojector::unproject {
using namespace geometry;

/// How far apart world points can lie and still give the depth and the pixel that were read.
struct Certainty {
    /// Half a step of the depth buffer at that distance, world units along the view direction: rounding the depth
    /// puts the point that the rasteriser computed within plus or minus this. The rasteriser's own error (corners snapped
    /// to 1/256 pixel, depths interpolated in single precision) comes on top and is not in it.
    double halfDepthStep = 0.0;
    /// Size of one pixel at that distance, world units.
    double footprintWidth = 0.0;
    double footprintHeight = 0.0;

    /// The largest of the three halves: the size of what the depth and the pixel that were read leave open. No bound of a
    /// coordinate: the three can add up (see uncertaintyOf), and the rasteriser's own error is not in it.
    double radius() const;
};

/// Perspective: half of z^2 (f-n) / (f n) / (2^N - 1), and (r-l) z / (n width) by (t-b) z / (n height).
/// Box: half of (f-n) / (2^N - 1), and (r-l) / width by (t-b) / height.
/// @param distance   z > 0 in front of the eye (any z for a box), eye units
/// @param depthBits  of the depth buffer, fixed point
/// @pre the picture is valid and by parameters
Certainty certaintyAt(const Picture &picture, double distance, int depthBits);

/// How far each coordinate of a point can be off for what depth and pixel leave open.
struct Uncertainty {
    EyeVector eye;
    WorldVector world;
};

/// The certainty's parts on each axis, added up, since all of them can be off at once: half a depth step along the ray
/// through the pixel, half a pixel to the side, half a pixel up. No component is below 0.
/// @param eye        the point
/// @param certainty  at its distance
/// @pre the picture is valid and by parameters; a perspective sees the point (z_eye is not 0)
Uncertainty uncertaintyOf(const Picture &picture, const EyePoint &eye, const Certainty &certainty);

} // namespace unprojector::unproject
