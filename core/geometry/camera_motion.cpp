#include "core/geometry/camera_motion.h"

#include "core/geometry/numbers.h"
#include "core/geometry/parallel_projection.h"
#include "core/geometry/proportions.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::geometry {
namespace {

constexpr WorldVector kWorldUp{0.0, 1.0, 0.0};
/// The turntable stops at this angle from looking straight up or down.
constexpr double kPoleMarginRadians = 0.01;

/// Rodrigues' rotation of v about a unit axis.
WorldVector rotated(const WorldVector &v, const WorldVector &axis, double angle)
{
    return v * std::cos(angle) + cross(axis, v) * std::sin(angle) + axis * dot(axis, v) * (1.0 - std::cos(angle));
}

double centerDistance(const LookAt &camera)
{
    return distance(camera.center, camera.eye);
}

/// A camera with these axes. Its up is world up wherever that gives the same camera, because users
/// expect to read it and to pass it to gluLookAt.
LookAt fromAxes(const WorldPoint &eye, const WorldVector &forward, const WorldVector &upward, double distance)
{
    const WorldVector side = cross(forward, upward);
    const WorldVector level = cross(forward, kWorldUp);
    constexpr double kLevel = 1e-9;
    const bool isLevel =
        length(level) > kPoleMarginRadians / 2.0 && length(normalized(level) - normalized(side)) < kLevel;
    return {eye, eye + forward * distance, isLevel ? kWorldUp : upward};
}

} // namespace

LookAt orbited(const LookAt &camera, const WorldPoint &pivot, double yawRadians, double pitchRadians)
{
    const EyeFrame frame = eyeFrame(camera).value();
    // Tipping the scene towards the viewer lowers the view direction, limited by the poles. A
    // camera that is at a pole already (a top view) may leave it but not pass it. An upside-down
    // camera has no limit.
    double pitch = -pitchRadians;
    if (dot(frame.upward, kWorldUp) > -1e-9) {
        const double elevation = std::asin(std::clamp(dot(frame.forward, kWorldUp), -1.0, 1.0));
        constexpr double kLimit = kPi / 2.0 - kPoleMarginRadians;
        pitch = std::clamp(elevation + pitch, std::min(-kLimit, elevation), std::max(kLimit, elevation)) - elevation;
    }

    const auto turned = [&](const WorldVector &v) {
        return rotated(rotated(v, frame.side, pitch), kWorldUp, -yawRadians);
    };
    const WorldPoint eye = pivot + turned(frame.eye - pivot);
    return fromAxes(eye, normalized(turned(frame.forward)), normalized(turned(frame.upward)), centerDistance(camera));
}

LookAt moved(const LookAt &camera, const WorldVector &offset)
{
    return {camera.eye + offset, camera.center + offset, camera.up};
}

LookAt seenFrom(const LookAt &camera, StandardView side)
{
    WorldVector towardsViewer{0.0, 0.0, 1.0};
    WorldVector up = kWorldUp;
    switch (side) {
    case StandardView::Front: break;
    case StandardView::Back: towardsViewer = {0.0, 0.0, -1.0}; break;
    case StandardView::Right: towardsViewer = {1.0, 0.0, 0.0}; break;
    case StandardView::Left: towardsViewer = {-1.0, 0.0, 0.0}; break;
    case StandardView::Top:
        towardsViewer = {0.0, 1.0, 0.0};
        up = {0.0, 0.0, -1.0};
        break;
    case StandardView::Bottom:
        towardsViewer = {0.0, -1.0, 0.0};
        up = {0.0, 0.0, 1.0};
        break;
    }
    return {camera.center + towardsViewer * centerDistance(camera), camera.center, up};
}

double worldPerLogicalPixel(const Setup &setup, const WorldPoint &anchor)
{
    const double distance = -eyeFromWorld(eyeFrame(setup.camera()).value(), anchor).z;
    return pixelFootprint(setup, distance).y * setup.surface.devicePixelRatio;
}

Setup zoomed(const Setup &setup, const WorldPoint &anchor, double factor)
{
    Setup result = setup;
    const EyeFrame frame = eyeFrame(setup.camera()).value();
    const EyePoint inEye = eyeFromWorld(frame, anchor);
    const double distance = -inEye.z > 0.0 ? -inEye.z : centerDistance(setup.camera());
    if (isPerspective(setup.projection())) {
        result.camera().eye = frame.eye + (anchor - frame.eye) * (1.0 - 1.0 / factor);
    } else {
        // The eye of a box moves too. That changes nothing in the view of a glOrtho, and a
        // perspective that is selected later has the same field of view as before.
        const double step = distance * (1.0 - 1.0 / factor);
        result.camera().eye = frame.eye + frame.forward * step;
        // The window shrinks about the anchor. A sheared view shifts as the eye steps forward.
        const glm::dvec2 slope = shearOf(result.projection());
        const glm::dvec2 onWindow = glm::dvec2(inEye.x, inEye.y) + slope * inEye.z, shift = slope * step;
        Ortho &box = *boxOf(result.projection());
        for (double *x : {&box.left, &box.right})
            *x = onWindow.x + (*x - onWindow.x) * (1.0 / factor) + shift.x;
        for (double *y : {&box.bottom, &box.top})
            *y = onWindow.y + (*y - onWindow.y) * (1.0 / factor) + shift.y;
    }
    result.camera().center = result.camera().eye + frame.forward * (distance / factor);
    return result;
}

LookAt recentered(const Setup &setup, const WorldPoint &point)
{
    const EyeFrame frame = eyeFrame(setup.camera()).value();
    const EyePoint inEye = eyeFromWorld(frame, point);
    // The middle of the view is the middle of the projection's window, which need not be on the
    // view axis.
    const ProjectionWindow w = projectionWindow(setup.projection());
    const double scale = isPerspective(setup.projection()) ? -inEye.z / w.nearDistance : 1.0;
    glm::dvec2 middle((w.left + w.right) / 2.0 * scale, (w.bottom + w.top) / 2.0 * scale);
    middle.x -= w.skew * middle.y;
    middle -= shearOf(setup.projection()) * inEye.z;
    const WorldVector offset = (inEye.x - middle.x) * frame.side + (inEye.y - middle.y) * frame.upward;
    LookAt camera = moved(setup.camera(), offset);
    const double distance = -inEye.z > 0.0 ? -inEye.z : centerDistance(camera);
    camera.center = camera.eye + frame.forward * distance;
    return camera;
}

Projection withFittedClipDistances(const Setup &setup, const Box &bounds, const Box &reach)
{
    if (bounds.isEmpty())
        return setup.projection();
    const EyeFrame frame = eyeFrame(setup.camera()).value();
    const auto distances = [&frame](const Box &box) {
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
        for (int corner = 0; corner < 8; ++corner) {
            const WorldPoint p(corner & 1 ? box.highest.x : box.lowest.x, corner & 2 ? box.highest.y : box.lowest.y,
                               corner & 4 ? box.highest.z : box.lowest.z);
            const double z = -eyeFromWorld(frame, p).z;
            lowest = std::min(lowest, z);
            highest = std::max(highest, z);
        }
        return std::pair(lowest, highest);
    };
    const double margin = std::max(bounds.diagonal() * 0.01, centerDistance(setup.camera()) * 1e-3);
    auto [lowest, highest] = distances(bounds);
    if (!reach.isEmpty())
        highest = std::max(highest, distances(reach).second);
    double n = lowest - margin;
    double f = highest + margin;
    if (isPerspective(setup.projection())) {
        n = std::max(n, centerDistance(setup.camera()) * 0.01);
        f = std::max(f, n * 2.0);
    }
    return withClipDistances(setup.projection(), n, f);
}

} // namespace unprojector::geometry
