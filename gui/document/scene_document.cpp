#include "gui/document/scene_document.h"

#include "gui/document/scene_change.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr double kFovyRadians = 0.7853981633974483; // 45 degrees

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

/// The aspect follows the window.
Projection initialProjection()
{
    return Perspective{kFovyRadians, 1.0, 0.1, 100.0};
}

} // namespace

SceneDocument::SceneDocument(QObject *parent) : QObject(parent)
{
    m_undoStack.setUndoLimit(200);
    connect(&m_undoStack, &QUndoStack::indexChanged, this, &SceneDocument::stateChanged);
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, &SceneDocument::stateChanged);
    m_scene.projection = initialProjection();
    const Check opened = open(m_scene);
    Q_ASSERT(opened.hasValue());
}

Check SceneDocument::apply(Scene scene)
{
    const Box bounds = m_bounds, ground = m_ground;
    const double spacing = m_groundSpacing;
    m_bounds = boundsOf(scene);
    updateGround();
    const Result<Picture> picture = pictureOf(scene, m_surface, m_ground);
    Result<Unprojector> unprojector = picture ? Unprojector::of(*picture) : picture.error();
    if (!unprojector) {
        m_bounds = bounds;
        m_ground = ground;
        m_groundSpacing = spacing;
        return unprojector.error();
    }
    m_unprojector = std::move(unprojector).value();
    m_scene = std::move(scene);
    // What follows the window is kept as it came out, so that fields show the numbers in use.
    m_scene.projection = geometry().projection();
    emit geometryChanged();
    return std::monostate{};
}

Check SceneDocument::open(Scene scene)
{
    if (const Result<Picture> geometry = pictureOf(scene, m_surface, {}); !geometry)
        return geometry.error();
    m_savedEdit = m_edit = ++m_lastEdit;
    m_undoStack.clear();
    const bool hadPick = m_pick.has_value();
    m_pick.reset();
    const Check applied = apply(std::move(scene));
    emit objectsChanged();
    if (hadPick)
        emit pickChanged();
    return applied;
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
    const LookAt camera = framed(home, boundsOf(scene)).camera();
    setObjects(std::move(scene.objects), camera);
}

Check SceneDocument::change(Scene scene, const QString &text, const QString &mergeKey)
{
    return record(std::move(scene), m_lastEdit + 1, text, mergeKey);
}

Check SceneDocument::look(Scene scene, const QString &text, const QString &mergeKey)
{
    return record(std::move(scene), m_edit, text, mergeKey);
}

Check SceneDocument::record(Scene scene, std::uint64_t edit, const QString &text, const QString &mergeKey)
{
    SceneState before{m_scene, m_edit};
    SceneState after{std::move(scene), edit};
    if (const Check restored = restore(after); !restored)
        return restored;
    m_lastEdit = std::max(m_lastEdit, edit);
    m_undoStack.push(new SceneChange(*this, std::move(before), std::move(after), text, mergeKey));
    return std::monostate{};
}

Check SceneDocument::restore(const SceneState &state)
{
    const Check applied = apply(state.scene);
    if (applied)
        m_edit = state.edit;
    return applied;
}

void SceneDocument::markSaved()
{
    m_savedEdit = m_edit;
    m_undoStack.setClean();
    emit stateChanged();
}

void SceneDocument::markUnsaved()
{
    m_savedEdit.reset();
    m_undoStack.resetClean();
    emit stateChanged();
}

void SceneDocument::updateGround()
{
    m_ground = {};
    if (m_bounds.isEmpty())
        return;
    const double size = m_bounds.diagonal() > 0.0 ? m_bounds.diagonal() : 1.0;
    m_groundSpacing = roundedUp(size / 15.0);
    // Lines at whole multiples of the spacing, so that they can be read as coordinates.
    const auto snapped = [this](double value, double direction) {
        return (std::floor(value / m_groundSpacing) + direction) * m_groundSpacing;
    };
    const double margin = size * 0.5;
    const double y = m_bounds.lowest.y;
    m_ground.add({snapped(m_bounds.lowest.x - margin, 0.0), y, snapped(m_bounds.lowest.z - margin, 0.0)});
    m_ground.add({snapped(m_bounds.highest.x + margin, 1.0), y, snapped(m_bounds.highest.z + margin, 1.0)});
}

void SceneDocument::setSurface(const Surface &surface)
{
    if (surface == m_surface)
        return;
    const Surface before = std::exchange(m_surface, surface);
    if (!apply(m_scene))
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
    Scene scene = m_scene;
    scene.camera = camera;
    scene.projection = projection;
    // A step that would leave no valid picture (a zoom past the smallest number, say) is not taken.
    static_cast<void>(look(std::move(scene), tr("Camera"), mergeKey));
}

void SceneDocument::fit()
{
    const Picture fitted = framed(geometry(), m_bounds);
    setView(fitted.camera(), fitted.projection());
}

void SceneDocument::goHome()
{
    Scene scene = m_scene;
    scene.camera = scene.home;
    if (scene.projectionFollowsViewport)
        scene.projection = initialProjection();
    static_cast<void>(look(std::move(scene), tr("Home")));
}

double SceneDocument::pivotDistance() const
{
    const Result<EyeFrame> frame = eyeFrame(m_scene.camera);
    if (frame && m_pick && m_pick->hit && m_pick->point.world[Method::Formula]) {
        const double distance = -eyeFromWorld(*frame, *m_pick->point.world[Method::Formula]).z;
        if (distance > 0.0)
            return distance;
    }
    const glm::dvec3 toCenter = m_scene.camera.center - m_scene.camera.eye;
    return glm::length(toCenter);
}

void SceneDocument::switchProjection()
{
    const bool perspective = isPerspective(m_scene.projection);
    Scene scene = m_scene;
    scene.projection =
        converted(scene.projection, perspective ? ProjectionKind::Ortho : ProjectionKind::Perspective, pivotDistance());
    static_cast<void>(look(std::move(scene), perspective ? tr("Orthographic") : tr("Perspective")));
}

Result<Pick> SceneDocument::unprojected(const WidgetPoint &position, const DepthSample &sample) const
{
    return unproject::pickAt(*m_unprojector, position, sample);
}

void SceneDocument::pickAt(const WidgetPoint &position, const DepthSample &sample)
{
    Result<Pick> pick = unprojected(position, sample);
    if (!pick) {
        emit pickFailed(pick.error());
        return;
    }
    m_pick.emplace(std::move(pick).value());
    emit pickChanged();
}

void SceneDocument::clearPick()
{
    if (!m_pick)
        return;
    m_pick.reset();
    emit pickChanged();
}

WorldPoint SceneDocument::pivotAt(const WidgetPoint &position, const DepthSample &sample) const
{
    const LookAt &camera = geometry().camera();
    const Result<Pick> pick = unprojected(position, sample);
    if (!pick)
        return camera.center;
    if (pick->hit)
        return *pick->point.world[Method::Formula];
    const Result<WorldPoint> &enter = pick->rayNear.world[Method::Formula];
    const Result<WorldPoint> &leave = pick->rayFar.world[Method::Formula];
    const Result<EyeFrame> frame = eyeFrame(camera);
    if (!enter || !leave || !frame)
        return camera.center;
    const double wanted = eyeFromWorld(*frame, camera.center).z;
    const double zEnter = eyeFromWorld(*frame, *enter).z;
    const double zLeave = eyeFromWorld(*frame, *leave).z;
    const double t = (wanted - zEnter) / (zLeave - zEnter);
    return WorldPoint(enter->coordinates() + t * (leave->coordinates() - enter->coordinates()));
}

} // namespace unprojector::gui
