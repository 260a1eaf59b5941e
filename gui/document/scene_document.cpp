#include "gui/document/scene_document.h"

#include "core/scene/given_matrices.h"
#include "core/scene/opening_view.h"
#include "gui/document/given_points.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/scene_curves.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace unprojector::gui {
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

Result<Changes> SceneDocument::take(const SceneState &state)
{
    // The scene is changed in place: objects and landmarks are copied only where they differ. Where no picture results, it is
    // changed back.
    const bool hasOtherObjects = state.objects != m_state.objects,
               hasOtherPoints = state.landmarks != m_state.landmarks;
    const auto put = [&](const SceneState &which) {
        static_cast<SceneSettings &>(m_scene) = which.settings;
        if (hasOtherPoints)
            m_scene.landmarks = *which.landmarks;
        if (hasOtherObjects)
            m_scene.objects = *which.objects;
    };
    put(state);
    Changes changes = changesBetween(m_state.settings, state.settings);
    SceneState taken = state;
    // What only landmarks say leaves the picture as it is, and what is prepared for its rays.
    if (changes || hasOtherObjects || !m_unprojector || m_surface != geometry().surface) {
        const Box bounds = hasOtherObjects ? boundsOf(m_scene) : m_bounds;
        const Ground ground = hasOtherObjects ? groundUnder(bounds) : m_ground;
        const Result<Picture> picture = pictureOf(m_scene, m_surface, ground.box);
        Result<Unprojector> unprojector = picture ? Unprojector::of(*picture) : picture.error();
        if (!unprojector) {
            put(m_state);
            return unprojector.error();
        }
        // What follows the window is kept as it came out, so that fields show the numbers in use.
        m_scene.projection = taken.settings.projection = picture->projection();
        changes = changesBetween(m_state.settings, m_scene);
        if (!m_unprojector || picture->surface != geometry().surface || picture->viewport != geometry().viewport)
            changes |= Change::Picture;
        m_unprojector = unprojector.value();
        m_rays.reset();
        m_bounds = bounds;
        m_ground = ground;
    }
    if (hasOtherObjects)
        changes |= changesBetween(*m_state.objects, m_scene.objects);
    if (changes.testFlag(Change::Objects) && followObjects(m_state.objects))
        changes |= Change::Pick;
    if (hasOtherPoints && *m_state.landmarks != *state.landmarks) {
        changes |= Change::Landmarks;
        if (m_points.follow(m_state.landmarks->landmarks, state.landmarks->landmarks))
            changes |= Change::LandmarkSelection;
    }
    m_state = taken;
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

void SceneDocument::restore(const SceneState &state)
{
    const Result<Changes> taken = take(state);
    Q_ASSERT(taken.hasValue());
    if (taken)
        m_untold |= *taken;
}

Check SceneDocument::edit(const Deed &deed, const std::function<void(Scene &)> &change)
{
    Scene next = m_scene;
    change(next);
    SceneState state = m_state;
    state.edit = m_lastEdit + 1;
    // States share what is the same in both.
    if (changesBetween(m_scene.objects, next.objects))
        state.objects = std::make_shared<const std::vector<SceneObject>>(std::move(next.objects));
    if (next.landmarks != m_scene.landmarks) {
        for (landmarks::Curve &curve : next.landmarks.curves) {
            if (!curve.points.empty())
                curve.semilandmarks.clear();
        }
        state.landmarks = std::make_shared<const landmarks::LandmarkSet>(std::move(next.landmarks));
    }
    state.settings = afterChange(m_scene, std::move(next));
    return record(std::move(state), deed);
}

void SceneDocument::look(const Deed &deed, const std::function<void(SceneSettings &)> &change)
{
    const Telling telling(*this);
    const SceneState before = m_state;
    SceneState state = m_state;
    change(state.settings);
    // A step that would leave no valid picture (a zoom past the smallest number, say) is not taken.
    const Result<Changes> taken = take(state);
    if (!taken)
        return;
    if (isSameLook(before.settings, m_state.settings)) {
        static_cast<void>(take(before)); // it was there a moment ago, and nobody has heard of anything else
        return;
    }
    tell(*taken);
    m_undoStack.push(new SceneChange(*this, before, m_state, deed.text, deed.mergeKey));
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

} // namespace unprojector::gui
