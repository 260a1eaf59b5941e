#include "gui/document/kept_pick.h"

#include "core/ray/drawn_surface.h"
#include "gui/document/document_change.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

namespace {

const SceneObject *objectOf(const Pick &pick, const std::vector<SceneObject> &objects)
{
    return pick.object && *pick.object < objects.size() ? &objects[*pick.object] : nullptr;
}

bool isCutAway(const Pick &pick, const std::vector<glm::dvec4> &clipPlanes)
{
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    if (!pick.hit() || !world)
        return false;
    // A point of the cut itself may be on either side of the plane, within its pixel.
    const Components<3> &uncertainty = pick.withinPixel.world;
    return std::any_of(clipPlanes.begin(), clipPlanes.end(), [&](const glm::dvec4 &plane) {
        const double doubt =
            std::abs(plane.x) * uncertainty.x + std::abs(plane.y) * uncertainty.y + std::abs(plane.z) * uncertainty.z;
        return glm::dot(plane, glm::dvec4(world->coordinates(), 1.0)) < -doubt;
    });
}

/// The depth that the depth buffer has at a pixel according to the rays: on the background its
/// clear value.
/// @return nothing outside the window, and if a point of a cloud may have been drawn
std::optional<double> depthSeen(const ray::SceneRays &rays, const DevicePixel &pixel, const DepthFormat &format)
{
    const Setup &setup = rays.rays().setup();
    const bool isInWindow =
        pixel.i >= 0 && pixel.j >= 0 && pixel.i < setup.surface.widthPixels && pixel.j < setup.surface.heightPixels;
    if (!isInWindow || rays.hasPoints())
        return std::nullopt;
    const auto &[atNear, atFar] = setup.depthRange;
    const Result<ray::Ray<WorldSpace>> ray = rays.rays().at(pixelCenter(pixel));
    const std::optional<ray::FirstTriangle> met =
        ray && rays.rays().isInPicture(pixelCenter(pixel)) ? rays.firstTriangle(*ray) : std::nullopt;
    if (!met)
        return atFar;
    const Result<WindowPoint> window = windowFromWorld(setup, ray->at(met->hit.t));
    if (!window)
        return std::nullopt;
    return std::clamp(format.kept(window->z), std::min(atNear, atFar), std::max(atNear, atFar));
}

/// @param clicked  the objects at the click
MetPlace metPlace(const ray::SceneHit &hit, const std::vector<SceneObject> &clicked,
                  const std::vector<SceneObject> &now)
{
    const std::size_t index = hit.object;
    // A moved object is still the same object.
    const bool isThere = index < now.size() && isSameObject(clicked[index], now[index]);
    return {hit, isThere ? std::optional(index) : indexAfter(clicked, index, now), clicked[index].name};
}

} // namespace

PreciseMatrix placementOf(const Pick &pick, const std::vector<SceneObject> &objects)
{
    const SceneObject *object = objectOf(pick, objects);
    return object ? preciseWorldFromObject(object->transform) : PreciseMatrix();
}

SinceClick sinceClick(const KeptPick &kept, const Scene &scene, const Setup &setup)
{
    if (!kept.pick)
        return {};
    const SceneObject *object = objectOf(*kept.pick, scene.objects);
    return {kept.pick->setup != setup, placementOf(*kept.pick, scene.objects) != kept.placement,
            object && object->isHidden, isCutAway(*kept.pick, scene.clipPlanes)};
}

std::optional<WorldPoint> pickedPoint(const KeptPick &kept)
{
    if (!kept.pick || !kept.pick->hit())
        return std::nullopt;
    if (kept.ray.snap != ray::Snap::Surface && kept.ray.taken)
        return kept.ray.taken->hit.world;
    const Result<WorldPoint> &formula = kept.pick->point.world[Method::Formula];
    return formula ? std::optional(*formula) : std::nullopt;
}

WorldVector pickedUncertainty(const KeptPick &kept)
{
    if (kept.ray.snap != ray::Snap::Surface && kept.ray.taken)
        return kept.ray.taken->hit.uncertainty;
    return kept.pick->uncertainty.world;
}

bool follow(KeptPick &kept, const std::vector<SceneObject> &before, const std::vector<SceneObject> &after)
{
    bool isOther = false;
    const auto followOne = [&](std::optional<std::size_t> &index) {
        const std::optional<std::size_t> was = index;
        index = index && *index < before.size() ? indexAfter(before, *index, after) : std::nullopt;
        isOther = isOther || index != was;
    };
    if (kept.pick)
        followOne(kept.pick->object);
    for (std::optional<MetPlace> *place : {&kept.ray.met, &kept.ray.taken}) {
        if (*place)
            followOne((*place)->object);
    }
    return isOther;
}

void answerRay(KeptPick &kept, const Unprojector &unprojector, const ray::SceneRays &rays,
               const std::vector<SceneObject> &now)
{
    const std::vector<SceneObject> &clicked = *kept.rayScene->objects;
    Pick &pick = *kept.pick;
    PickedRay &ray = kept.ray;
    const DevicePoint position = pixelCenter(pick.devicePixel);
    const auto met = rays.at(position), taken = ray.snap == ray::Snap::Surface ? met : rays.at(position, ray.snap);
    if (!met || !taken)
        return;
    ray.state = PickedRay::State::Answered;
    if (*met)
        ray.met = metPlace(**met, clicked, now);
    if (!*met || (*met)->triangle)
        ray.edge = ray::edgeInPixel(rays, position, *met);
    if (ray.edge && ray.edge->object)
        ray.edgeObject = clicked[*ray.edge->object].name;
    // The triangle gives the uncertainty of the depth's own point if it is the drawn triangle.
    const bool isSameObject = *met && ray.met->object && ray.met->object == pick.object;
    const Pick known = isSameObject ? refined(pick, ray::drawnSurface(clicked[(*met)->object], **met)) : pick;
    ray.comparison = ray::compared(known, *met, isSameObject);
    if (ray.comparison.kind != ray::RayComparison::Kind::OtherPart)
        pick = known;
    if (*taken)
        ray.taken = metPlace(**taken, clicked, now);
    if (pick.hit()) {
        ray.others = otherAnswers(unprojector, pick.devicePixel, [&](const DevicePixel &pixel) {
            return pixel == pick.devicePixel ? std::optional(pick.window.z)
                                             : depthSeen(rays, pixel, pick.sample.format);
        });
    }
}

} // namespace unprojector::gui
