#include "gui/document/scene_document.h"

#include "gui/document/given_points.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/scene_curves.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace unprojector::gui {
namespace {

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

bool isReversed(const std::optional<GivenProjection> &given)
{
    const auto form = given ? recognised(given->matrix) : Error{};
    return form && form->reversed;
}

} // namespace

SceneDocument::Telling::Telling(SceneDocument &document) : m_document(document)
{
    ++m_document.m_tellings;
}

SceneDocument::Telling::~Telling()
{
    if (--m_document.m_tellings == 0)
        m_document.tell({});
}

SceneDocument::SceneDocument(QObject *parent) : QObject(parent), m_points(*this)
{
    m_undoStack.setUndoLimit(200);
    const auto tellHistory = [this] { tell(Change::History); };
    connect(&m_undoStack, &QUndoStack::indexChanged, this, tellHistory);
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, tellHistory);
    connect(&m_casters, &RayCasters::built, this, [this] {
        m_rays.reset();
        if (answerRay())
            tell(Change::Ray);
    });
    m_state.objects = std::make_shared<const std::vector<SceneObject>>();
    m_state.landmarks = std::make_shared<const landmarks::LandmarkSet>();
    Scene empty;
    empty.projection = openingProjection();
    const Check opened = open(std::move(empty));
    Q_ASSERT(opened.hasValue());
    m_curves = std::make_unique<SceneCurves>(*this);
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
    if (m_untold & (Change::Objects | Change::Visibility)) {
        ++m_tellings; // what comes of it at once is told with the rest
        prepareRays();
        --m_tellings;
    }
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
    // In place, since a copy of the scene would copy all its objects and landmarks; and back again where that is no picture.
    const bool hasOtherObjects = state.objects != m_state.objects,
               hasOtherPoints = state.landmarks != m_state.landmarks;
    const auto put = [&](const SceneState &which) {
        landmarks::LandmarkSet points = std::move(m_scene.landmarks);
        static_cast<SceneSettings &>(m_scene) = which.settings;
        if (hasOtherPoints)
            points = *which.landmarks;
        m_scene.landmarks = std::move(points);
        if (hasOtherObjects)
            m_scene.objects = *which.objects;
    };
    put(state);
    const Box bounds = hasOtherObjects ? boundsOf(m_scene) : m_bounds;
    const Ground ground = hasOtherObjects ? groundUnder(bounds) : m_ground;
    const Result<Picture> picture = pictureOf(m_scene, m_surface, ground.box);
    Result<Unprojector> unprojector = picture ? Unprojector::of(*picture) : picture.error();
    if (!unprojector) {
        put(m_state);
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
    if (hasOtherPoints && *m_state.landmarks != *state.landmarks) {
        changes |= Change::Landmarks;
        if (m_points.follow(m_state.landmarks->landmarks, state.landmarks->landmarks))
            changes |= Change::LandmarkSelection;
    }
    m_unprojector = unprojector.value();
    m_rays.reset();
    m_bounds = bounds;
    m_ground = ground;
    m_state = state;
    m_state.settings.projection = m_scene.projection;
    return changes;
}

Check SceneDocument::open(Scene scene)
{
    const Telling telling(*this);
    auto objects = std::make_shared<const std::vector<SceneObject>>(std::move(scene.objects));
    auto points = std::make_shared<const landmarks::LandmarkSet>(std::exchange(scene.landmarks, {}));
    const Result<Changes> taken = take({std::move(scene), std::move(objects), std::move(points), m_lastEdit + 1});
    if (!taken)
        return taken.error();
    m_savedEdit = ++m_lastEdit;
    m_undoStack.clear();
    clearPick();
    m_points.forget();
    emit opened();
    tell(kSeen | Change::Pick | Change::GivenPoint | Change::Conventions | Change::Landmarks | Change::LandmarkSelection
         | Change::History);
    return std::monostate{};
}

void SceneDocument::setObjects(std::vector<SceneObject> objects, const LookAt &home)
{
    Scene scene;
    scene.camera = scene.home = home;
    scene.projection = openingProjection();
    scene.objects = std::move(objects);
    const Check opened = open(std::move(scene));
    Q_ASSERT(opened.hasValue());
}

void SceneDocument::setObjects(std::vector<SceneObject> objects)
{
    const LookAt camera = openingCamera(objects, m_surface);
    setObjects(std::move(objects), camera);
}

Check SceneDocument::record(SceneState state, const Deed &deed)
{
    if (state.objects != m_state.objects) {
        state.landmarks = withObjects(state.landmarks, *m_state.objects, *state.objects);
        if (state.settings.givenPoint)
            state.settings.givenPoint = withObjects(*state.settings.givenPoint, *m_state.objects, *state.objects);
    }
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

QString SceneDocument::language()
{
    //: The name of this language's locale, such as zh_CN
    return tr("en");
}

void SceneDocument::retranslate()
{
    for (int i = 0; i < m_undoStack.count(); ++i) {
        // The stack gives its commands away as constant; these are ours.
        auto *change = const_cast<SceneChange *>(static_cast<const SceneChange *>(m_undoStack.command(i)));
        change->nameIn(language());
    }
    m_curves->retranslate();
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
    return record(with(std::move(objects)), deed);
}

SceneState SceneDocument::with(std::vector<SceneObject> objects) const
{
    return {m_state.settings, std::make_shared<const std::vector<SceneObject>>(std::move(objects)), m_state.landmarks,
            m_lastEdit + 1};
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

const MatrixProjection *SceneDocument::givenProjection() const
{
    return m_scene.given && m_scene.given->converted == m_scene.projection ? &m_scene.given->matrix : nullptr;
}

const glm::dmat4 *SceneDocument::givenView() const
{
    return m_scene.givenView && m_scene.givenView->converted == m_scene.camera ? &m_scene.givenView->eyeFromWorld
                                                                               : nullptr;
}

Check SceneDocument::editMatrices(const std::optional<MatrixProjection> &projection,
                                  const std::optional<glm::dmat4> &eyeFromWorld, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    Picture picture = geometry();
    picture.depthRange = settings.depthRange;
    if (projection) {
        // A reversed matrix has turned the depth range round, whatever became of the projection since; with it that goes.
        if (isReversed(settings.given))
            std::swap(picture.depthRange.atNear, picture.depthRange.atFar);
        picture.lens = *projection;
    }
    if (eyeFromWorld)
        picture.pose = *eyeFromWorld;
    const Result<Picture> shown = byParameters(picture);
    if (!shown)
        return shown.error();
    settings.depthRange = shown->depthRange;
    if (projection) {
        settings.projection = shown->projection();
        settings.given = {*projection, settings.projection};
        settings.projectionFollowsViewport = settings.clipDistancesFitObjects = false;
    }
    if (eyeFromWorld) {
        settings.camera = shown->camera();
        settings.givenView = {*eyeFromWorld, settings.camera};
    }
    return edit(std::move(settings), deed);
}

Check SceneDocument::editViewport(const ViewportRule &rule, const DepthRange &range, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    settings.viewport = rule;
    settings.depthRange = range;
    return editSettings(std::move(settings), deed);
}

Check SceneDocument::editSettings(SceneSettings settings, const Deed &deed)
{
    settings.landmarks = m_state.settings.landmarks; // the state has them elsewhere
    // A depth range that the user has set is not the one that a reversed matrix had turned round.
    if (settings.depthRange != m_state.settings.depthRange && settings.given == m_state.settings.given
        && isReversed(settings.given) && !givenProjection())
        settings.given.reset();
    return edit(std::move(settings), deed);
}

Check SceneDocument::editClipPlanes(std::vector<glm::dvec4> planes, std::vector<ClipPlaneOff> off, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    settings.clipPlanes = std::move(planes);
    settings.clipPlanesOff = std::move(off);
    return edit(std::move(settings), deed);
}

Check SceneDocument::editGivenPoint(std::optional<GivenPoint> point, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    settings.givenPoint = std::move(point);
    return edit(std::move(settings), deed);
}

Check SceneDocument::editConventions(Api conventions, const Deed &deed)
{
    SceneSettings settings = m_state.settings;
    settings.conventions = conventions;
    return edit(std::move(settings), deed);
}

Check SceneDocument::editLandmarks(std::vector<landmarks::Landmark> landmarks, const Deed &deed)
{
    landmarks::LandmarkSet set = landmarkSet();
    set.landmarks = std::move(landmarks);
    return editLandmarkSet(std::move(set), deed);
}

Check SceneDocument::editLandmarkSet(landmarks::LandmarkSet set, const Deed &deed)
{
    for (landmarks::Curve &curve : set.curves) {
        if (!curve.points.empty())
            curve.semilandmarks.clear(); // they follow from where the points are: curves()
    }
    SceneState state = m_state;
    state.landmarks = std::make_shared<const landmarks::LandmarkSet>(std::move(set));
    state.edit = m_lastEdit + 1;
    return record(std::move(state), deed);
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
    if (!objects().empty()) {
        showFramed(framed(geometry(), objects()), m_bounds);
        return;
    }
    Framing framing(geometry());
    Box bounds;
    for (const landmarks::Landmark &point : landmarks()) {
        if (point.isMissing() || point.isHidden)
            continue;
        framing.add(*point.world);
        bounds.add(point.world->coordinates());
    }
    showFramed(framing.picture(), bounds);
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
        settings.projection = openingProjection();
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

} // namespace unprojector::gui
