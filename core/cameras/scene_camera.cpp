#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/foreign_camera.h"
#include "core/cameras/reader_parts.h"
#include "core/cameras/seen_objects.h"
#include "core/geometry/finite.h"
#include "core/pipeline/printed_digits.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::cameras {
using namespace geometry;
using base::shortestText;
using base::significantText;
using base::tr;
using enum EyeAxes;
using enum PoseDirection;
namespace {

constexpr int kMostPixels = 65536;  // as for windows
constexpr double kMostLength = 1e9; // of a focal length, in pixels, and of 1 / it
constexpr double kUsualNear = 0.1, kUsualFar = 1000.0;

/// Thrown through sceneCamera, which returns it.
[[noreturn]] void fail(std::string reason)
{
    throw base::Error{std::move(reason)};
}

/// The inverse of a transform whose last row is 0 0 0 1.
glm::dmat4 affineInverse(const glm::dmat4 &m)
{
    const glm::dmat3 turn = glm::inverse(glm::dmat3(m));
    glm::dmat4 inverse(turn);
    inverse[3] = glm::dvec4(-(turn * glm::dvec3(m[3])), 1.0);
    return inverse;
}

/// The largest |entry| of R R^T - s^2, relative to s^2, with s the mean length of an axis.
double skewnessOf(const glm::dmat3 &axes, double scale)
{
    return pipeline::largestDifference(axes * glm::transpose(axes) / (scale * scale), glm::dmat3(1.0));
}

/// The pose with axes of length 1, perpendicular to each other.
/// @param assumed  gets a sentence for each change
glm::dmat4 rigidPose(const glm::dmat4 &pose, PoseDirection direction, std::vector<std::string> &assumed)
{
    constexpr double kExact = 1e-9;   // what double precision leaves
    constexpr double kPrinted = 0.02; // two printed decimals
    if (!isFinite(pose))
        fail(tr("the pose has a number that is not finite; give the pose's twelve numbers"));
    if (glm::length(glm::dvec3(pose[0][3], pose[1][3], pose[2][3])) > 1e-9 || std::abs(pose[3][3] - 1.0) > 1e-9)
        fail(tr("the pose's last row is not 0 0 0 1; give the matrix by rows"));
    const glm::dmat3 axes(pose);
    const double scale = std::cbrt(std::abs(glm::determinant(axes)));
    if (!(scale > 0.0))
        fail(tr("the pose's axes lie in one plane; give a rotation"));
    const double skewness = skewnessOf(axes, scale);
    if (skewness > kPrinted)
        fail(tr("the pose's axes are not perpendicular and of equal length: off by %1; give a rotation",
                significantText(skewness, 2)));
    glm::dmat4 rigid = pose;
    const bool isScaled = std::abs(scale - 1.0) > std::max(kExact, 2.0 * skewness);
    if (isScaled) {
        // World-to-camera, the scale turns world units into camera units, and t is in camera units.
        for (int column = 0; column < 3; ++column)
            rigid[column] /= scale;
        if (direction == WorldToCamera)
            rigid[3] = glm::dvec4(glm::dvec3(pose[3]) / scale, 1.0);
        assumed.push_back(
            tr("The pose scales by %1; the camera has no scale, so it is removed.", significantText(scale, 6)));
    }
    if (skewness > kExact) {
        rigid = pipeline::orthonormal(rigid);
        if (skewness > 1e-5)
            assumed.push_back(tr("The pose's axes are perpendicular only up to %1, as few printed digits make them; "
                                 "the nearest rotation is used.",
                                 significantText(skewness, 2)));
    }
    return rigid;
}

Pinhole pinhole(const Intrinsics &k, const ImageSize &size, double n, double f)
{
    return {k.fx,
            k.fy,
            k.cx,
            k.cy,
            k.skew,
            double(size.width),
            double(size.height),
            n,
            f,
            k.centres == PixelCentres::AtIntegers};
}

/// The matrix with which objects are looked for in the image; depths do not count there.
glm::dmat4 clipFromEye(const ForeignCamera &camera, const SceneCamera &scene)
{
    if (camera.projection)
        return wInFront(*camera.projection) * camera.projection->clipFromEye;
    const Result<glm::dmat4> matrix = geometry::clipFromEye(pinhole(*scene.intrinsics, scene.size, 0.5, 1.0));
    return matrix ? *matrix : glm::dmat4(1.0);
}

double withTwoDigits(double value)
{
    return base::doubleFromWord(significantText(value, 2)).value_or(value);
}

/// The image's side whose centre is a coordinate of the principal point. Most sides are even, so a
/// whole coordinate is half of one, for pixel centres at whole numbers too.
double twice(double centre, double toCorner)
{
    constexpr double kRounding = 1e-6; // of a K that is computed
    return std::round(std::abs(centre - std::round(centre)) < kRounding ? 2.0 * centre : 2.0 * (centre + toCorner));
}

/// The image's size: the choice, the file's, or twice the principal point.
ImageSize imageSize(const ForeignCamera &camera, const CameraChoices &choices, std::vector<std::string> &assumed)
{
    std::optional<ImageSize> size = choices.size ? choices.size : camera.size;
    if (choices.size && camera.size && *choices.size != *camera.size)
        assumed.push_back(
            tr("The image is %1, as --size says; the file says %2.", sizeText(*choices.size), sizeText(*camera.size)));
    if (!size) {
        if (!camera.intrinsics)
            fail(noSizeText());
        const Intrinsics &k = *camera.intrinsics;
        const double toCorner = cornerToCentre(choices.centres.value_or(k.centres));
        const double width = twice(k.cx, toCorner), height = twice(k.cy, toCorner);
        constexpr double kMostAspect = 5.0; // of sides that are guessed
        if (!(width >= 1.0 && height >= 1.0 && width <= kMostPixels && height <= kMostPixels)
            || width > kMostAspect * height || height > kMostAspect * width)
            fail(tr("the principal point (%1, %2) gives no size of the image; give it with --size 800x600",
                    shortestText(k.cx), shortestText(k.cy)));
        size = ImageSize{static_cast<int>(width), static_cast<int>(height)};
        assumed.push_back(
            tr("The image is assumed to be %1, twice the principal point; --size says otherwise.", sizeText(*size)));
    }
    if (size->width < 1 || size->height < 1 || size->width > kMostPixels || size->height > kMostPixels)
        fail(tr("an image of %1 pixels cannot be; each side must be 1 to %2", sizeText(*size), kMostPixels));
    return *size;
}

/// Near and far: the choices, the file's, or around the objects.
std::pair<double, double> clipDistances(const ForeignCamera &camera, const CameraChoices &choices,
                                        const std::optional<Box> &objects, const glm::dmat4 &eyeFromWorld,
                                        std::vector<std::string> &assumed)
{
    const std::optional<double> givenNear = choices.nearDistance ? choices.nearDistance : camera.nearDistance,
                                givenFar = choices.farDistance ? choices.farDistance : camera.farDistance;
    const DepthExtent extent = objects && !objects->isEmpty() ? depthExtent(eyeFromWorld, *objects) : DepthExtent();
    const bool isSeen = extent.farthest > 0.0;
    double n = givenNear.value_or(0.0), f = givenFar.value_or(0.0);
    if (!givenFar) {
        f = isSeen ? 2.0 * extent.farthest : std::max(kUsualFar, 1e4 * n);
        if (givenNear && !(f > n))
            f = 1e4 * n;
    }
    if (!givenNear) {
        n = isSeen ? std::max(extent.nearest / 2.0, extent.farthest / 1e4) : kUsualNear;
        if (!(n < f))
            n = f / 1e4;
    }
    // Assumed distances have two digits.
    if (!givenFar)
        f = withTwoDigits(f);
    if (!givenNear)
        n = withTwoDigits(n);
    if (!(std::isfinite(n) && std::isfinite(f) && n > 0.0 && f > n))
        fail(tr("near is %1 and far is %2; near must be greater than 0 and smaller than far. Give --near and "
                "--far",
                shortestText(n), shortestText(f)));
    if (!givenNear && !givenFar)
        assumed.push_back(tr("Near %1 and far %2 are assumed, because the file has none; --near and --far say "
                             "otherwise.",
                             shortestText(n), shortestText(f)));
    else if (!givenNear)
        assumed.push_back(tr("Near %1 is assumed, because the file has none; --near says otherwise.", shortestText(n)));
    else if (!givenFar)
        assumed.push_back(tr("Far %1 is assumed, because the file has none; --far says otherwise.", shortestText(f)));
    return std::pair(n, f);
}

/// A reading of a pose.
struct PoseReading {
    PoseDirection direction;
    EyeAxes axes;
    double seen = 0.0; ///< the part of the objects in the image
};

/// All readings that neither the file nor the choices exclude; the program's usual one first.
std::vector<PoseReading> possibleReadings(const ForeignCamera &camera, const CameraChoices &choices)
{
    std::vector<PoseDirection> directions{choices.direction.value_or(camera.direction)};
    if (!choices.direction && !camera.isDirectionCertain)
        directions.push_back(camera.direction == WorldToCamera ? CameraToWorld : WorldToCamera);
    std::vector<EyeAxes> axes{choices.axes.value_or(camera.axes)};
    if (!choices.axes && !camera.areAxesCertain) {
        for (const EyeAxes other : {RightDownAhead, RightUpBack}) {
            if (other != camera.axes)
                axes.push_back(other);
        }
    }
    std::vector<PoseReading> readings;
    for (const PoseDirection direction : directions) {
        for (const EyeAxes ofEye : axes)
            readings.push_back({direction, ofEye});
    }
    return readings;
}

glm::dmat4 eyeFromWorldOf(const ForeignCamera &camera, const glm::dmat4 &pose, const PoseReading &reading)
{
    const bool isToCamera = reading.direction == WorldToCamera;
    glm::dmat4 given = pose;
    if (camera.center)
        given[3] = glm::dvec4(isToCamera ? -(glm::dmat3(pose) * *camera.center) : *camera.center, 1.0);
    const glm::dmat4 cameraFromWorld = isToCamera ? given : affineInverse(given);
    return glm::dmat4(eyeFromCamera(reading.axes)) * cameraFromWorld * affineInverse(camera.rightHandedFromWorld);
}

/// Where a camera stands and where it looks, for a sentence.
std::pair<std::string, std::string> standing(const glm::dmat4 &eyeFromWorld)
{
    const auto text = [](const glm::dvec3 &v) {
        return '(' + significantText(v.x + 0.0, 4) + ", " + significantText(v.y + 0.0, 4) + ", "
               + significantText(v.z + 0.0, 4) + ')';
    };
    const glm::dmat4 worldFromEye = affineInverse(eyeFromWorld);
    return {text(glm::dvec3(worldFromEye[3])), text(-glm::dvec3(worldFromEye[2]))};
}

/// Fails for a pose whose direction neither its name nor the objects tell, with both readings.
void refuseOpen(const ForeignCamera &camera, const glm::dmat4 &pose, EyeAxes axes)
{
    const auto [eye, ahead] = standing(eyeFromWorldOf(camera, pose, {CameraToWorld, axes}));
    const auto [otherEye, otherAhead] = standing(eyeFromWorldOf(camera, pose, {WorldToCamera, axes}));
    throw base::Error{tr("nothing tells its direction. From the camera to the world, the eye is at %1 and "
                         "looks along %2; from the world to the camera, it is at %3 and looks along %4. Choose with "
                         "--pose camera-to-world or --pose world-to-camera",
                         eye, ahead, otherEye, otherAhead),
                      "pose"};
}

/// Says by which reading the pose was read, and why.
void sayReading(const ForeignCamera &camera, const std::vector<PoseReading> &readings, const PoseReading &taken,
                bool haveObjects, std::vector<std::string> &assumed)
{
    const bool isAnother = taken.direction != readings.front().direction || taken.axes != readings.front().axes;
    const auto isOpen = [&](auto part) {
        return std::ranges::any_of(readings, [&](const PoseReading &r) { return r.*part != taken.*part; });
    };
    const bool isDirectionOpen = isOpen(&PoseReading::direction), areAxesOpen = isOpen(&PoseReading::axes);
    const auto others = std::ranges::count_if(readings, [&](const PoseReading &r) { return r.seen > 0.0; })
                        - (taken.seen > 0.0 ? 1 : 0);
    const auto because = [&](const std::string &usual) {
        return !haveObjects        ? tr("%1. No objects decide it", usual)
               : taken.seen == 0.0 ? tr("%1. No reading shows the objects", usual)
               : others > 0        ? tr("which shows the objects best. Another reading shows them too")
               : isAnother         ? tr("because only this reading shows the objects")
                                   : tr("%1; the objects are in the image", usual);
    };
    const std::string usual = tr("as %1 usually writes it", camera.program);
    if (isDirectionOpen)
        assumed.push_back(
            tr("The pose is read as %1, %2; --pose says otherwise.", keyOf(taken.direction),
               because(camera.poseName.empty() ? usual : tr("as %1 usually means", base::quoted(camera.poseName)))));
    if (areAxesOpen)
        assumed.push_back(tr("The camera's axes are read as those of %1, %2; --axes says otherwise.", keyOf(taken.axes),
                             because(usual)));
}

/// What to do about a camera that sees none of the objects: the first of the usual mistakes without
/// which it sees them.
/// @param scene  as read
std::string remedyOf(const ForeignCamera &camera, const SceneCamera &scene, const Box &objects)
{
    const PoseReading reading{scene.direction, scene.axes};
    const glm::dmat4 pose = camera.pose.value_or(glm::dmat4(1.0));
    const glm::dmat3 turn(pose);
    const glm::dvec3 shift(pose[3]);
    const glm::dmat4 clip = clipFromEye(camera, scene);
    const auto shows = [&](const glm::dmat4 &other, const PoseReading &by) {
        return seenPart(clip, eyeFromWorldOf(camera, other, by), objects) > 0.0;
    };
    for (const EyeAxes axes : {scene.axes, RightDownAhead, RightUpBack}) {
        for (const PoseDirection direction : {WorldToCamera, CameraToWorld}) {
            if (shows(pose, {direction, axes}))
                return tr("with --pose %1 --axes %2 it would", keyOf(direction), keyOf(axes));
        }
    }
    if (shows(rigid(glm::transpose(turn), shift), reading))
        return tr("with its rotation transposed it would; check the order of the rotation's numbers");
    if (scene.direction == WorldToCamera && shows(rigid(turn, -(turn * shift)), reading))
        return tr("with t as the camera's position C it would; give t = -R C");
    for (const double factor : {1e3, 1e-3, 1e2, 1e-2}) {
        ForeignCamera scaled = camera;
        if (scaled.center)
            *scaled.center *= factor;
        if (seenPart(clip, eyeFromWorldOf(scaled, rigid(turn, factor * shift), reading), objects) > 0.0)
            return tr("with a translation %1 times as long it would; check the units", shortestText(factor));
    }
    return tr("check the pose and its units");
}

} // namespace

glm::dmat3 eyeFromCamera(EyeAxes axes)
{
    switch (axes) {
    case RightUpBack: break;
    case RightDownAhead: return glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, -1);
    case RightUpAhead: return glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, -1);
    case AheadRightUp: return glm::dmat3(0, 0, -1, 1, 0, 0, 0, 1, 0);
    case AheadLeftUp: return glm::dmat3(0, 0, -1, -1, 0, 0, 0, 1, 0);
    }
    return glm::dmat3(1.0);
}

const char *keyOf(EyeAxes axes)
{
    switch (axes) {
    case RightUpBack: return "opengl";
    case RightDownAhead: return "opencv";
    case RightUpAhead: return "direct3d";
    case AheadRightUp: return "unreal";
    case AheadLeftUp: return "ros";
    }
    return "";
}

const char *keyOf(PoseDirection direction)
{
    return direction == WorldToCamera ? "world-to-camera" : "camera-to-world";
}

const char *keyOf(PixelCentres centres)
{
    return centres == PixelCentres::AtIntegers ? "integer" : "half";
}

bool hasCentres(const ForeignCamera &camera)
{
    return camera.intrinsics && !camera.intrinsics->isCentreComputed;
}

namespace {

SceneCamera converted(const ForeignCamera &camera, const CameraChoices &choices, const std::optional<Box> &objects)
{
    SceneCamera scene;
    scene.assumed = camera.assumed;
    const auto say = [&scene](std::string sentence) { scene.assumed.push_back(std::move(sentence)); };
    if (!camera.intrinsics && !camera.projection)
        fail(tr("the camera has no projection: give its focal length, field of view, K or matrix"));
    scene.size = imageSize(camera, choices, scene.assumed);
    scene.intrinsics = camera.intrinsics;
    if (choices.centres && hasCentres(camera))
        scene.intrinsics->centres = *choices.centres;
    else if (choices.centres)
        say(tr("The file has no pixel coordinates, so --pixel-centers is ignored."));

    if (!camera.pose)
        say(tr("No pose was read: the camera stands in the world's origin and looks along its "
               "own axis."));
    const std::vector<PoseReading> all = possibleReadings(camera, choices);
    std::vector<PoseReading> readings = camera.pose ? all : std::vector<PoseReading>{all.front()};
    const bool haveObjects = objects && !objects->isEmpty();
    std::optional<PoseReading> taken;
    std::vector<std::string> said;
    for (PoseReading &reading : readings) {
        std::vector<std::string> changes;
        const glm::dmat4 pose = rigidPose(camera.pose.value_or(glm::dmat4(1.0)), reading.direction, changes);
        const glm::dmat4 eyeFromWorld = eyeFromWorldOf(camera, pose, reading);
        if (haveObjects)
            reading.seen = seenPart(clipFromEye(camera, scene), eyeFromWorld, *objects);
        if (!taken || reading.seen > taken->seen) {
            taken = reading;
            scene.eyeFromWorld = eyeFromWorld;
            said = changes;
        }
    }
    const auto isSeen = [&](PoseDirection direction) {
        return std::ranges::any_of(
            readings, [&](const PoseReading &reading) { return reading.direction == direction && reading.seen > 0.0; });
    };
    if (camera.pose && camera.isDirectionOpen && !choices.direction && isSeen(CameraToWorld) == isSeen(WorldToCamera))
        refuseOpen(camera, *camera.pose, readings.front().axes);
    scene.direction = taken->direction;
    scene.axes = taken->axes;
    if (camera.pose) {
        scene.assumed.insert(scene.assumed.end(), said.begin(), said.end());
        sayReading(camera, readings, *taken, haveObjects, scene.assumed);
    }
    if (glm::determinant(glm::dmat3(scene.eyeFromWorld)) < 0.0)
        say(tr("The pose mirrors the image: its axes are left-handed in a right-handed world. "
               "Check a row's or column's sign."));
    if (haveObjects && taken->seen == 0.0)
        say(tr("The camera sees none of the objects: %1.", remedyOf(camera, scene, *objects)));
    if (haveObjects && taken->seen > 0.0) {
        constexpr double kTiny = 0.02;
        if (const double share = imageShare(clipFromEye(camera, scene), scene.eyeFromWorld, *objects);
            share > 0.0 && share < kTiny)
            say(tr("The objects take only %1 % of the image: check the units of t.",
                   significantText(100.0 * share, 2)));
    }

    if (camera.projection) {
        scene.projection = *camera.projection;
        if (choices.nearDistance || choices.farDistance)
            say(tr("The file's projection matrix has near and far; --near and --far are ignored."));
    } else {
        const auto [n, f] = clipDistances(camera, choices, objects, scene.eyeFromWorld, scene.assumed);
        scene.nearDistance = n;
        scene.farDistance = f;
        const Intrinsics &k = *scene.intrinsics;
        if (!isFinite({k.fx, k.fy, k.cx, k.cy, k.skew}) || k.fx == 0.0 || k.fy == 0.0)
            fail(tr("the focal lengths are %1 and %2; they must be finite and not 0", shortestText(k.fx),
                    shortestText(k.fy)));
        for (const double pixels : {k.fx, k.fy, k.cx, k.cy, k.skew}) {
            if (std::abs(pixels) > kMostLength)
                fail(tr("%1 pixels cannot be of a camera; check fx, fy, cx, cy and the skew", shortestText(pixels)));
        }
        if (std::min(std::abs(k.fx), std::abs(k.fy)) < 1.0 / kMostLength)
            fail(tr("the focal lengths are %1 and %2 pixels; check them", shortestText(k.fx), shortestText(k.fy)));
        scene.projection = pinhole(k, scene.size, n, f);
        if (!(k.cx >= 0.0 && k.cx <= scene.size.width && k.cy >= 0.0 && k.cy <= scene.size.height))
            say(tr("The principal point (%1, %2) lies outside the image of %3: check the size.", shortestText(k.cx),
                   shortestText(k.cy), sizeText(scene.size)));
        if (k.centres == PixelCentres::AtIntegers && !choices.centres && k.cx == scene.size.width / 2.0
            && k.cy == scene.size.height / 2.0)
            say(tr("Pixel centres are at whole numbers, as in %1. The principal point is half the "
                   "size, so they may be at halves; --pixel-centers half says so.",
                   camera.program));
    }
    if (camera.distortion && !camera.distortion->isNone()) {
        if (choices.isUndistorted)
            say(tr("The distortion coefficients are dropped: pixels are those of the undistorted "
                   "image."));
        else
            scene.distortion = camera.distortion;
    }
    return scene;
}

} // namespace

base::Expected<SceneCamera, base::Error> sceneCamera(const ForeignCamera &camera, const CameraChoices &choices,
                                                     const std::optional<Box> &objects)
{
    try {
        return converted(camera, choices, objects);
    } catch (base::Error &error) {
        return std::move(error);
    }
}

} // namespace unprojector::cameras
