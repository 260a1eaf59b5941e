#include "gui/document/picks.h"

#include "core/ray/drawn_surface.h"
#include "gui/document/scene_document.h"

#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

Picks::Picks(const SceneDocument &document, ChangeNotifier &changes) : m_document(document), m_changes(changes)
{
    connect(&document, &SceneDocument::opened, this, &Picks::clearPick);
    connect(&changes, &ChangeNotifier::changing, this, [this](Changes changing) {
        if (changing & (Change::Objects | Change::Visibility))
            prepareRays();
    });
    connect(&m_casters, &RayCasters::built, this, [this] {
        m_rays.reset();
        if (askRay())
            m_changes.notify(Change::Ray);
    });
}

SinceClick Picks::sinceClick() const
{
    return gui::sinceClick(m_picked, m_document.scene(), m_document.setup());
}

Result<Pick> Picks::unprojected(const PixelClick &click) const
{
    const std::vector<SceneObject> &objects = m_document.objects();
    unproject::SurfaceAt surfaceAt;
    if (const auto object = click.sample.object; object && *object < objects.size())
        surfaceAt = [&drawn = objects[*object]](const WorldPoint &world) { return ray::drawnSurface(drawn, world); };
    return unproject::pickAt(m_document.unprojector(), click, surfaceAt);
}

void Picks::setPick(const Result<Pick> &pick)
{
    if (!pick) {
        emit failed(pick.error());
        return;
    }
    KeptPick kept{*pick, placementOf(*pick, *m_objects), {}, RayScene{m_objects, m_document.scene().clipPlanes}};
    kept.ray.snap = m_snap;
    kept.click = ++m_clicks;
    show(std::move(kept));
}

void Picks::putBack(KeptPick kept)
{
    emit takenBack();
    show(std::move(kept));
}

void Picks::show(KeptPick kept)
{
    m_lost.reset();
    if (!m_picked.pick && !kept.pick)
        return;
    m_picked = std::move(kept);
    askRay();
    m_changes.notify(Change::Pick);
}

void Picks::setSnap(ray::Snap snap)
{
    if (std::exchange(m_snap, snap) != snap)
        m_changes.notify(Change::Snap);
}

void Picks::markWrongPoints(std::vector<WrongPointMark> points)
{
    if (std::exchange(m_wrongPoints, std::move(points)) != m_wrongPoints)
        m_changes.notify(Change::WrongPoints);
}

Changes Picks::follow(const ObjectList &objects, Changes changes)
{
    const ObjectList before = std::exchange(m_objects, objects);
    if (changes & kVisibleChanges)
        m_rays.reset();
    if (!changes.testFlag(Change::Objects))
        return {};
    if (m_picked.pick) {
        KeptPick now = m_picked;
        if (!gui::follow(now, *before, *objects))
            return {};
        if (m_picked.pick->hit() && !now.pick->hit())
            m_lost = Lost{std::exchange(m_picked, {}), before};
        else
            m_picked = std::move(now);
        return Change::Pick;
    }
    if (m_lost) {
        KeptPick again = m_lost->kept;
        gui::follow(again, *m_lost->objects, *objects);
        if (again.pick->hit()) {
            m_picked = std::move(again);
            m_lost.reset();
            return Change::Pick;
        }
    }
    return {};
}

const ray::SceneRays *Picks::rays() const
{
    if (!m_rays) {
        if (const auto casters = m_casters.of(*m_objects))
            m_rays.emplace(m_document.unprojector(), *m_objects, *casters, m_document.scene().clipPlanes);
    }
    return m_rays ? &*m_rays : nullptr;
}

void Picks::prepareRays()
{
    std::vector<SceneObject> all = *m_objects;
    if (m_picked.rayScene)
        all.insert(all.end(), m_picked.rayScene->objects->begin(), m_picked.rayScene->objects->end());
    m_casters.prepare(all);
    if (askRay())
        m_changes.notify(Change::Ray);
}

bool Picks::askRay()
{
    if (!m_picked.pick || !m_picked.rayScene)
        return false;
    const auto &[objects, clipPlanes] = *m_picked.rayScene;
    PickedRay &ray = m_picked.ray;
    const auto casters = m_casters.of(*objects);
    if (!casters) {
        ray.failure = m_casters.failureOf(*objects);
        const auto state = ray.failure ? PickedRay::State::Impossible : PickedRay::State::Preparing;
        return std::exchange(ray.state, state) != state;
    }
    ray.failure.reset();
    ray.state = PickedRay::State::Impossible;
    // The view's own Unprojector and rays can answer while it shows the clicked setup.
    const Setup &clicked = m_picked.pick->setup;
    const bool isSetupCurrent = clicked == m_document.setup();
    const bool isSceneShown = objects == m_objects && clipPlanes == m_document.scene().clipPlanes;
    const ray::SceneRays *shown = isSetupCurrent && isSceneShown ? rays() : nullptr;
    if (shown)
        answerRay(m_picked, m_document.unprojector(), *shown, *m_objects);
    else if (const Result<Unprojector> former = isSetupCurrent ? m_document.unprojector() : Unprojector::of(clicked))
        answerRay(m_picked, *former, {*former, *objects, *casters, clipPlanes}, *m_objects);
    m_picked.rayScene.reset();
    return true;
}

} // namespace unprojector::gui
