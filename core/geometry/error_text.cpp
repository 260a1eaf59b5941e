#include "core/geometry/error_text.h"

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/geometry/numbers.h"

#include <cmath>
#include <optional>

namespace unprojector::geometry {
using namespace base;
namespace {

/// The angle in degrees, without the noise of the conversion to radians and back.
std::string degreesText(double radians)
{
    constexpr double kRounding = 1e-14;
    const double degrees = degreesFromRadians(radians);
    return shortestText(degrees, kRounding * std::abs(degrees));
}

/// The number that a value is compared with. It usually comes from a computation, so its last
/// digits are noise, unless they make the difference.
std::string comparedText(double other, double value)
{
    constexpr double kSeventhDigit = 5e-8;
    const std::string rounded = shortestText(other, kSeventhDigit * std::abs(other));
    const std::optional<double> shown = doubleFromWord(rounded);
    const bool comparesAlike = shown && (*shown < value) == (other < value) && (*shown == value) == (other == value);
    return comparesAlike ? rounded : shortestText(other);
}

/// @pre the error is ViewNotRigid
std::string viewFault(const Error &error)
{
    const int column = static_cast<int>(error.other) / 4, row = static_cast<int>(error.other) % 4;
    if (row == 3)
        return tr(column == 3 ? "%1 is in row 4, column %2; it must be greater than 0"
                              : "%1 is in row 4, column %2; it must be 0",
                  shortestText(error.value), column + 1);
    if (row == column) {
        const double length = std::sqrt(1.0 + error.value);
        return tr("row %1 has the length %2; it must be 1", row + 1,
                  shortestText(length, 0.01 * std::abs(length - 1.0))); // as exact as the fault
    }
    return tr("rows %1 and %2 are not perpendicular", row + 1, column + 1);
}

} // namespace

std::string errorText(const Error &error)
{
    using enum ErrorCode;
    const std::string value = shortestText(error.value), other = shortestText(error.other);
    switch (error.code) {
    case NotFinite: return tr("%1 is not a finite number; give a number", value);
    case NearNotPositive:
        return tr("near is %1; it must be greater than 0 and smaller than far (%2)", value,
                  comparedText(error.other, error.value));
    case NearNotBeforeFar:
        return tr("near is %1; it must be smaller than far (%2)", value, comparedText(error.other, error.value));
    case LeftEqualsRight: return tr("left and right are both %1; they must differ", value);
    case BottomEqualsTop: return tr("bottom and top are both %1; they must differ", value);
    case FieldOfViewOutOfRange:
        return tr("the vertical field of view is %1 degrees; it must lie between 0 and 180, both excluded",
                  degreesText(error.value));
    case FocalLengthIsZero: return tr("a focal length is 0; it must not be 0");
    case EmptyImage:
        return tr("the image has %1 x %2 pixels; both must be greater than 0", value, shortestText(error.other));
    case AspectNotPositive: return tr("the aspect is %1; it must be greater than 0", value);
    case ShearAngleOutOfRange:
        return tr("the angle is %1 degrees; it must lie between 0 and 180, both excluded", degreesText(error.value));
    case EyeEqualsCenter: return tr("eye and center are the same point; move one of them");
    case UpIsZero: return tr("up is (0, 0, 0); give it a length");
    case UpParallelToView: return tr("up points along the view direction; choose another direction");
    case EmptyViewport:
        return tr("the viewport is %1 x %2 pixels; width and height must be greater than 0", value, other);
    case EmptyFramebuffer:
        return tr("the window is %1 x %2 pixels; width and height must be greater than 0", value, other);
    case PixelRatioNotPositive: return tr("the device pixel ratio is %1; it must be greater than 0", value);
    case EmptyDepthRange: return tr("both ends of the depth range are %1; they must differ", value);
    case DepthOutsideRange: return tr("the depth %1 lies outside the depth range", value);
    case OutsideFramebuffer: return tr("the position (%1, %2) lies outside the window", value, other);
    case ViewportNotWhole: return tr("%1 is not a whole number of pixels", value);
    case ViewportTooLarge: return tr("%1 pixels are too many; use at most %2", value, other);
    case FramebufferTooLarge:
        return tr("the window is %1 x %2 pixels, which is more than can be drawn; make it smaller", value, other);
    case DepthRangeNotDrawable: return tr("the depth is %1; it must lie between 0 and 1", value);
    case SingularMatrix: return tr("the matrix has no inverse");
    case PointAtInfinity: return tr("the point lies at infinity");
    case ScaleIsZero: return tr("the scale is 0; it must differ from 0");
    case RotationAxisIsZero: return tr("the rotation axis is (0, 0, 0); give it a length");
    case ClipPlaneHasNoNormal: return tr("A, B and C of the clip plane are all 0; one of them must differ");
    case MatrixNotAProjection:
        return tr("the projection matrix has no known form: %1 is in row %2, column %3", value,
                  static_cast<int>(error.other) % 4 + 1, static_cast<int>(error.other) / 4 + 1);
    case ObjectTooFar:
        return tr("an object reaches to %1, farther than can be computed; check its scales and translations", value);
    case ObjectTooSmall: return tr("an object measures %1, less than can be computed; check its scales", value);
    case ViewNotRigid: return tr("the view matrix is not rotation + translation: %1", viewFault(error));
    case ViewMirrored:
        return tr("the view matrix is mirrored: its axes are left-handed; negate one of its first three rows");
    }
    return {};
}

} // namespace unprojector::geometry
