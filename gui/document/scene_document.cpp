#include "gui/document/scene_document.h"

#include "core/scene/given_matrices.h"
#include "gui/document/given_points.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/picks.h"
#include "gui/document/scene_curves.h"

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

namespace {

/// The semilandmarks of curves through landmarks are left out: they are computed again.
std::shared_ptr<const landmarks::LandmarkSet> sharedLandmarks(landmarks::LandmarkSet set)
{
    for (landmarks::Curve &curve : set.curves) {
        if (!curve.points.empty())
            curve.semilandmarks.clear();
    }
    return std::make_shared<const landmarks::LandmarkSet>(std::move(set));
}

} // namespace

SceneDocument::SceneDocument(QObject *parent)
    : QObject(parent), m_sceneLandmarks(*this, m_changes), m_picks(std::make_unique<Picks>(*this, m_changes))
{
    m_undoStack.setUndoLimit(200);
    const auto notifyHistory = [this] { m_changes.notify(Change::History); };
    connect(&m_undoStack, &QUndoStack::indexChanged, this, notifyHistory);
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, notifyHistory);
    connect(&m_changes, &ChangeNotifier::changed, this, &SceneDocument::changed);
    m_state.objects = std::make_shared<const std::vector<SceneObject>>();
    m_state.landmarks = std::make_shared<const landmarks::LandmarkSet>();
    Scene empty;
    empty.projection = openingProjection();
    const Check opened = open(std::move(empty));
    Q_ASSERT(opened.hasValue());
    m_curves = std::make_unique<SceneCurves>(*this, m_changes);
}

SceneDocument::~SceneDocument()
{
    m_undoStack.disconnect(this); // it emits signals in its destructor
}

Result<Changes> SceneDocument::take(const SceneState &state)
{
    // The scene is changed in place: objects and landmarks are copied only if they differ. If no
    // valid setup results, the change is reverted.
    const bool hasOtherObjects = state.objects != m_state.objects,
               hasOtherLandmarks = state.landmarks != m_state.landmarks;
    const auto put = [&](const SceneState &which) {
        static_cast<SceneSettings &>(m_scene) = which.settings;
        if (hasOtherLandmarks)
            m_scene.landmarks = *which.landmarks;
        if (hasOtherObjects)
            m_scene.objects = *which.objects;
    };
    put(state);
    SceneState taken = state;
    const Changes ofObjects = hasOtherObjects ? changesBetween(*m_state.objects, *state.objects) : Changes();
    Changes changes = ofObjects | changesBetween(m_state.settings, state.settings);
    const bool isFirst = !m_unprojector;
    const Surface surface = state.settings.windowSize.value_or(m_widgetSurface);
    if (changes || isFirst || surface != setup().surface) {
        const bool hasOtherBounds = isFirst || ofObjects & (Change::Objects | Change::Placement | Change::Visibility);
        const Box bounds = hasOtherBounds ? boundsOf(m_scene) : m_bounds;
        const Ground ground = hasOtherBounds ? groundUnder(bounds) : m_ground;
        const Result<Setup> next = setupOf(m_scene, surface, ground.box);
        if (!next) {
            put(m_state);
            return next.error();
        }
        const bool isOtherSetup = isFirst || *next != setup();
        if (isOtherSetup) {
            const Result<Unprojector> unprojector = Unprojector::of(*next);
            if (!unprojector) {
                put(m_state);
                return unprojector.error();
            }
            m_unprojector = *unprojector; // in place: references to the setup stay valid
        }
        // Values that follow the window are stored as computed, so that fields show the numbers in
        // use.
        m_scene.projection = taken.settings.projection = next->projection();
        changes = ofObjects | changesBetween(m_state.settings, m_scene);
        changes.setFlag(Change::Setup, isOtherSetup || changes.testFlag(Change::Setup));
        m_bounds = bounds;
        m_ground = ground;
    }
    if (hasOtherLandmarks && *m_state.landmarks != *state.landmarks)
        changes |=
            Change::Landmarks | m_sceneLandmarks.follow(m_state.landmarks->landmarks, state.landmarks->landmarks);
    m_state = taken;
    return changes | m_picks->follow(m_state.objects, changes);
}

Check SceneDocument::open(Scene scene)
{
    const ChangeNotifier::Batch batch(m_changes);
    auto objects = std::make_shared<const std::vector<SceneObject>>(std::move(scene.objects));
    auto landmarks = std::make_shared<const landmarks::LandmarkSet>(std::exchange(scene.landmarks, {}));
    const Result<Changes> taken = take({std::move(scene), std::move(objects), std::move(landmarks), m_lastEdit + 1});
    if (!taken)
        return taken.error();
    m_savedEdit = ++m_lastEdit;
    m_own.reset();
    m_undoStack.clear();
    emit opened();
    m_changes.notify(kVisibleChanges | Change::Pick | Change::GivenPoint | Change::Conventions | Change::Landmarks
                     | Change::LandmarkSelection | Change::History);
    return std::monostate{};
}

Check SceneDocument::commit(const SceneState &state, const EditLabel &label)
{
    const ChangeNotifier::Batch batch(m_changes);
    const SceneState before = m_state;
    const Result<Changes> taken = take(state);
    if (!taken)
        return taken.error();
    const bool isLook = state.edit == before.edit;
    if (isLook ? isSameLook(before.settings, m_state.settings) : !*taken) {
        static_cast<void>(take(before)); // it was valid a moment ago, and nothing was reported
        return std::monostate{};
    }
    m_changes.notify(*taken);
    m_lastEdit = std::max(m_lastEdit, state.edit);
    // The stack reports once it is at its new index.
    m_undoStack.push(new SceneChange(before, m_state, label, [this](const SceneState &restored) {
        m_changes.defer(takeOwn());
        const Result<Changes> changes = take(restored);
        Q_ASSERT(changes.hasValue());
        if (changes)
            m_changes.defer(*changes);
    }));
    return std::monostate{};
}

Check SceneDocument::edit(const EditLabel &label, const std::function<void(Scene &)> &change)
{
    endPreview(); // as when a model has been loaded meanwhile
    Scene next = m_scene;
    change(next);
    SceneState state = m_state;
    state.edit = m_lastEdit + 1;
    // States share equal parts.
    if (next.landmarks != m_scene.landmarks)
        state.landmarks = sharedLandmarks(std::move(next.landmarks));
    const bool hasOtherObjects = bool(changesBetween(m_scene.objects, next.objects));
    if (hasOtherObjects)
        state.objects = std::make_shared<const std::vector<SceneObject>>(std::move(next.objects));
    state.settings = afterChange(m_scene, std::move(next));
    if (hasOtherObjects) {
        state.landmarks = withObjects(state.landmarks, *m_state.objects, *state.objects);
        if (state.settings.givenPoint)
            state.settings.givenPoint = withObjects(*state.settings.givenPoint, *m_state.objects, *state.objects);
    }
    return commit(state, label);
}

void SceneDocument::look(const EditLabel &label, const std::function<void(SceneSettings &)> &change)
{
    endPreview();
    SceneState state = m_state;
    change(state.settings);
    // A step without a valid setup (such as a zoom past the smallest number) is skipped.
    static_cast<void>(commit(state, label));
}

Check SceneDocument::preview(const SceneSettings &settings)
{
    SceneState state = m_state;
    state.settings = settings;
    const Own own = m_own.value_or(Own{m_state.settings, setup()});
    const Result<Changes> taken = take(state);
    if (!taken)
        return taken.error();
    m_own = own;
    m_changes.notify(Change::Preview);
    return std::monostate{};
}

void SceneDocument::endPreview()
{
    if (m_own)
        m_changes.notify(takeOwn());
}

Changes SceneDocument::takeOwn()
{
    if (!m_own)
        return {};
    const Own own = *std::exchange(m_own, std::nullopt);
    SceneState state = m_state;
    state.settings = own.settings;
    const Result<Changes> taken = take(state);
    Q_ASSERT(taken.hasValue());
    Changes changes = Change::Preview;
    changes.setFlag(Change::Setup, setup() != own.setup); // as when the window has another size
    return changes;
}

Scene SceneDocument::ownScene() const
{
    Scene own = m_scene;
    if (m_own)
        static_cast<SceneSettings &>(own) = m_own->settings;
    return own;
}

Setup SceneDocument::ownSetup() const
{
    if (!m_own)
        return setup();
    const Result<Setup> own = setupOf(ownScene(), m_own->settings.windowSize.value_or(m_widgetSurface), m_ground.box);
    return own ? *own : m_own->setup;
}

void SceneDocument::restoreLandmarks(landmarks::LandmarkSet set)
{
    m_changes.defer(takeOwn());
    SceneState state = m_state;
    state.edit = ++m_lastEdit;
    state.landmarks = sharedLandmarks(std::move(set));
    const Result<Changes> changes = take(state);
    Q_ASSERT(changes.hasValue()); // landmarks cannot make a setup invalid
    if (changes)
        m_changes.defer(*changes);
}

void SceneDocument::markSaved()
{
    const ChangeNotifier::Batch batch(m_changes);
    m_savedEdit = m_state.edit;
    m_undoStack.setClean();
    m_changes.notify(Change::History);
}

void SceneDocument::markUnsaved()
{
    const ChangeNotifier::Batch batch(m_changes);
    m_savedEdit.reset();
    m_undoStack.resetClean();
    m_changes.notify(Change::History);
}

void SceneDocument::setSurface(const Surface &surface)
{
    if (surface == m_widgetSurface)
        return;
    const Surface before = std::exchange(m_widgetSurface, surface);
    const Result<Changes> taken = take(m_state);
    if (!taken)
        m_widgetSurface = before;
    else
        m_changes.notify(m_own ? Change::Preview : *taken);
}

Check SceneDocument::drawAt(const Surface &surface, const std::function<void()> &draw)
{
    const Result<Setup> setup = setupOf(m_scene, surface, m_ground.box);
    if (!setup)
        return setup.error();
    const Result<Unprojector> other = Unprojector::of(*setup);
    if (!other)
        return other.error();
    const Unprojector own = *std::exchange(m_unprojector, *other);
    m_picks->forgetRays();
    draw();
    m_unprojector = own;
    m_picks->forgetRays();
    return std::monostate{};
}

} // namespace unprojector::gui
