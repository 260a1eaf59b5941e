#include "core/doctor/prepared_point.h"

#include "core/geometry/precise_matrix.h"
#include "core/unproject/exact_unprojection.h"
#include "core/unproject/object_from_world.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace unprojector::doctor {
using namespace geometry;
namespace {

/// The step of a depth buffer. Depths on a mesh are computed from its triangles, without the
/// buffer's rounding, but a wrong program reads them from one.
constexpr double kDepthBufferStep = 1.0 / 16777215.0;

std::optional<double> depthOf(const Case &scene, const std::optional<WorldPoint> &onMesh)
{
    if (!onMesh)
        return std::nullopt;
    const Result<WindowPoint> window = windowFromWorld(scene.setup, *onMesh);
    return window ? std::optional(window->z) : std::nullopt;
}

Click clickOf(const Case &scene, const Given &given, const WrongPoint &point, double depth)
{
    Click click;
    click.depth = depth;
    click.space = point.space;
    if (point.space == PointSpace::Object && point.model < scene.models.size())
        click.worldFromObject = scene.models[point.model].worldFromObject.rounded();
    setPixel(given, click, point.pixel);
    click.depthAbove = depthOnMesh(scene, DevicePoint(click.pixel.x, click.pixel.y - 1.0));
    click.depthBelow = depthOnMesh(scene, DevicePoint(click.pixel.x, click.pixel.y + 1.0));
    return click;
}

/// The ends of the right answers on a ray of unknown depth. They lie inside the clip planes: points
/// exactly on the planes come from programs that did not read the depth; a surface is rarely there.
std::vector<Click> betweenPlanes(const Case &scene, const Given &given, const WrongPoint &point)
{
    constexpr double kFromPlane = 4.0; // last digits
    Click first = clickOf(scene, given, point, given.depthRange.atNear);
    Click last = clickOf(scene, given, point, given.depthRange.atFar);
    const auto a = answer(given, first, {}), b = answer(given, last, {});
    const double digits = a && b ? glm::length((*b - *a) / point.lastDigit) : 0.0;
    if (digits > 2.0 * kFromPlane) {
        const glm::dvec3 step = (*b - *a) * (kFromPlane / digits);
        if (const auto there = projected(given, first, *a + step))
            first = clickOf(scene, given, point, there->z);
        if (const auto there = projected(given, last, *b - step))
            last = clickOf(scene, given, point, there->z);
    }
    return {first, last};
}

/// The rounding error of an answer at a given precision: some roundings of the numbers that
/// contribute to it. It includes the depth's, which moves the answer along the ray.
/// @param epsilon  difference between 1 and the next number
glm::dvec3 roundingOf(const Given &given, const Click &click, double epsilon)
{
    constexpr double kRoundings = 32.0, kStep = 1e-6;
    const auto right = answer(given, click, {});
    if (!right)
        return glm::dvec3(0.0);
    const auto [low, high] = std::minmax(given.depthRange.atNear, given.depthRange.atFar);
    Click moved = click;
    moved.depth += (high - low) * (click.depth > (low + high) / 2.0 ? -kStep : kStep);
    const auto there = answer(given, moved, {});
    const glm::dvec3 byDepth = there ? glm::abs(*there - *right) / kStep : glm::dvec3(0.0);
    const double size = glm::length(given.eyePosition) + glm::length(click.eye) + glm::length(*right);
    // A larger tolerance would let anything explain the point.
    const double most = 1e-4 * glm::length(click.eye);
    return glm::min(kRoundings * epsilon * (byDepth + size), glm::dvec3(most));
}

/// The units of the last significant digits.
glm::dvec3 countedDigit(const Given &given, const Click &click, const WrongPoint &point, double epsilon)
{
    // The coordinates themselves are rounded too: 4500000 has a step of 0.5 in single precision.
    const glm::dvec3 step = epsilon * glm::abs(point.got);
    const glm::dvec3 counted = glm::max(glm::max(point.lastDigit, step), roundingOf(given, click, epsilon));
    const double distance = glm::length(click.eye);
    return distance > 0.0 ? glm::min(counted, glm::dvec3(distance)) : counted;
}

/// A point of a mesh in eye space. Only the result is rounded.
std::optional<glm::dvec3> eyeOf(const Setup &setup, const WorldPoint &world)
{
    if (const auto *view = std::get_if<glm::dmat4>(&setup.pose)) {
        const DoubleDouble3 eye = PreciseMatrix(*view).at(world.coordinates());
        const DoubleDouble w =
            (*view)[0][3] * world.x + (*view)[1][3] * world.y + (*view)[2][3] * world.z + (*view)[3][3];
        return glm::dvec3((eye[0] / w).value, (eye[1] / w).value, (eye[2] / w).value);
    }
    const Result<PreciseEyeFrame> frame = preciseEyeFrame(std::get<LookAt>(setup.pose));
    if (!frame)
        return std::nullopt;
    const DoubleDouble3 offset{DoubleDouble(world.x) - frame->eye.x, DoubleDouble(world.y) - frame->eye.y,
                               DoubleDouble(world.z) - frame->eye.z};
    return glm::dvec3(dot(frame->side, offset).value, dot(frame->upward, offset).value,
                      -dot(frame->forward, offset).value);
}

/// A point of a mesh in an object's space.
std::optional<glm::dvec3> objectOf(const PreciseMatrix &worldFromObject, const WorldPoint &world)
{
    const Result<ObjectPoint> point = unproject::objectFromWorld(worldFromObject, world);
    return point ? std::optional(point->coordinates()) : std::nullopt;
}

} // namespace

std::optional<glm::dvec3> unsureOf(const Given &given, const Prepared &point)
{
    glm::dvec3 sum(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 moved = point.target.got;
        moved[axis] += kCutOff * point.target.lastDigit[axis];
        const auto there = projected(given, point.click, moved);
        if (!there)
            return std::nullopt;
        sum += glm::abs(*there - *point.projected);
    }
    return sum;
}

Check checkPoint(const Case &scene, const WrongPoint &point)
{
    for (const double number : {point.pixel.x, point.pixel.y, point.got.x, point.got.y, point.got.z}) {
        if (!std::isfinite(number))
            return Error{ErrorCode::NotFinite, number};
    }
    const auto [low, high] = std::minmax(scene.setup.depthRange.atNear, scene.setup.depthRange.atFar);
    if (point.depth && !(*point.depth >= low && *point.depth <= high))
        return Error{ErrorCode::DepthOutsideRange, *point.depth};
    return std::monostate{};
}

Prepared prepared(const Case &scene, const Given &given, const WrongPoint &point, double epsilon)
{
    Prepared result;
    const auto [low, high] = std::minmax(given.depthRange.atNear, given.depthRange.atFar);
    std::optional<double> depth = point.depth;
    double step = point.depthLastDigit;
    if (!depth && scene.pointOnMesh) {
        result.onMesh = scene.pointOnMesh(clickOf(scene, given, point, low).pixel);
        depth = depthOf(scene, result.onMesh);
        step = kDepthBufferStep;
        result.depthKnown = DepthKnown::FromMesh;
    }
    result.target.got = point.got;
    result.target.lastDigit = point.lastDigit;
    result.target.writtenDigit = point.lastDigit;
    std::vector<double> depths;
    if (depth && step > 0.0) {
        depths = {std::max(low, *depth - step / 2.0), std::min(high, *depth + step / 2.0)};
    } else if (depth) {
        depths = {*depth};
    } else {
        result.depthKnown = DepthKnown::ByRay;
        result.target.isLine = true;
        // Two depths: the point's, and one far enough from it to define a line.
        Click anywhere = clickOf(scene, given, point, low);
        const auto there = projected(given, anywhere, point.got);
        const double at = there ? std::clamp(there->z, low, high) : (low + high) / 2.0;
        depth = at;
        depths = {at, at > (low + high) / 2.0 ? (low + at) / 2.0 : (at + high) / 2.0};
    }
    for (const double each : depths)
        result.target.clicks.push_back(clickOf(scene, given, point, each));
    result.click = clickOf(scene, given, point, *depth);
    result.target.lastDigit = countedDigit(given, result.click, point, epsilon);
    result.right = result.target;
    if (result.target.isLine) {
        result.right.isLine = false;
        result.right.clicks = betweenPlanes(scene, given, point);
    }
    result.projected = projected(given, result.click, point.got);
    return result;
}

std::optional<double> depthOnMesh(const Case &scene, const DevicePoint &position)
{
    return scene.pointOnMesh ? depthOf(scene, scene.pointOnMesh(position)) : std::nullopt;
}

std::optional<glm::dvec3> rightPoint(const Case &scene, const WrongPoint &point, const Prepared &prepared)
{
    if (prepared.depthKnown == DepthKnown::ByRay)
        return std::nullopt;
    const bool isOfObject = point.space == PointSpace::Object && point.model < scene.models.size();
    const PreciseMatrix worldFromObject = isOfObject ? scene.models[point.model].worldFromObject : PreciseMatrix();
    if (prepared.onMesh)
        return point.space == PointSpace::Eye ? eyeOf(scene.setup, *prepared.onMesh)
                                              : objectOf(worldFromObject, *prepared.onMesh);
    const auto exact = point.space == PointSpace::Eye
                           ? unproject::ExactUnprojection::toEye(scene.setup)
                           : unproject::ExactUnprojection::toObject(scene.setup, worldFromObject);
    const auto right = exact ? exact->at(prepared.click.pixel, prepared.click.depth) : std::nullopt;
    if (!right)
        return std::nullopt;
    return glm::dvec3(double((*right)[0]), double((*right)[1]), double((*right)[2]));
}

double rightLastDigit(const Given &given, const Prepared &point, const glm::dvec3 &right,
                      const glm::dvec3 &lastDigitGiven)
{
    constexpr double kSevenDigits = 1e-6;
    double unsure = greatestOf(roundingOf(given, point.click, std::numeric_limits<double>::epsilon()));
    const auto a = answer(given, point.right.clicks.front(), {}), b = answer(given, point.right.clicks.back(), {});
    if (a && b && !point.onMesh)
        unsure = std::max(unsure, greatestOf(*b - *a));
    const double least = std::max(unsure, std::min(greatestOf(lastDigitGiven), kSevenDigits * greatestOf(right)));
    return least > 0.0 ? std::pow(10.0, std::ceil(std::log10(least) - 1e-9)) : 1.0; // 1e-4 stays 1e-4
}

Hypothesis rightHypothesis(const Given &given, std::span<const Prepared> points)
{
    Hypothesis right;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto found = right.nearest(given, points[i].right);
        const double distance = found ? found->distance : std::numeric_limits<double>::infinity();
        if (i == 0 && found)
            right.point = found->point;
        right.distance += distance / double(points.size());
        right.add(i, distance);
    }
    return right;
}

ErrorKind wrongOf(const Given &given, const Prepared &point)
{
    const auto unsure = point.projected ? unsureOf(given, point) : std::nullopt;
    if (!unsure)
        return ErrorKind::Matrix;
    const glm::dvec3 right(point.click.pixel.coordinates(), point.click.depth);
    const glm::dvec3 off = glm::abs(*point.projected - right);
    const bool isPixelRight = off.x <= unsure->x + 1e-6 && off.y <= unsure->y + 1e-6;
    // The click of an unknown depth has the point's depth, unless that lies outside the depth
    // range.
    double depthUnsure = unsure->z + 1e-9;
    if (point.target.clicks.size() > 1 && !point.target.isLine)
        depthUnsure += std::abs(point.target.clicks[1].depth - point.target.clicks[0].depth);
    const bool isDepthRight = off.z <= depthUnsure;
    if (isPixelRight)
        return isDepthRight ? ErrorKind::Right : ErrorKind::Depth;
    return isDepthRight && !point.target.isLine ? ErrorKind::Pixel : ErrorKind::Matrix;
}

int agreeing(std::span<const Prepared> points, std::span<const ErrorKind> wrongs)
{
    int sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int all = points[i].target.isLine ? 2 : 3;
        const bool isOnRay = wrongs[i] == ErrorKind::Right || wrongs[i] == ErrorKind::Depth;
        sum += isOnRay ? 1 : wrongs[i] == ErrorKind::Pixel ? 2 : all;
    }
    return sum;
}

double sizeOf(const Given &given)
{
    double sum = 0.0;
    for (const Target &point : given.points)
        sum += greatestOf(point.got / point.lastDigit);
    return std::max(1.0, sum / double(given.points.size()));
}

} // namespace unprojector::doctor
