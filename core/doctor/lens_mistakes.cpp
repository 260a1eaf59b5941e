#include "core/base/translation.h"
#include "core/doctor/lens_changes.h"
#include "core/doctor/variants.h"
#include "core/geometry/numbers.h"

#include <cmath>
#include <string>

namespace unprojector::doctor {
using namespace geometry;
using base::marked;
namespace {

/// The usual aspects of windows and images, and of a program's initial window.
constexpr Surface kUsualSizes[] = {{4, 3}, {16, 9}, {16, 10}, {3, 2}, {5, 4}, {21, 9}};

void scaleEye(Run &run, double factor)
{
    run.eye.x *= factor;
    run.eye.y *= factor;
}

/// The distance that a perspective's formula gives for the depth.
double perspectiveDistance(const Run &run)
{
    const double n = run.nearDistance, f = run.farDistance, d = run.given.shareFromNear(run.depth);
    return n * f / (f * (1.0 - d) + n * d);
}

void addPerspective(VariantList &list)
{
    list.add("fov-degrees-as-radians", Stage::Lens,
             [](Run &run) { setTangent(run, std::tan(degreesFromRadians(verticalFov(run)) / 2.0)); });
    list.add("fov-radians-as-degrees", Stage::Lens,
             [](Run &run) { setTangent(run, std::tan(radiansFromDegrees(verticalFov(run)) / 2.0)); });
    list.add("fov-half", Stage::Lens, [](Run &run) { setTangent(run, std::tan(verticalFov(run) / 4.0)); });
    list.add("fov-double", Stage::Lens, [](Run &run) { setTangent(run, std::tan(verticalFov(run))); });
    list.add(
        "fov-horizontal", Stage::Lens, [](Run &run) { widen(run, 1.0 / aspectOf(run)); },
        marked("the vertical angle spans the width"));
    list.add(
        "fov-horizontal", Stage::Lens, [](Run &run) { widen(run, aspectOf(run)); },
        marked("the horizontal angle spans the height"));
    // A focal length in pixels is P[1][1] times half the height.
    list.add(
        "focal-length-not-in-pixels", Stage::Lens,
        [](Run &run) {
            run.clipFromEye[1][1] = run.clipFromEye[0][0] * 2.0 / run.viewport.height;
            run.clipFromEye[0][0] *= 2.0 / run.viewport.width;
        },
        marked("P[0][0] for both axes"));
    list.add(
        "focal-length-not-in-pixels", Stage::Lens,
        [](Run &run) {
            run.clipFromEye[0][0] *= 2.0 / run.viewport.width;
            run.clipFromEye[1][1] *= 2.0 / run.viewport.height;
        },
        marked("P[0][0] and P[1][1]"));
    list.add("frustum-centred", Stage::Lens, [](Run &run) { run.clipFromEye[2][0] = run.clipFromEye[2][1] = 0.0; });
    list.add("ortho-formula", Stage::Eye, [](Run &run) { scaleEye(run, run.nearDistance / run.distance()); });
    list.add(
        "ortho-formula", Stage::Eye,
        [](Run &run) {
            const double n = run.nearDistance, f = run.farDistance;
            scaleEye(run, n / run.distance());
            run.eye.z = run.given.side * (n + run.given.shareFromNear(run.depth) * (f - n));
        },
        marked("the depth too"));
    list.add("divided-by-far", Stage::Eye, [](Run &run) { scaleEye(run, run.nearDistance / run.farDistance); });
    // Each axis interpolates between the angles of the frustum's edges.
    list.add("linear-angle", Stage::Eye, [](Run &run) {
        const glm::dmat4 &m = run.clipFromEye;
        const double z = run.distance();
        for (int axis = 0; axis < 2; ++axis) {
            const double centre = -run.given.side * m[2][axis], scale = m[axis][axis] / std::abs(m[2][3]);
            const double low = std::atan((centre - 1.0) / scale), high = std::atan((centre + 1.0) / scale);
            run.eye[axis] = z * std::tan(low + (run.ndc[axis] + 1.0) / 2.0 * (high - low));
        }
    });
    list.add(
        "linear-angle", Stage::Eye,
        [](Run &run) {
            const double z = run.distance(), half = verticalFov(run) / 2.0;
            run.eye.x = z * std::tan(run.ndc.x * half * aspectOf(run));
            run.eye.y = z * std::tan(run.ndc.y * half);
        },
        marked("the horizontal angle is the vertical one times the aspect"));
}

void addBox(VariantList &list)
{
    list.add("perspective-formula", Stage::Eye, [](Run &run) { scaleEye(run, run.distance() / run.nearDistance); });
    list.add(
        "perspective-formula", Stage::Eye,
        [](Run &run) {
            const double z = perspectiveDistance(run), n = run.nearDistance;
            run.eye = {run.eye.x * z / n, run.eye.y * z / n, run.given.side * z};
        },
        marked("the depth too"));
    list.add(
        "perspective-formula", Stage::Eye, [](Run &run) { run.setDistance(perspectiveDistance(run)); },
        marked("the depth only"));
}

} // namespace

void addLensMistakes(VariantList &list, const Given &given, const Case &scene)
{
    if (given.isPerspective)
        addPerspective(list);
    else
        addBox(list);
    list.add("aspect-integer", Stage::Lens,
             [](Run &run) { setAspect(run, std::floor(run.viewport.width / run.viewport.height)); });
    list.add(
        "aspect-integer", Stage::Lens, [](Run &run) { setAspect(run, std::floor(aspectOf(run))); },
        marked("of the projection"));
    list.add("aspect-inverted", Stage::Lens, [](Run &run) { setAspect(run, 1.0 / aspectOf(run)); });
    list.add("aspect-of-window", Stage::Lens,
             [](Run &run) { setAspect(run, double(run.given.surface.widthPixels) / run.given.surface.heightPixels); });
    const auto setAspectGiven = [](Run &run) { setAspect(run, run.parameter / run.second); };
    for (const Surface &usual : kUsualSizes)
        list.add("aspect-stale", Stage::Lens, setAspectGiven,
                 {nullptr, {std::to_string(usual.widthPixels) + ':' + std::to_string(usual.heightPixels)}},
                 usual.widthPixels, usual.heightPixels);
    if (const auto &other = scene.otherSize)
        list.add("aspect-stale", Stage::Lens, setAspectGiven, marked("the size given"), other->widthPixels,
                 other->heightPixels);
    list.add("aspect-left-out", Stage::Lens, [](Run &run) { setAspect(run, 1.0); });
    list.add("eye-z-positive", Stage::Eye, [](Run &run) { run.eye.z = -run.eye.z; });
    list.add("eye-xy-mirrored", Stage::Eye, [](Run &run) {
        run.eye.x = -run.eye.x;
        run.eye.y = -run.eye.y;
    });
    list.add(
        "eye-xy-mirrored", Stage::Window,
        [](Run &run) {
            const Viewport &v = run.viewport;
            run.window = glm::dvec2(2.0 * v.x + v.width, 2.0 * v.y + v.height) - run.window;
        },
        marked("about the middle of the viewport"));
}

} // namespace unprojector::doctor
