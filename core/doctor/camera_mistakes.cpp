#include "core/base/translation.h"
#include "core/doctor/frame_fit.h"
#include "core/doctor/variants.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>

/// The mistakes of programs with a vision camera: a matrix K, distortion, and a pose.
namespace unprojector::doctor {
using base::marked;
namespace {

/// From OpenGL's eye axes to OpenCV's and back.
const glm::dmat3 kOpenCvAxes(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0);

/// The pose that a program reads: the view, or the camera's own placement.
enum class Pose { View, Camera };

bool isRotation(const glm::dmat3 &m)
{
    const glm::dmat3 product = glm::transpose(m) * m;
    for (int i = 0; i < 9; ++i) {
        if (!(std::abs(product[i / 3][i % 3] - (i % 4 == 0 ? 1.0 : 0.0)) < 1e-6))
            return false;
    }
    return glm::determinant(m) > 0.0;
}

/// The pose's rotation, in OpenCV's or OpenGL's eye axes. A pose that is no rotation loses the
/// program.
glm::dmat3 rotationOf(Run &run, Pose pose, bool isOpenCv)
{
    glm::dmat3 rotation(run.eyeFromWorld);
    run.isLost = run.isLost || !isRotation(rotation);
    if (isOpenCv)
        rotation = kOpenCvAxes * rotation;
    return pose == Pose::View ? rotation : glm::transpose(rotation);
}

/// Replaces the pose's rotation. Its translation stays: the view's, or the eye's position.
void setRotation(Run &run, Pose pose, bool isOpenCv, const glm::dmat3 &rotation)
{
    glm::dmat3 view = pose == Pose::View ? rotation : glm::transpose(rotation);
    if (isOpenCv)
        view = kOpenCvAxes * view;
    const glm::dvec3 moved =
        pose == Pose::View ? glm::dvec3(run.eyeFromWorld[3]) : -(view * glm::dvec3(glm::inverse(run.eyeFromWorld)[3]));
    run.eyeFromWorld = glm::dmat4(view);
    run.eyeFromWorld[3] = glm::dvec4(moved, 1.0);
}

// Quaternions

constexpr const char *kQuaternions[] = {
    marked("w x y z read as x y z w, OpenCV's view"),        marked("x y z w read as w x y z, OpenCV's view"),
    marked("w x y z read as x y z w, OpenCV's camera pose"), marked("x y z w read as w x y z, OpenCV's camera pose"),
    marked("w x y z read as x y z w, OpenGL's view"),        marked("x y z w read as w x y z, OpenGL's view"),
    marked("w x y z read as x y z w, OpenGL's camera pose"), marked("x y z w read as w x y z, OpenGL's camera pose"),
};

/// The run's parameter is the index of the name.
void readQuaternion(Run &run)
{
    const int way = int(run.parameter);
    const bool isOpenCv = way < 4, isScalarFirst = way % 2 == 0;
    const Pose pose = way % 4 < 2 ? Pose::View : Pose::Camera;
    const glm::dquat q = glm::quat_cast(rotationOf(run, pose, isOpenCv));
    // Stored w x y z and read as x y z w, or the reverse.
    setRotation(run, pose, isOpenCv,
                glm::mat3_cast(isScalarFirst ? glm::dquat(q.z, q.w, q.x, q.y) : glm::dquat(q.x, q.y, q.z, q.w)));
}

// Euler angles of the camera's placement

/// The axes of a product of three rotations, from the left: 0 is x. The usual orders come first,
/// because several orders give the same camera where it does not roll.
using EulerOrder = std::array<int, 3>;
constexpr std::array<EulerOrder, 6> kOrders{{{2, 1, 0}, {0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {1, 2, 0}, {0, 2, 1}}};

std::string nameOf(const EulerOrder &order)
{
    std::string name;
    for (const int axis : order)
        name += "xyz"[axis];
    return name;
}

/// The angles about x, y and z whose product in this order is the rotation, radians.
glm::dvec3 anglesOf(const glm::dmat3 &rotation, const EulerOrder &order)
{
    const auto [i, j, k] = order;
    const double sign = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
    const auto at = [&rotation](int row, int column) { return rotation[column][row]; };
    glm::dvec3 angles(0.0);
    angles[i] = std::atan2(-sign * at(j, k), at(k, k));
    angles[j] = std::asin(glm::clamp(sign * at(i, k), -1.0, 1.0));
    angles[k] = std::atan2(-sign * at(i, j), at(i, i));
    return angles;
}

glm::dmat3 productOf(const glm::dvec3 &angles, const EulerOrder &order)
{
    glm::dmat3 product(1.0);
    for (const int axis : order) {
        glm::dvec3 direction(0.0);
        direction[axis] = 1.0;
        product = product * glm::mat3_cast(glm::angleAxis(angles[axis], direction));
    }
    return product;
}

/// The run's numbers are the index of the right order and of the program's.
void multiplyInAnotherOrder(Run &run)
{
    const glm::dvec3 angles = anglesOf(rotationOf(run, Pose::Camera, false), kOrders[std::size_t(run.parameter)]);
    setRotation(run, Pose::Camera, false, productOf(angles, kOrders[std::size_t(run.second)]));
}

/// The run's numbers are the index of the order and the factor of the angles.
void scaleAngles(Run &run)
{
    const EulerOrder &order = kOrders[std::size_t(run.parameter)];
    const glm::dvec3 angles = anglesOf(rotationOf(run, Pose::Camera, false), order);
    setRotation(run, Pose::Camera, false, productOf(run.second * angles, order));
}

void addEulerAngles(VariantList &list)
{
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    for (std::size_t right = 0; right < kOrders.size(); ++right) {
        const std::string name = nameOf(kOrders[right]);
        for (std::size_t wrong = 0; wrong < kOrders.size(); ++wrong) {
            if (wrong != right)
                list.add(
                        "euler-order", Stage::Factors, multiplyInAnotherOrder,
                        {marked("angles for the order %1, multiplied in the order %2"), {name, nameOf(kOrders[wrong])}},
                        double(right), double(wrong))
                    .isAlone = true;
        }
        for (const auto &[factor, words] : {std::pair(kDegrees, marked("degrees taken for radians, order %1")),
                                            std::pair(1.0 / kDegrees, marked("radians taken for degrees, order %1"))})
            list.add("euler-degrees", Stage::Factors, scaleAngles, {words, {name}}, double(right), factor).isAlone =
                true;
    }
}

// The matrix K

/// The centre of K, device pixels from the top-left corner.
glm::dvec2 centreOf(const Run &run)
{
    const glm::dmat4 &m = run.clipFromEye;
    const geometry::Viewport &v = run.viewport;
    const glm::dvec2 ndc = glm::dvec2(m[2]) / m[2][3];
    return {v.x + (ndc.x + 1.0) / 2.0 * v.width, run.given.surface.heightPixels - v.y - (ndc.y + 1.0) / 2.0 * v.height};
}

void exchangeCentres(Run &run)
{
    glm::dmat4 &m = run.clipFromEye;
    const geometry::Viewport &v = run.viewport;
    const glm::dvec2 centre = centreOf(run), ofImage(v.x, run.given.surface.heightPixels - v.y - v.height);
    const glm::dvec2 swapped(centre.y - ofImage.y, centre.x - ofImage.x); // K counts from the image's corner
    m[2][0] = (2.0 * swapped.x / v.width - 1.0) * m[2][3];
    m[2][1] = (1.0 - 2.0 * swapped.y / v.height) * m[2][3];
}

/// Scales the position about the viewport's top-left corner.
void scalePosition(Run &run, double x, double y)
{
    const geometry::Viewport &v = run.viewport;
    const glm::dvec2 corner(v.x, run.given.surface.heightPixels - v.y - v.height);
    run.position = corner + (run.position - corner) * glm::dvec2(x, y);
}

void addIntrinsics(VariantList &list, const Case &scene)
{
    list.add("focal-lengths-swapped", Stage::Lens, [](Run &run) {
        glm::dmat4 &m = run.clipFromEye;
        const double aspect = run.viewport.width / run.viewport.height, x = m[0][0];
        m[0][0] = m[1][1] / aspect;
        m[1][1] = x * aspect;
    });
    list.add("centre-swapped", Stage::Lens, exchangeCentres);
    const auto scale = [](Run &run) { scalePosition(run, run.parameter, run.parameter); };
    list.add("intrinsics-of-another-size", Stage::Pixel, scale, marked("half the size"), 2.0);
    list.add("intrinsics-of-another-size", Stage::Pixel, scale, marked("twice the size"), 0.5);
    if (const auto &other = scene.otherSize)
        list.add(
            "intrinsics-of-another-size", Stage::Pixel,
            [](Run &run) { scalePosition(run, run.viewport.width / run.parameter, run.viewport.height / run.second); },
            marked("the size given"), other->widthPixels, other->heightPixels);
}

// Distortion

void addDistortion(VariantList &list, const Given &given)
{
    if (given.distortion.isNone() || !given.isPerspective)
        return;
    list.add("distortion-ignored", Stage::Pixel, [](Run &run) { run.position += run.click.distortedBy; });
    list.add("distortion-added", Stage::Pixel,
             [](Run &run) { run.position = distorted(run.given, run.position + run.click.distortedBy); });
}

// Poses

/// The axes of other cameras' points: of ROS, Unreal, Unity. Those that have a name of their own
/// are other mistakes.
void addCameraAxes(VariantList &list)
{
    for (const AxisPermutation &permutation : axisPermutations().subspan(1)) {
        const std::string &axes = permutation.axes;
        if (axes == "x,-y,-z" || axes == "x,y,-z" || axes == "-x,-y,z")
            continue;
        list.add("camera-axes-differ",
                 Variant{.stage = Stage::Eye,
                         .apply = [](Run &run) { run.eye = glm::dmat3(*run.matrix) * run.eye; },
                         .matrix = glm::dmat4(permutation.matrix),
                         .name = {nullptr, {axes}, marked("Your program's camera has the axes %1.")},
                         .values = {{"axes", {}, axes}},
                         .isAlone = true});
    }
}

/// Inverts a matrix's rotation and keeps its translation.
glm::dmat4 rotationInverted(const glm::dmat4 &m)
{
    glm::dmat4 result(glm::inverse(glm::dmat3(m)));
    result[3] = m[3];
    return result;
}

void addPoses(VariantList &list)
{
    list.add("opencv-axes", Stage::Eye, [](Run &run) {
        run.eye.y = -run.eye.y;
        run.eye.z = -run.eye.z;
    });
    list.add(
        "translation-not-inverted", Stage::Factors,
        [](Run &run) { run.eyeFromWorld = glm::inverse(rotationInverted(run.eyeFromWorld)); },
        marked("the view's translation is taken for the eye"));
    list.add(
        "translation-not-inverted", Stage::Factors,
        [](Run &run) { run.eyeFromWorld = rotationInverted(glm::inverse(run.eyeFromWorld)); },
        marked("the eye is taken for the view's translation"));
    list.add(
        "view-transposed", Stage::Factors, [](Run &run) { run.eyeFromWorld = rotationInverted(run.eyeFromWorld); },
        marked("its rotation only"));
    list.add(
        "view-transposed", Stage::Factors,
        [](Run &run) { run.eyeFromWorld = glm::inverse(rotationInverted(glm::inverse(run.eyeFromWorld))); },
        marked("its rotation only, about the eye"));
}

} // namespace

void addCameraMistakes(VariantList &list, const Given &given, const Case &scene)
{
    addPoses(list);
    addCameraAxes(list);
    for (int way = 0; way < int(std::size(kQuaternions)); ++way)
        list.add("quaternion-order", Stage::Factors, readQuaternion, kQuaternions[way], way).isAlone = true;
    addEulerAngles(list);
    addDistortion(list, given);
    if (given.isPerspective)
        addIntrinsics(list, scene);
}

} // namespace unprojector::doctor
