#include "gui/view/observer_picture.h"

#include "core/geometry/finite.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

std::optional<WorldPoint> ObserverPicture::drawnPoint(const EyePoint &point) const
{
    const glm::dvec4 p = drawnFromEye * glm::dvec4(point.coordinates(), 1.0);
    const glm::dvec3 place = glm::dvec3(p) / p.w;
    if (!(p.w > 0.0) || !isFinite(place))
        return std::nullopt;
    return WorldPoint(place);
}

bool ObserverPicture::holds(const WorldPoint &point) const
{
    return std::all_of(planes.begin(), planes.end(), [&point](const glm::dvec4 &plane) {
        return glm::dot(plane, glm::dvec4(point.coordinates(), 1.0)) >= -1e-9 * std::abs(plane.w);
    });
}

float eyeOpacity(const Projection &projection, double t)
{
    return isPerspective(projection) ? static_cast<float>((1.0 - t) * (1.0 - t)) : 1.0f;
}

std::optional<ObserverPicture> observerPicture(const Setup &watched, const Box &extent, const Placement &reference,
                                               const Setup &observer, double t)
{
    const Result<EyeFrame> frame = eyeFrame(watched.camera());
    const Result<ViewVolumeMorph> morph = viewVolumeMorph(watched.projection());
    const Result<EyeFrame> observerFrame = eyeFrame(observer.camera());
    if (!frame || !morph || !observerFrame)
        return std::nullopt;
    const glm::dmat4 eyeWorld = eyeFromWorld(*frame);
    const Placement placement = between(placementOf(*frame, *morph), reference, t);
    const glm::dmat4 drawnEye = matrixOf(placement) * morphedFromEye(*morph, t);
    const glm::dmat4 observerDrawn = eyeFromWorld(*observerFrame);
    const glm::dmat4 turned = glm::dmat4(glm::mat3_cast(placement.rotation) * glm::dmat3(eyeWorld));
    ObserverPicture picture{*frame,
                            watched.projection(),
                            viewVolumeCorners(watched.projection()),
                            *morph,
                            t,
                            placement,
                            drawnEye,
                            drawnEye * eyeWorld,
                            glm::dmat4(1.0),
                            observerDrawn,
                            observerDrawn * turned,
                            closingPlanes(*morph, t),
                            observer,
                            *observerFrame};
    for (glm::dvec4 &plane : picture.planes)
        plane = planeInSource(plane, eyeWorld);

    // Clip distances around a ball that contains the scene, the volume and the eye.
    const WorldPoint middle(placement.position);
    double radius = 2.0 * placement.scale;
    for (int corner = 0; corner < 8 && !extent.isEmpty(); ++corner) {
        const WorldPoint p(corner & 1 ? extent.highest.x : extent.lowest.x,
                           corner & 2 ? extent.highest.y : extent.lowest.y,
                           corner & 4 ? extent.highest.z : extent.lowest.z);
        radius = std::max(radius, distance(p, middle));
    }
    if (const std::optional<WorldPoint> eye = picture.drawnPoint(EyePoint());
        eye && distance(*eye, middle) < 20.0 * placement.scale)
        radius = std::max(radius, 1.2 * distance(*eye, middle));
    const double ahead = dot(middle - observerFrame->eye, observerFrame->forward);
    const double f = std::max(ahead + radius, radius * 0.01);
    const double n = std::max(ahead - radius, f * 1e-4);
    picture.observer.projection() = withClipDistances(observer.projection(), std::min(n, f * 0.5), f);
    const Result<glm::dmat4> clip = clipFromEye(picture.observer.projection());
    if (!clip)
        return std::nullopt;
    picture.clipFromDrawn = *clip * observerDrawn;
    return picture;
}

std::optional<Segment> rayThrough(const Pick &pick, const ObserverPicture &picture)
{
    const Result<EyeFrame> frame = eyeFrame(pick.setup.camera());
    const Result<WorldPoint> &enter = pick.rayNear.world[Method::Formula], &leave = pick.rayFar.world[Method::Formula];
    if (!frame || !enter || !leave)
        return std::nullopt;
    const bool perspective = isPerspective(pick.setup.projection());
    const WorldPoint from = perspective ? frame->eye : *enter;
    const WorldVector along = *leave - from;
    const bool isSameCamera = frame->eye == picture.watched.eye && frame->forward == picture.watched.forward
                              && frame->upward == picture.watched.upward;
    if (!isSameCamera || perspective != isPerspective(picture.projection))
        return Segment{from.coordinates(), leave->coordinates()};
    const ProjectionWindow w = projectionWindow(picture.projection);
    const double start = dot(from - frame->eye, frame->forward);
    const double depth = dot(along, frame->forward);
    const auto at = [&](double distance) { return (from + along * ((distance - start) / depth)).coordinates(); };
    return Segment{perspective ? from.coordinates() : at(w.nearDistance), at(w.farDistance)};
}

std::vector<WorldPoint> pointsToFit(const ObserverPicture &picture)
{
    std::vector<WorldPoint> points{picture.watched.eye};
    const glm::dmat4 drawnFromUnit = matrixOf(placementOf(picture.watched, picture.morph));
    for (std::size_t i = 0; i < picture.corners.size(); ++i) {
        points.push_back(worldFromEye(picture.watched, picture.corners[i]));
        const glm::dvec4 cube(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0, 1.0);
        points.push_back(WorldPoint(glm::dvec3(drawnFromUnit * cube)));
    }
    return points;
}

std::optional<ClipPlaneDrag> clipPlaneAt(const ObserverPicture &picture, const glm::dvec2 &size,
                                         const glm::dvec2 &pointer)
{
    glm::dmat4 widgetFromClip(1.0);
    widgetFromClip[0][0] = size.x / 2.0;
    widgetFromClip[1][1] = -size.y / 2.0;
    widgetFromClip[3] = {size.x / 2.0, size.y / 2.0, 0.0, 1.0};
    const glm::dmat4 widgetFromEye = widgetFromClip * picture.clipFromDrawn * picture.drawnFromEye;

    constexpr double kReachPixels = 6.0;
    double closest = kReachPixels;
    std::optional<ClipPlaneDrag> found;
    constexpr std::array<std::array<std::size_t, 2>, 4> kEdges{{{0, 1}, {1, 3}, {3, 2}, {2, 0}}};
    for (const ClipPlane plane : {ClipPlane::Near, ClipPlane::Far}) {
        const std::size_t first = plane == ClipPlane::Near ? 0 : 4;
        for (const auto &edge : kEdges) {
            const glm::dvec3 from = picture.corners[first + edge[0]].coordinates(),
                             to = picture.corners[first + edge[1]].coordinates();
            const glm::dvec4 a = widgetFromEye * glm::dvec4(from, 1.0), b = widgetFromEye * glm::dvec4(to, 1.0);
            if (!(a.w > 0.0) || !(b.w > 0.0))
                continue;
            const glm::dvec2 pixelA = glm::dvec2(a) / a.w, along = glm::dvec2(b) / b.w - pixelA;
            const double length = glm::dot(along, along);
            const double share = length > 0.0 ? std::clamp(glm::dot(pointer - pixelA, along) / length, 0.0, 1.0) : 0.0;
            const double distance = glm::length(pointer - pixelA - along * share);
            if (!(distance < closest))
                continue;
            // Converts the share along the edge in the view to the share along the edge itself.
            const double s = share * a.w / (share * a.w + (1.0 - share) * b.w);
            const ClipPlaneDrag drag(picture.projection, plane, EyePoint(from * (1.0 - s) + to * s), widgetFromEye,
                                     pointer);
            // Seen head-on, a plane does not move in the view.
            constexpr double kLeastPixels = 12.0;
            const ProjectionWindow w = projectionWindow(picture.projection);
            if (glm::length(drag.pixelsPerUnit()) * (w.farDistance - w.nearDistance) < kLeastPixels)
                continue;
            closest = distance;
            found = drag;
        }
    }
    return found;
}

} // namespace unprojector::gui
