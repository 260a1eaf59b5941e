#pragma once

#include "core/base/expected.h"

#include <limits>
#include <variant>

namespace unprojector::geometry {

/// The kinds of errors in an input. The caller words the message (core/geometry/error_text,
/// gui/text/error_text); `Error` carries the offending values for it.
enum class ErrorCode {
    NotFinite,             ///< value: the NaN or infinity given
    NearNotPositive,       ///< value: near; only a perspective needs near > 0
    NearNotBeforeFar,      ///< value: near, other: far
    LeftEqualsRight,       ///< value: left = right
    BottomEqualsTop,       ///< value: bottom = top
    FieldOfViewOutOfRange, ///< value: vertical field of view in radians; must lie inside (0, pi)
    AspectNotPositive,     ///< value: aspect
    FocalLengthIsZero,     ///< value: 0
    EmptyImage,            ///< value: width, other: height, of a pinhole's image
    ShearAngleOutOfRange,  ///< value: angle in radians; must lie inside (0, pi), where its cotangent is finite
    EyeEqualsCenter,       ///< the eye lies on the point it looks at
    UpIsZero,              ///< up has no length
    UpParallelToView,      ///< up points along the view direction
    EmptyViewport,         ///< value: width, other: height
    EmptyFramebuffer,      ///< value: width, other: height
    PixelRatioNotPositive, ///< value: device pixel ratio
    EmptyDepthRange,       ///< value: depth of near = depth of far
    DepthOutsideRange,     ///< value: the depth given, NaN included
    OutsideFramebuffer,    ///< value, other: the position
    SingularMatrix,        ///< the matrix has no inverse
    PointAtInfinity,       ///< the homogeneous result has w = 0
    ScaleIsZero,           ///< value: 0
    RotationAxisIsZero,    ///< the axis has no length
    ClipPlaneHasNoNormal,  ///< A = B = C = 0
    MatrixNotAProjection,  ///< value: the entry that fits no known form; other: its index, column by column from 0
    ViewportNotWhole,      ///< value: the number with a fraction; OpenGL takes whole pixels
    ViewportTooLarge,      ///< value: the number of pixels, other: the largest number that is drawn
    FramebufferTooLarge,   ///< value: width, other: height, of a window that no driver draws
    DepthRangeNotDrawable, ///< value: an end outside [0, 1], where OpenGL would clamp it
    ObjectTooFar,          ///< value: the coordinate after its transform, an infinity or NaN where that overflows
    ObjectTooSmall,        ///< value: the size after its transform
    ViewNotRigid,          ///< value: deviation of the axes from orthonormal; with other, the entry at that index
    ViewMirrored,          ///< its axes are left-handed: no eye, center and up give it
};

struct Error {
    ErrorCode code;
    double value = std::numeric_limits<double>::quiet_NaN();
    double other = std::numeric_limits<double>::quiet_NaN();
};

/// A value, or an error of an input.
template <class T, class E = Error>
using Result = base::Expected<T, E>;

/// The result of a check: nothing, or the error.
using Check = Result<std::monostate>;

} // namespace unprojector::geometry
