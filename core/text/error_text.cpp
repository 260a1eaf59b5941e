#include "core/text/error_text.h"

#include "core/geometry/angle.h"
#include "core/text/number_text.h"

#include <cmath>

namespace unprojector::text {
using namespace geometry;

std::string errorText(const Error &error)
{
    const std::string value = shortestText(error.value), other = shortestText(error.other);
    switch (error.code) {
    case ErrorCode::NotFinite: return value + " is not a finite number; give a number";
    case ErrorCode::NearNotPositive: return "near is " + value + "; it must be greater than 0 and smaller than far";
    case ErrorCode::NearNotBeforeFar: return "near is " + value + "; it must be smaller than far (" + other + ")";
    case ErrorCode::LeftEqualsRight: return "left and right are both " + value + "; they must differ";
    case ErrorCode::BottomEqualsTop: return "bottom and top are both " + value + "; they must differ";
    case ErrorCode::FieldOfViewOutOfRange:
        return "the vertical field of view is " + shortestText(degreesFromRadians(error.value))
               + " degrees; it must lie between 0 and 180, both excluded";
    case ErrorCode::AspectNotPositive: return "the aspect is " + value + "; it must be greater than 0";
    case ErrorCode::ShearAngleOutOfRange:
        return "the angle is " + shortestText(degreesFromRadians(error.value))
               + " degrees; it must lie between 0 and 180, both excluded";
    case ErrorCode::EyeEqualsCenter: return "eye and center are the same point; move one of them";
    case ErrorCode::UpIsZero: return "up is (0, 0, 0); give it a length";
    case ErrorCode::UpParallelToView: return "up points along the view direction; choose another one";
    case ErrorCode::EmptyViewport:
        return "the viewport is " + value + " x " + other + " pixels; width and height must be greater than 0";
    case ErrorCode::EmptyFramebuffer:
        return "the window is " + value + " x " + other + " pixels; width and height must be greater than 0";
    case ErrorCode::PixelRatioNotPositive: return "the device pixel ratio is " + value + "; it must be greater than 0";
    case ErrorCode::EmptyDepthRange: return "both ends of the depth range are " + value + "; they must differ";
    case ErrorCode::DepthOutsideRange: return "the depth " + value + " lies outside the depth range";
    case ErrorCode::OutsideFramebuffer: return "the position (" + value + ", " + other + ") lies outside the window";
    case ErrorCode::ViewportNotWhole: return value + " is not a whole number of pixels";
    case ErrorCode::ViewportTooLarge: return value + " pixels are too many; use at most " + other;
    case ErrorCode::FramebufferTooLarge:
        return "the window is " + value + " x " + other + " pixels, which is more than is drawn; make it smaller";
    case ErrorCode::DepthRangeNotDrawable: return "the depth is " + value + "; it must lie between 0 and 1";
    case ErrorCode::SingularMatrix: return "the matrix has no inverse";
    case ErrorCode::PointAtInfinity: return "the point lies at infinity";
    case ErrorCode::ScaleIsZero: return "the scale is 0; it must differ from 0";
    case ErrorCode::RotationAxisIsZero: return "the rotation axis is (0, 0, 0); give it a length";
    case ErrorCode::ClipPlaneHasNoNormal: return "A, B and C of the clip plane are all 0; one of them must differ";
    case ErrorCode::MatrixNotAProjection:
        return "the matrix is no projection of a known form: the entry " + value + " at place " + other
               + " does not fit";
    case ErrorCode::ObjectTooFar:
        return "an object reaches to " + value + ", farther than can be computed; look at its scales and translations";
    case ErrorCode::ObjectTooSmall:
        return "an object measures " + value + ", less than can be computed; look at its scales";
    case ErrorCode::ViewNotRigid: return "the view matrix does more than turn and move: " + viewFault(error);
    case ErrorCode::ViewMirrored:
        return "the view matrix is mirrored: its axes are left-handed; negate one of its first three rows";
    }
    return {};
}

std::string viewFault(const Error &error)
{
    const int column = static_cast<int>(error.other) / 4, row = static_cast<int>(error.other) % 4;
    const std::string rowName = std::to_string(row + 1), columnName = std::to_string(column + 1);
    if (row == 3)
        return shortestText(error.value) + " stands in row 4, column " + columnName + "; it must be "
               + (column == 3 ? "greater than 0" : "0");
    if (row == column)
        return "row " + rowName + " has the length " + shortestText(std::sqrt(1.0 + error.value)) + "; it must be 1";
    return "rows " + rowName + " and " + columnName + " are not perpendicular";
}

} // namespace unprojector::text
