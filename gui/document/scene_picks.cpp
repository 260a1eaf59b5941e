// What of a scene document is picked: the click's answers and the ray's, and what becomes of them.

#include "gui/document/scene_document.h"

#include "core/matrices/pipeline.h"
#include "core/ray/drawn_surface.h"
#include "gui/document/given_points.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
namespace {

/// What the depth buffer holds at a pixel as far as the rays tell: on the background what it was cleared to.
/// @return nothing outside the window, and where a point of a cloud may have been drawn
std::optional<double> depthSeen(const ray::SceneRays &rays, const DevicePixel &pixel, const DepthFormat &format)
{
    const Picture &picture = rays.rays().picture();
    const bool isInWindow =
        pixel.i >= 0 && pixel.j >= 0 && pixel.i < picture.surface.widthPixels && pixel.j < picture.surface.heightPixels;
    if (!isInWindow || rays.hasPoints())
        return std::nullopt;
    const auto &[atNear, atFar] = picture.depthRange;
    const Result<ray::Ray<WorldSpace>> ray = rays.rays().at(pixelCenter(pixel));
    const std::optional<ray::FirstTriangle> met =
        ray && rays.rays().isInPicture(pixelCenter(pixel)) ? rays.firstTriangle(*ray) : std::nullopt;
    if (!met)
        return atFar;
    const Result<WindowPoint> window = windowFromWorld(picture, ray->at(met->hit.t));
    if (!window)
        return std::nullopt;
    return std::clamp(format.kept(window->z), std::min(atNear, atFar), std::max(atNear, atFar));
}

} // namespace

Result<Pick> SceneDocument::unprojected(const PixelClick &click) const
{
    unproject::SurfaceAt surfaceAt;
    if (const auto object = click.sample.object; object && *object < objects().size())
        surfaceAt = [&drawn = objects()[*object]](const WorldPoint &world) { return ray::drawnSurface(drawn, world); };
    return unproject::pickAt(*m_unprojector, click, surfaceAt);
}

void SceneDocument::pickAt(const WidgetPoint &position, const DepthSample &sample)
{
    const Result<DevicePixel> pixel = devicePixelFromWidget(geometry().surface, position);
    setPick(pixel ? unprojected({position, *pixel, sample}) : pixel.error());
}

void SceneDocument::setPick(const Result<Pick> &pick)
{
    if (!pick) {
        emit pickFailed(pick.error());
        return;
    }
    m_picked = {*pick, placementOf(*pick), {}, RayScene{m_state.objects, m_scene.clipPlanes}};
    m_picked.ray.snap = m_snap;
    m_lost = {};
    m_lostPickObjects.reset();
    answerRay();
    tell(Change::Pick);
}

glm::dmat4 SceneDocument::placementOf(const Pick &pick) const
{
    return pick.object && *pick.object < objects().size() ? worldFromObject(objects()[*pick.object].transform)
                                                          : glm::dmat4(1.0);
}

SinceClick SceneDocument::sinceClick() const
{
    if (!m_picked.pick)
        return {};
    const bool isHidden = m_picked.pick->object && *m_picked.pick->object < objects().size()
                          && objects()[*m_picked.pick->object].isHidden;
    return {m_picked.pick->geometry != geometry(), placementOf(*m_picked.pick) != m_picked.placement, isHidden,
            isCutAway(*m_picked.pick)};
}

bool SceneDocument::isCutAway(const Pick &pick) const
{
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    if (!pick.hit() || !world)
        return false;
    // A point of the cut itself lies on either side of the plane, no farther than its pixel reaches.
    const Components<3> &uncertainty = pick.withinPixel.world;
    return std::any_of(m_scene.clipPlanes.begin(), m_scene.clipPlanes.end(), [&](const glm::dvec4 &plane) {
        const double doubt =
            std::abs(plane.x) * uncertainty.x + std::abs(plane.y) * uncertainty.y + std::abs(plane.z) * uncertainty.z;
        return glm::dot(plane, glm::dvec4(world->coordinates(), 1.0)) < -doubt;
    });
}

void SceneDocument::putBack(const KeptPick &kept)
{
    m_lost = {};
    m_lostPickObjects.reset();
    if (!m_picked.pick && !kept.pick)
        return;
    m_picked = kept;
    answerRay();
    tell(Change::Pick);
}

bool SceneDocument::followObjects(const std::shared_ptr<const std::vector<SceneObject>> &before)
{
    const auto follow = [this](const std::vector<SceneObject> &objects, std::optional<std::size_t> &place) {
        const std::optional<std::size_t> was = place;
        place = place && *place < objects.size() ? placeAfter(objects, *place, m_scene.objects) : std::nullopt;
        return place != was;
    };
    const auto followMet = [&](const std::vector<SceneObject> &objects) {
        bool isOther = false;
        for (std::optional<MetPlace> *place : {&m_picked.ray.met, &m_picked.ray.taken})
            isOther = (*place && follow(objects, (*place)->object)) || isOther;
        return isOther;
    };
    if (m_picked.pick) {
        std::optional<std::size_t> place = m_picked.pick->object;
        const bool isOther = follow(*before, place);
        if (isOther && !place) {
            m_lost = std::exchange(m_picked, {});
            m_lostPickObjects = before;
            return true;
        }
        m_picked.pick->object = place;
        return followMet(*before) || isOther;
    }
    if (!m_lost.pick)
        return false;
    std::optional<std::size_t> place = m_lost.pick->object;
    follow(*m_lostPickObjects, place);
    if (!place)
        return false;
    m_picked = std::exchange(m_lost, {});
    m_picked.pick->object = place;
    followMet(*m_lostPickObjects);
    m_lostPickObjects.reset();
    return true;
}

std::optional<WorldPoint> SceneDocument::pickedPoint() const
{
    const std::optional<Pick> &pick = m_picked.pick;
    if (!pick || !pick->hit())
        return std::nullopt;
    if (m_picked.ray.snap != ray::Snap::Surface && m_picked.ray.taken)
        return m_picked.ray.taken->hit.world;
    const Result<WorldPoint> &formula = pick->point.world[Method::Formula];
    return formula ? std::optional(*formula) : std::nullopt;
}

std::optional<WorldPoint> SceneDocument::givenWorld() const
{
    if (!m_scene.givenPoint)
        return std::nullopt;
    const std::optional<std::size_t> object = placeOf(*m_scene.givenPoint, objects());
    const Result<matrices::Pipeline> pipeline =
        matrices::pipeline(geometry(), object ? worldFromObject(objects()[*object].transform) : glm::dmat4(1.0));
    if (!pipeline)
        return std::nullopt;
    const Result<WorldPoint> world = pointsFrom(*pipeline, *m_scene.givenPoint).world;
    return world ? std::optional(*world) : std::nullopt;
}

void SceneDocument::markWrongPoints(std::vector<WrongPointMark> points)
{
    if (std::exchange(m_wrongPoints, std::move(points)) != m_wrongPoints)
        tell(Change::WrongPoints);
}

const ray::SceneRays *SceneDocument::rays() const
{
    if (!m_rays) {
        if (const auto casters = m_casters.of(objects()))
            m_rays.emplace(*m_unprojector, objects(), *casters, m_scene.clipPlanes);
    }
    return m_rays ? &*m_rays : nullptr;
}

void SceneDocument::setSnap(ray::Snap snap)
{
    if (std::exchange(m_snap, snap) != snap)
        tell(Change::Snap);
}

void SceneDocument::prepareRays()
{
    std::vector<SceneObject> all = objects();
    if (m_picked.rayScene)
        all.insert(all.end(), m_picked.rayScene->objects->begin(), m_picked.rayScene->objects->end());
    m_casters.prepare(all);
    if (answerRay())
        m_untold |= Change::Ray;
}

MetPlace SceneDocument::metPlace(const ray::SceneHit &hit, const std::vector<SceneObject> &objects) const
{
    const std::size_t place = hit.object;
    const std::vector<SceneObject> &now = m_scene.objects;
    // It may have been moved since, which makes it no other object.
    const bool isThere = place < now.size() && isSameObject(objects[place], now[place]);
    return {hit, isThere ? std::optional(place) : placeAfter(objects, place, now), objects[place].name};
}

bool SceneDocument::answerRay()
{
    if (!m_picked.pick || !m_picked.rayScene)
        return false;
    const std::vector<SceneObject> &objects = *m_picked.rayScene->objects;
    PickedRay &ray = m_picked.ray;
    const auto casters = m_casters.of(objects);
    if (!casters) {
        ray.failure = m_casters.failureOf(objects);
        return std::exchange(ray.state, ray.failure ? PickedRay::State::Impossible : PickedRay::State::Preparing)
               != ray.state;
    }
    ray.failure.reset();
    ray.state = PickedRay::State::Impossible;
    const auto answer = [&](const Unprojector &unprojector, const ray::SceneRays &rays) {
        const DevicePoint position = pixelCenter(m_picked.pick->devicePixel);
        const auto met = rays.at(position), taken = rays.at(position, ray.snap);
        if (!met || !taken)
            return;
        ray.state = PickedRay::State::Answered;
        if (*met)
            ray.met = metPlace(**met, objects);
        // The triangle says how sure the depth's own point is, where it is the one that was drawn.
        const bool isSameObject = *met && ray.met->object && ray.met->object == m_picked.pick->object;
        const Pick known =
            isSameObject ? refined(*m_picked.pick, ray::drawnSurface(objects[(*met)->object], **met)) : *m_picked.pick;
        ray.comparison = ray::compared(known, *met, isSameObject);
        if (ray.comparison.kind != ray::RayComparison::Kind::OtherPart)
            m_picked.pick = known;
        if (*taken)
            ray.taken = metPlace(**taken, objects);
        const Pick &pick = *m_picked.pick;
        if (pick.hit()) {
            ray.others = otherAnswers(unprojector, pick.devicePixel, [&](const DevicePixel &pixel) {
                return pixel == pick.devicePixel ? std::optional(pick.window.z)
                                                 : depthSeen(rays, pixel, pick.sample.format);
            });
        }
    };
    const auto &[clickedObjects, clipPlanes] = *m_picked.rayScene;
    const bool isShown =
        m_picked.pick->geometry == geometry() && clickedObjects == m_state.objects && clipPlanes == m_scene.clipPlanes;
    if (const ray::SceneRays *shown = isShown ? rays() : nullptr)
        answer(*m_unprojector, *shown);
    else if (const Result<Unprojector> former = Unprojector::of(m_picked.pick->geometry))
        answer(*former, ray::SceneRays(*former, objects, *casters, clipPlanes));
    m_picked.rayScene.reset();
    return true;
}

} // namespace unprojector::gui
