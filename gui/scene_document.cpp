#include "gui/scene_document.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace unprojector {
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

/// The frustum of gluPerspective with the aspect of a square; the surface's aspect follows with its size.
Projection initialProjection()
{
    return frustumFromPerspective({kFovyRadians, 1.0, 0.1, 100.0});
}

} // namespace

SceneDocument::SceneDocument(QObject *parent) : QObject(parent)
{
    m_geometry.surface = {1, 1, 1.0};
    m_geometry.viewport = wholeSurface(m_geometry.surface);
    m_geometry.projection = initialProjection();
}

void SceneDocument::setObjects(std::vector<SceneObject> objects, const LookAt &home)
{
    m_objects = std::move(objects);
    m_home = home;
    updateBounds();
    const bool hadPick = m_pick.has_value();
    m_pick.reset();
    emit objectsChanged();
    goHome();
    if (hadPick)
        emit pickChanged();
}

void SceneDocument::setObjects(std::vector<SceneObject> objects)
{
    m_objects = std::move(objects);
    updateBounds();
    // Scans face +z as a rule; a little from above and the side shows that they have depth.
    ViewGeometry home = m_geometry;
    home.projection = withAspect(initialProjection(), m_geometry.viewport.width / m_geometry.viewport.height);
    home.camera = {WorldPoint(0.35, 0.25, 1.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}};
    const LookAt camera = framed(home, m_bounds).camera;
    setObjects(std::move(m_objects), camera);
}

void SceneDocument::updateBounds()
{
    m_bounds = {};
    for (const SceneObject &object : m_objects)
        m_bounds.add(object.model->bounds.transformed(object.worldFromObject));
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

void SceneDocument::applyView(ViewGeometry geometry)
{
    geometry.projection = withFittedClipDistances(geometry, m_bounds, m_ground);
    // A step that would leave no valid geometry (a zoom past the smallest number, say) is not taken.
    if (!check(geometry))
        return;
    m_geometry = std::move(geometry);
    emit geometryChanged();
}

void SceneDocument::setSurface(const Surface &surface)
{
    if (surface == m_geometry.surface || !check(surface))
        return;
    m_geometry.surface = surface;
    m_geometry.viewport = wholeSurface(surface);
    m_geometry.projection = withAspect(m_geometry.projection, m_geometry.viewport.width / m_geometry.viewport.height);
    emit geometryChanged();
}

void SceneDocument::setCamera(const LookAt &camera)
{
    setView(camera, m_geometry.projection);
}

void SceneDocument::setProjection(const Projection &projection)
{
    setView(m_geometry.camera, projection);
}

void SceneDocument::setView(const LookAt &camera, const Projection &projection)
{
    ViewGeometry geometry = m_geometry;
    geometry.camera = camera;
    geometry.projection = projection;
    applyView(std::move(geometry));
}

void SceneDocument::fit()
{
    applyView(framed(m_geometry, m_bounds));
}

void SceneDocument::goHome()
{
    ViewGeometry geometry = m_geometry;
    geometry.camera = m_home;
    geometry.projection = withAspect(initialProjection(), geometry.viewport.width / geometry.viewport.height);
    applyView(std::move(geometry));
}

void SceneDocument::switchProjection()
{
    applyView(withProjectionSwitched(m_geometry));
}

Result<Pick> SceneDocument::unprojected(const WidgetPoint &position, const DepthSample &sample) const
{
    return unprojector::pickAt(m_geometry, position, sample);
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
    const LookAt &camera = m_geometry.camera;
    const Result<Pick> pick = unprojected(position, sample);
    if (!pick)
        return camera.center;
    if (pick->hit)
        return *pick->point.world.formula;
    const Result<WorldPoint> &enter = pick->rayNear.world.formula;
    const Result<WorldPoint> &leave = pick->rayFar.world.formula;
    const Result<EyeFrame> frame = eyeFrame(camera);
    if (!enter || !leave || !frame)
        return camera.center;
    const double wanted = eyeFromWorld(*frame, camera.center).z;
    const double zEnter = eyeFromWorld(*frame, *enter).z;
    const double zLeave = eyeFromWorld(*frame, *leave).z;
    const double t = (wanted - zEnter) / (zLeave - zEnter);
    return WorldPoint(enter->coordinates() + t * (leave->coordinates() - enter->coordinates()));
}

} // namespace unprojector
