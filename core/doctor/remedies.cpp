#include "core/doctor/remedies.h"

#include "core/base/translation.h"
#include "core/doctor/code_for_cameras.h"
#include "core/doctor/code_for_pixels.h"
#include "core/doctor/code_for_points.h"
#include "core/doctor/written_value.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <iterator>

namespace unprojector::doctor {
using base::marked;
namespace {

constexpr Remedy kRemedies[] = {
    {"y-not-flipped", marked("y not flipped"),
     marked("y is not flipped: rows of a window count from the top, OpenGL's from the bottom."), kYNotFlipped},
    {"row-above", marked("row above"), marked("The row is one too high: H - y is taken for H - 1 - y."), kRowAbove},
    {"row-below", marked("row below"),
     marked("The row is one too low: H - 1 - y is taken for H - y, though y has its half already."), kRowBelow},
    {"pixel-corner", marked("pixel corner"),
     marked("The pixel's corner is unprojected instead of its centre: half a pixel is missing."), kPixelCorner},
    {"ratio-logical-in-device", marked("logical pixels in a device viewport"),
     marked("The pixel is in logical pixels, the viewport and the height of the flip are in device pixels."),
     kRatioLogicalInDevice},
    {"ratio-logical-both", marked("pixel and flip in logical pixels"),
     marked("The pixel and the height of the flip are in logical pixels, the viewport is in device pixels."),
     kRatioLogicalBoth},
    {"ratio-device-in-logical", marked("device pixels in a logical viewport"),
     marked("The viewport is in logical pixels, the pixel in device pixels; or the pixel ratio is applied twice."),
     kRatioDeviceInLogical},
    {"viewport-origin-ignored", marked("viewport's origin ignored"),
     marked("The viewport's origin is ignored, as if it lay in the window's corner."), kViewportOriginIgnored},
    {"viewport-y-from-top", marked("viewport's y from the top"),
     marked("The viewport's y is counted from the top of the window; OpenGL counts it from the bottom."),
     kViewportYFromTop},
    {"flipped-with-viewport-height", marked("flipped with the viewport's height"),
     marked("y is flipped with the viewport's height instead of the framebuffer's."), kFlippedWithViewportHeight},
    {"viewport-is-window", marked("window taken for viewport"), marked("The whole window is taken for the viewport."),
     kViewportIsWindow},
    {"xy-swapped", marked("x and y swapped"), marked("x and y are swapped."), kXySwapped},
    {"aspect-integer", marked("aspect integer"), marked("The aspect is divided in whole numbers: 800 / 600 is 1."),
     kAspectInteger},
    {"aspect-inverted", marked("aspect inverted"), marked("The aspect is inverted: height by width."), kAspectInverted},
    {"aspect-of-window", marked("aspect of the window"), marked("The aspect is the window's, not the viewport's."),
     kAspectOfWindow},
    {"aspect-left-out", marked("aspect left out"), marked("The aspect is left out, as in a square viewport."),
     kAspectLeftOut},
    {"aspect-stale", marked("aspect of another size"),
     marked("The aspect is not the viewport's: it is that of an earlier window size, or a fixed one."), kAspectStale},
    {"viewport-stale", marked("viewport of another size"),
     marked("The viewport or the height of the flip is that of another size."), kViewportStale},
    {"fov-degrees-as-radians", marked("degrees taken for radians"),
     marked("The field of view is in degrees where radians are meant."), kFovDegreesAsRadians},
    {"fov-radians-as-degrees", marked("radians taken for degrees"),
     marked("The field of view is in radians where degrees are meant."), kFovRadiansAsDegrees},
    {"fov-half", marked("half the field of view"), marked("Half the field of view is taken for the whole."), kFovHalf},
    {"fov-double", marked("twice the field of view"),
     marked("The field of view is twice as large: the tangent is that of half the angle."), kFovDouble},
    {"fov-horizontal", marked("horizontal field of view"),
     marked("The field of view of one axis is taken for the other's: these functions want the vertical angle."),
     kFovHorizontal},
    {"frustum-centred", marked("frustum taken for centred"),
     marked("The frustum is taken for a centred one, though the view axis is not in its middle."), kFrustumCentred},
    {"depth-not-remapped", marked("depth not remapped"),
     marked("z in NDC is taken to be the depth itself: depths go from 0 to 1, OpenGL's NDC from -1 to 1."),
     kDepthNotRemapped},
    {"depth-remapped-twice", marked("depth remapped twice"),
     marked("The depth is mapped to -1 to 1 once too often: the function does it itself, or the matrix uses 0 to 1."),
     kDepthRemappedTwice},
    {"depth-linear", marked("depth taken for linear"),
     marked("A depth is not linear in the distance: a share of the way from near to far is confused with it."),
     kDepthLinear},
    {"depth-zero", marked("depth 0"), marked("The depth is 0: it was not read, or not from the view's framebuffer."),
     kDepthZero},
    {"depth-one", marked("depth 1"), marked("The depth is 1: that of the background, or of a buffer that was cleared."),
     kDepthOne},
    {"depth-is-eye-distance", marked("distance taken for depth"),
     marked("A distance from the eye is confused with the depth."), kDepthIsEyeDistance},
    {"depth-reversed", marked("depth reversed"),
     marked("The depth is reversed: reversed depths are taken for ordinary ones, or ordinary for reversed ones."),
     kDepthReversed},
    {"depth-range-is-planes", marked("near and far as depth range"),
     marked(
         "Near and far are passed as the viewport's depth range, MinDepth and MaxDepth: usually it goes from 0 to 1."),
     kDepthRangeIsPlanes},
    {"depth-rounded", marked("depth rounded"), marked("The depth is rounded to few bits."), kDepthRounded},
    {"depth-range-ignored", marked("depth range ignored"),
     marked("The depth range is ignored, as if it went from 0 to 1."), kDepthRangeIgnored},
    {"depth-of-another-row", marked("depth of another row"), marked("The depth is that of a neighbouring row."),
     kDepthOfAnotherRow},
    {"near-differs", marked("another near plane"), marked("The near plane is not that of the view."), kNearDiffers},
    {"far-differs", marked("another far plane"), marked("The far plane is not that of the view."), kFarDiffers},
    {"ray-length-as-z", marked("ray length used as z"),
     marked("The length of the ray is taken for z: z is measured along the view axis."), kRayLengthAsZ},
    {"z-as-ray-length", marked("z used as ray length"),
     marked("z is taken for the length of the ray: z is measured along the view axis."), kZAsRayLength},
    {"linear-angle", marked("angle interpolated"),
     marked("The ray's angle is interpolated; it is its tangent that is linear in the pixel."), kLinearAngle},
    {"ortho-formula", marked("orthographic formula"),
     marked("The formula of an orthographic view is used in a perspective one: x and y are not scaled by z / near."),
     kOrthoFormula},
    {"divided-by-far", marked("divided by far"),
     marked("The near plane's window is scaled by z / far instead of z / near."), kDividedByFar},
    {"perspective-formula", marked("perspective formula"),
     marked("The formula of a perspective view is used in an orthographic one, as if rays came from the eye."),
     kPerspectiveFormula},
    {"no-w-divide", marked("not divided by w"), marked("The result is not divided by w."), kNoWDivide},
    {"w-divided-twice", marked("divided by w twice"), marked("The result is divided by w twice."), kWDividedTwice},
    {"projection-transposed", marked("projection transposed"),
     marked("The projection matrix is transposed: its rows are taken for columns."), kProjectionTransposed},
    {"view-transposed", marked("view transposed"),
     marked("The view matrix is transposed: its rows are taken for columns."), kViewTransposed},
    {"both-transposed", marked("both transposed"),
     marked("Projection and view matrix are transposed: rows are taken for columns."), kBothTransposed},
    {"product-transposed", marked("product transposed"),
     marked("The product of projection and view is transposed: its rows are taken for columns."), kProductTransposed},
    {"inverse-order", marked("inverses in the wrong order"),
     marked("The inverses are in the wrong order: the inverse of P V is inverse(V) inverse(P)."), kInverseOrder},
    {"not-inverted", marked("not inverted"), marked("The matrices are not inverted."), kNotInverted},
    {"view-inverse-as-view", marked("view's inverse taken for view"),
     marked("The camera's own matrix, which is the view's inverse, is passed for the view."), kViewInverseAsView},
    {"view-left-out", marked("view left out"),
     marked("The view matrix is left out: the result is the point in eye space."), kViewLeftOut},
    {"projection-left-out", marked("projection left out"), marked("The projection matrix is left out."),
     kProjectionLeftOut},
    {"overwritten-in-place", marked("overwritten in place"),
     marked("The vector is overwritten while it is still needed: y is computed with the new x."), kOverwrittenInPlace},
    {"model-left-in", marked("model left in"),
     marked("The model matrix is left in: these are the object's own coordinates, not the world's."), kModelLeftIn},
    {"model-left-out", marked("model left out"),
     marked("The model matrix is applied once too often, or left out of the inverse."), kModelLeftOut},
    {"eye-added", marked("eye added"), marked("The eye's position is added to a point that has it already."),
     kEyeAdded},
    {"eye-subtracted", marked("eye subtracted"),
     marked("The eye's position is missing: the point is counted from the eye, along the world's axes."),
     kEyeSubtracted},
    {"eye-z-positive", marked("z of the eye point positive"),
     marked("z of the eye point has the wrong sign: an eye looks down -z."), kEyeZPositive},
    {"eye-xy-mirrored", marked("eye point mirrored"),
     marked("x and y of the eye point are mirrored: the formulas want z as a distance, above 0."), kEyeXyMirrored},
    {"axes-differ", marked("other axes"),
     marked("The axes are exchanged or reversed: the program's world has other axes than the scene's."), kAxesDiffer},
    {"opencv-axes", marked("OpenCV's axes for OpenGL's"),
     marked(
         "The point in front of the camera has OpenCV's axes, x right, y down, z ahead. The matrix expects OpenGL's, "
         "y up, z back; or the reverse."),
     kOpenCvAxes},
    {"camera-axes-differ", marked("other camera axes"),
     marked(
         "The point in front of the camera has other axes than the matrix expects, as those of ROS, Unreal or Unity."),
     kCameraAxesDiffer},
    {"translation-not-inverted", marked("translation not inverted"),
     marked(
         "Only the pose's rotation is inverted: t is taken for the eye, or the eye for t. The eye is -transpose(R) t."),
     kTranslationNotInverted},
    {"quaternion-order", marked("quaternion's order"),
     marked("The quaternion's numbers are in another order: w comes first in one program and last in the other."),
     kQuaternionOrder},
    {"euler-order", marked("order of Euler angles"),
     marked("The rotations about x, y and z are multiplied in another order."), kEulerOrder},
    {"euler-degrees", marked("unit of Euler angles"),
     marked("The camera's Euler angles are in degrees where radians are meant, or the reverse."), kEulerDegrees},
    {"focal-lengths-swapped", marked("fx and fy exchanged"), marked("The focal lengths fx and fy are exchanged."),
     kFocalLengthsSwapped},
    {"centre-swapped", marked("cx and cy exchanged"), marked("The numbers cx and cy of the centre are exchanged."),
     kCentreSwapped},
    {"intrinsics-of-another-size", marked("K of another image size"),
     marked("The matrix K belongs to the image in another size: fx, fy, cx and cy grow with the image."),
     kIntrinsicsOfAnotherSize},
    {"half-pixel-twice", marked("half a pixel too much"),
     marked("Half a pixel is added twice. Or the centre of K is (w - 1) / 2, which counts pixels from their centres."),
     kHalfPixelTwice},
    {"distortion-ignored", marked("distortion ignored"),
     marked("The pixel's distortion is not undone before the ray is computed."), kDistortionIgnored},
    {"distortion-added", marked("distortion applied again"),
     marked("The distortion is applied to the pixel instead of being undone."), kDistortionAdded},
    {"w-of-another-point", marked("w of another point"),
     marked("A ray's two ends are mixed up: one coordinate of an end is divided by the other end's w."),
     kWOfAnotherPoint},
    {"y-is-depth", marked("depth taken for y"),
     marked("The depth is passed for y: the index of the coordinate is wrong."), kYIsDepth},
    {"pixel-in-size-minus-one", marked("size minus 1"),
     marked(
         "The pixel is divided by the width minus 1, as linspace(-1, 1, W) does: -1 and 1 are the edges of the first "
         "and last pixel, not their centres."),
     kPixelInSizeMinusOne},
    {"focal-length-not-in-pixels", marked("focal length not in pixels"),
     marked("An entry of the projection matrix is taken for the focal length in pixels."), kFocalLengthNotInPixels},
    {"fovy-differs", marked("another field of view"), marked("The field of view is not that of the view."),
     kFovyDiffers},
    {"box-size-differs", marked("another box size"),
     marked("The orthographic box is not as large as that of the view."), kBoxSizeDiffers},
    {"pixel-shifted", marked("pixel shifted"),
     marked("The pixel is shifted: it is counted from another corner, as that of the screen or of the window's frame."),
     kPixelShifted},
    {"pixel-scaled-and-moved", marked("pixel scaled and moved"),
     marked("The window is letterboxed, or the view is fitted into a larger surface: its pixels are not the view's."),
     kPixelScaledAndMoved},
    {"viewport-size-differs", marked("another viewport size"), marked("The viewport's size is not that of the view."),
     kViewportSizeDiffers},
    {"ratio-differs", marked("another pixel ratio"),
     marked("The pixel and the viewport are in different pixels: one of them is scaled by a pixel ratio."),
     kRatioLogicalInDevice},
    {"scaled", marked("result scaled"),
     marked("The result is scaled: another unit of length, or depths in another unit than the scene."), kScaled},
    {"depth-scaled", marked("depth scaled"),
     marked("The depth is multiplied by a factor: it was read in another format."), kDepthScaled},
    {"near-far-differ", marked("other near and far planes"),
     marked("The near and the far plane are not those of the view."), kNearFarDiffer},
    {"principal-point-differs", marked("another centre of K"),
     marked("The centre cx, cy of K, which is the principal point, is not that of the view."), kPrincipalPointDiffers},
    {"focal-lengths-differ", marked("other focal lengths"),
     marked("The focal lengths fx, fy of K are not those of the view."), kFocalLengthsDiffer},
    {"frame-differs", marked("another frame"),
     marked("The points are in another frame: it is turned, moved or scaled against the scene's world."),
     kFrameDiffers},
};

/// The start of the names in lines that stand for values: otherFar for `far`.
constexpr std::string_view kOther = "other";

/// @return null if there is no value of this name
const SolvedValue *named(std::span<const SolvedValue> values, std::string_view name)
{
    const auto found =
        std::find_if(values.begin(), values.end(), [name](const SolvedValue &value) { return value.name == name; });
    return found == values.end() ? nullptr : &*found;
}

/// The length of the identifier that starts a line; 0 if none does.
std::size_t nameLength(std::string_view line)
{
    std::size_t length = 0;
    while (length < line.size() && (std::isalnum(static_cast<unsigned char>(line[length])) || line[length] == '_'))
        ++length;
    return length;
}

/// The value in a line. A scale that is not solved is 1, and a translation 0; other names stay.
/// @param name  without "other": Far
std::string textOf(std::string name, std::span<const SolvedValue> values)
{
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    const SolvedValue *value = named(values, name);
    if (!value)
        return name == "scale" ? "1" : name == "translation" ? "0, 0, 0" : name;
    std::string text = value->word;
    for (const double number : value->numbers)
        text += (text.empty() ? "" : ", ") + valueText(number);
    return text;
}

} // namespace

const Remedy &remedyOf(std::string_view id)
{
    const auto *found =
        std::find_if(std::begin(kRemedies), std::end(kRemedies), [&](const Remedy &remedy) { return remedy.id == id; });
    assert(found != std::end(kRemedies));
    return *found;
}

std::span<const CodeChange> codeOf(std::string_view id, std::span<const SolvedValue> values)
{
    if (id == "ratio-differs") {
        if (const SolvedValue *fixedForm = named(values, "as"))
            return remedyOf(fixedForm->word).code;
    }
    if (id == "scaled") {
        if (const SolvedValue *about = named(values, "about"); about && about->word == "eye")
            return kScaledFromEye;
    }
    if (id == "pixel-scaled-and-moved" && named(values, "flipHeight"))
        return kPixelScaledMovedAndFlipped;
    if (id == "viewport-size-differs" && named(values, "x"))
        return kViewportRectangleDiffers;
    if (id == "axes-differ" && (named(values, "scale") || named(values, "translation")))
        return kAxesDifferAndMoved;
    return remedyOf(id).code;
}

std::string lineWithValues(std::string_view line, std::span<const SolvedValue> values)
{
    std::string filled;
    while (!line.empty()) {
        const std::size_t length = nameLength(line);
        const std::string_view name = line.substr(0, length);
        const bool isOther = name.starts_with(kOther) && name.size() > kOther.size()
                             && std::isupper(static_cast<unsigned char>(name[kOther.size()]));
        filled += isOther ? textOf(std::string(name.substr(kOther.size())), values) : std::string(name);
        line.remove_prefix(length);
        if (length == 0) {
            filled += line.front();
            line.remove_prefix(1);
        }
    }
    return filled;
}

} // namespace unprojector::doctor
