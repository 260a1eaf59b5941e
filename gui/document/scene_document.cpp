#include "gui/document/scene_document.h"

#include "core/geometry/angle.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace unprojector::gui {
namespace {

/// 1, 2 or 5 times a power of ten, at least `value`.
double roundedUp(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= value * (1.0 - 1e-9))
            return digit * power;
    }
    return 10.0 * power;
}

/// What a picture of these objects that fills it would be.
Picture framed(const Picture &picture, const std::vector<SceneObject> &objects)
{
    Framing framing(picture);
    for (const SceneObject &object : objects) {
        if (!object.isHidden)
            add(framing, object);
    }
    return framing.picture();
}

} // namespace

Projection SceneDocument::initialProjection()
{
    return Perspective{radiansFromDegrees(45.0), 1.0, 0.1, 100.0};
}

class SceneDocument::Telling {
public:
    explicit Telling(SceneDocument &document) : m_document(document) { ++m_document.m_tellings; }
    ~Telling()
    {
        if (--m_document.m_tellings == 0)
            m_document.tell({});
    }
    Telling(const Telling &) = delete;
    Telling &operator=(const Telling &) = delete;

private:
    SceneDocument &m_document;
};

SceneDocument::SceneDocument(QObject *parent) : QObject(parent)
{
    m_undoStack.setUndoLimit(200);
    const auto tellHistory = [this] { tell(Change::History); };
    connect(&m_undoStack, &QUndoStack::indexChanged, this, tellHistory);
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, tellHistory);
    m_state.objects = std::make_shared<const std::vector<SceneObject>>();
    Scene empty;
    empty.projection = initialProjection();
    const Check opened = open(std::move(empty));
    Q_ASSERT(opened.hasValue());
}

SceneDocument::~SceneDocument()
{
    m_undoStack.disconnect(this); // it tells of its own end
}

void SceneDocument::tell(Changes changes)
{
    m_untold |= changes;
    if (m_tellings > 0 || !m_untold)
        return;
    emit changed(std::exchange(m_untold, {}));
}

SceneState SceneDocument::with(SceneSettings settings) const
{
    SceneState state = m_state;
    state.settings = std::move(settings);
    return state;
}

Result<Changes> SceneDocument::take(const SceneState &state)
{
    // In place, since a copy of the scene would copy all its objects; and back again where that is no picture.
    const auto put = [this](const SceneState &which, bool withObjects) {
        static_cast<SceneSettings &>(m_scene) = which.settings;
        if (withObjects)
            m_scene.objects = *which.objects;
    };
    const bool hasOtherObjects = state.objects != m_state.objects;
    put(state, hasOtherObjects);
    const Box bounds = hasOtherObjects ? boundsOf(m_scene) : m_bounds;
    const Ground ground = hasOtherObjects ? groundUnder(bounds) : m_ground;
    const Result<Picture> picture = pictureOf(m_scene, m_surface, ground.box);
    Result<Unprojector> unprojector = picture ? Unprojector::of(*picture) : picture.error();
    if (!unprojector) {
        put(m_state, hasOtherObjects);
        return unprojector.error();
    }

    Changes changes;
    if (!m_unprojector || picture->surface != geometry().surface || picture->viewport != geometry().viewport)
        changes |= Change::Picture;
    // What follows the window is kept as it came out, so that fields show the numbers in use.
    m_scene.projection = picture->projection();
    changes |= changesBetween(m_state.settings, m_scene);
    if (hasOtherObjects)
        changes |= changesBetween(*m_state.objects, m_scene.objects);
    if (changes.testFlag(Change::Objects) && followObjects(m_state.objects))
        changes |= Change::Pick;
    m_unprojector = unprojector.value();
    m_bounds = bounds;
    m_ground = ground;
    m_state = state;
    m_state.settings.projection = m_scene.projection;
    return changes;
}

bool SceneDocument::followObjects(const std::shared_ptr<const std::vector<SceneObject>> &before)
{
    if (m_pick && m_pick->object && *m_pick->object < before->size()) {
        const auto place = placeAfter(*before, *m_pick->object, m_scene.objects);
        if (place == m_pick->object)
            return false;
        if (!place) {
            m_lostPick = std::exchange(m_pick, std::nullopt);
            m_lostPickObjects = before;
        } else {
            m_pick->object = place;
        }
        return true;
    }
    if (m_pick || !m_lostPick)
        return false;
    const auto place = placeAfter(*m_lostPickObjects, *m_lostPick->object, m_scene.objects);
    if (!place)
        return false;
    m_pick = std::exchange(m_lostPick, std::nullopt);
    m_pick->object = place;
    m_lostPickObjects.reset();
    return true;
}

Check SceneDocument::open(Scene scene)
{
    const Telling telling(*this);
    auto objects = std::make_shared<const std::vector<SceneObject>>(std::move(scene.objects));
    const Result<Changes> taken = take({std::move(scene), std::move(objects), m_lastEdit + 1});
    if (!taken)
        return taken.error();
    m_savedEdit = ++m_lastEdit;
    m_undoStack.clear();
    clearPick();
    emit opened();
    tell(kSeen | Change::Pick | Change::History);
    return std::monostate{};
}

void SceneDocument::setObjects(std::vector<SceneObject> objects, const LookAt &home)
{
    Scene scene;
    scene.camera = scene.home = home;
    scene.projection = initialProjection();
    scene.objects = std::move(objects);
    const Check opened = open(std::move(scene));
    Q_ASSERT(opened.hasValue());
}

void SceneDocument::setObjects(std::vector<SceneObject> objects)
{
    Scene scene;
    scene.objects = std::move(objects);
    // Scans face +z as a rule; a little from above and the side shows that they have depth.
    Picture home{m_surface,
                 wholeSurface(m_surface),
                 {},
                 initialProjection(),
                 LookAt{WorldPoint(0.35, 0.25, 1.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
    home.projection() = withAspect(home.projection(), home.viewport.width / home.viewport.height);
    const LookAt camera = framed(home, scene.objects).camera();
    setObjects(std::move(scene.objects), camera);
}

Check SceneDocument::record(const SceneState &state, const Deed &deed)
{
    const Telling telling(*this);
    const SceneState before = m_state;
    const Result<Changes> taken = take(state);
    if (!taken)
        return taken.error();
    if (!*taken) {
        m_state = before;
        return std::monostate{};
    }
    tell(*taken);
    m_lastEdit = std::max(m_lastEdit, state.edit);
    m_undoStack.push(new SceneChange(*this, before, m_state, deed.text, deed.mergeKey));
    return std::monostate{};
}

void SceneDocument::restore(const SceneState &state)
{
    const Result<Changes> taken = take(state);
    Q_ASSERT(taken.hasValue());
    if (taken)
        m_untold |= *taken;
}

Check SceneDocument::edit(SceneSettings settings, const Deed &deed)
{
    SceneState state = with(std::move(settings));
    state.edit = m_lastEdit + 1;
    return record(state, deed);
}

Check SceneDocument::edit(std::vector<SceneObject> objects, const Deed &deed)
{
    return record(
        {m_state.settings, std::make_shared<const std::vector<SceneObject>>(std::move(objects)), m_lastEdit + 1}, deed);
}

void SceneDocument::look(SceneSettings settings, const Deed &deed)
{
    const Telling telling(*this);
    const SceneState before = m_state;
    // A step that would leave no valid picture (a zoom past the smallest number, say) is not taken.
    const Result<Changes> taken = take(with(std::move(settings)));
    if (!taken)
        return;
    if (isSameLook(before.settings, m_state.settings)) {
        static_cast<void>(take(before)); // it was there a moment ago, and nobody has heard of anything else
        return;
    }
    tell(*taken);
    m_undoStack.push(new SceneChange(*this, before, m_state, deed.text, deed.mergeKey));
}

Check SceneDocument::editTransform(std::size_t place, std::vector<TransformStep> steps, const Deed &deed)
{
    Q_ASSERT(place < objects().size());
    std::vector<SceneObject> objects = *m_state.objects;
    objects[place].transform = std::move(steps);
    return edit(std::move(objects), deed);
}

Check SceneDocument::editCamera(const LookAt &camera, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    settings.camera = camera;
    return edit(std::move(settings), deed);
}

Check SceneDocument::editProjection(const ProjectionRule &rule, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    settings.projection = rule.projection;
    settings.projectionFollowsViewport = rule.followsViewport;
    settings.clipDistancesFitObjects = rule.fitsObjects;
    return edit(std::move(settings), deed);
}

Check SceneDocument::editViewport(const ViewportRule &rule, const DepthRange &range, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    settings.viewport = rule;
    settings.depthRange = range;
    return edit(std::move(settings), deed);
}

Check SceneDocument::editClipPlanes(std::vector<glm::dvec4> planes, std::vector<ClipPlaneOff> off, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    settings.clipPlanes = std::move(planes);
    settings.clipPlanesOff = std::move(off);
    return edit(std::move(settings), deed);
}

void SceneDocument::markSaved()
{
    const Telling telling(*this);
    m_savedEdit = m_state.edit;
    m_undoStack.setClean();
    tell(Change::History);
}

void SceneDocument::markUnsaved()
{
    const Telling telling(*this);
    m_savedEdit.reset();
    m_undoStack.resetClean();
    tell(Change::History);
}

SceneDocument::Ground SceneDocument::groundUnder(const Box &bounds)
{
    Ground ground;
    if (bounds.isEmpty())
        return ground;
    const double size = bounds.diagonal() > 0.0 ? bounds.diagonal() : 1.0;
    ground.spacing = roundedUp(size / 15.0);
    // Lines at whole multiples of the spacing, so that they can be read as coordinates.
    const auto snapped = [&ground](double value, double direction) {
        return (std::floor(value / ground.spacing) + direction) * ground.spacing;
    };
    const double margin = size * 0.5;
    const double y = bounds.lowest.y;
    ground.box.add({snapped(bounds.lowest.x - margin, 0.0), y, snapped(bounds.lowest.z - margin, 0.0)});
    ground.box.add({snapped(bounds.highest.x + margin, 1.0), y, snapped(bounds.highest.z + margin, 1.0)});
    return ground;
}

void SceneDocument::setSurface(const Surface &surface)
{
    if (surface == m_surface)
        return;
    const Surface before = std::exchange(m_surface, surface);
    if (const Result<Changes> taken = take(m_state))
        tell(*taken);
    else
        m_surface = before;
}

void SceneDocument::setCamera(const LookAt &camera, const QString &mergeKey)
{
    setView(camera, m_scene.projection, mergeKey);
}

void SceneDocument::setProjection(const Projection &projection, const QString &mergeKey)
{
    setView(m_scene.camera, projection, mergeKey);
}

void SceneDocument::setView(const LookAt &camera, const Projection &projection, const QString &mergeKey)
{
    SceneSettings settings = m_state.settings;
    settings.camera = camera;
    settings.projection = projection;
    look(std::move(settings), {tr("Camera"), mergeKey});
}

void SceneDocument::fit()
{
    showFramed(framed(geometry(), objects()), m_bounds);
}

void SceneDocument::showFramed(Picture picture, const Box &bounds)
{
    // Near and far that were typed stay while they cut nothing off.
    if (!m_scene.clipDistancesFitObjects && !bounds.isEmpty()) {
        const Projection fitted = withFittedClipDistances(picture, bounds, {});
        const ProjectionWindow own = projectionWindow(picture.projection()), tight = projectionWindow(fitted);
        if (own.nearDistance > tight.nearDistance || own.farDistance < tight.farDistance)
            picture.projection() =
                withClipDistances(picture.projection(), std::min(own.nearDistance, tight.nearDistance),
                                  std::max(own.farDistance, tight.farDistance));
    }
    setView(picture.camera(), picture.projection());
}

void SceneDocument::fitObject(std::size_t place)
{
    Q_ASSERT(place < objects().size());
    Framing framing(geometry());
    add(framing, objects()[place]);
    showFramed(framing.picture(), boundsOf(objects()[place]));
}

void SceneDocument::goHome()
{
    SceneSettings settings = m_state.settings;
    settings.camera = settings.home;
    if (settings.projectionFollowsViewport)
        settings.projection = initialProjection();
    look(std::move(settings), {tr("Home")});
}

double SceneDocument::centerDistance() const
{
    return distance(m_scene.camera.center, m_scene.camera.eye);
}

void SceneDocument::switchProjection()
{
    const bool perspective = isPerspective(m_scene.projection);
    SceneSettings settings = m_state.settings;
    settings.projection = converted(
        settings.projection, perspective ? ProjectionKind::Ortho : ProjectionKind::Perspective, centerDistance());
    look(std::move(settings), {perspective ? tr("Orthographic") : tr("Perspective")});
}

Result<Pick> SceneDocument::unprojected(const WidgetPoint &position, const DepthSample &sample) const
{
    return unproject::pickAt(*m_unprojector, position, sample);
}

void SceneDocument::setPick(const Result<Pick> &pick)
{
    if (!pick) {
        emit pickFailed(pick.error());
        return;
    }
    m_pick = *pick;
    m_lostPick.reset();
    m_lostPickObjects.reset();
    m_pickedPlacement = placementOf(*m_pick);
    tell(Change::Pick);
}

glm::dmat4 SceneDocument::placementOf(const Pick &pick) const
{
    return pick.object && *pick.object < objects().size() ? worldFromObject(objects()[*pick.object].transform)
                                                          : glm::dmat4(1.0);
}

SinceClick SceneDocument::sinceClick() const
{
    if (!m_pick)
        return {};
    const bool isHidden = m_pick->object && *m_pick->object < objects().size() && objects()[*m_pick->object].isHidden;
    return {m_pick->geometry != geometry(), placementOf(*m_pick) != m_pickedPlacement, isHidden, isCutAway(*m_pick)};
}

bool SceneDocument::isCutAway(const Pick &pick) const
{
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    if (!pick.hit() || !world)
        return false;
    // A point of the cut itself lies on either side of the plane, by as much as is uncertain of it.
    const Components<3> &uncertainty = pick.uncertainty.world;
    return std::any_of(m_scene.clipPlanes.begin(), m_scene.clipPlanes.end(), [&](const glm::dvec4 &plane) {
        const double doubt =
            std::abs(plane.x) * uncertainty.x + std::abs(plane.y) * uncertainty.y + std::abs(plane.z) * uncertainty.z;
        return glm::dot(plane, glm::dvec4(world->coordinates(), 1.0)) < -doubt;
    });
}

void SceneDocument::putBack(const KeptPick &kept)
{
    m_lostPick.reset();
    m_lostPickObjects.reset();
    if (!m_pick && !kept.pick)
        return;
    m_pick = kept.pick;
    m_pickedPlacement = kept.placement;
    tell(Change::Pick);
}

WorldPoint SceneDocument::pivotOf(const Result<Pick> &pick) const
{
    const LookAt &camera = geometry().camera();
    if (!pick)
        return camera.center;
    if (const Result<WorldPoint> &surface = pick->point.world[Method::Formula]; pick->hit())
        return surface ? *surface : camera.center;
    const Result<WorldPoint> &enter = pick->rayNear.world[Method::Formula];
    const Result<WorldPoint> &leave = pick->rayFar.world[Method::Formula];
    const Result<EyeFrame> frame = eyeFrame(camera);
    if (!enter || !leave || !frame)
        return camera.center;
    const double wanted = eyeFromWorld(*frame, camera.center).z;
    const double zEnter = eyeFromWorld(*frame, *enter).z;
    const double zLeave = eyeFromWorld(*frame, *leave).z;
    const double t = (wanted - zEnter) / (zLeave - zEnter);
    return *enter + t * (*leave - *enter);
}

} // namespace unprojector::gui
