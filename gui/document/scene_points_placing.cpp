// Where points come to be when they are placed.

#include "gui/document/scene_points.h"

#include "core/ray/placed_landmark.h"
#include "gui/document/scene_document.h"

namespace unprojector::gui {

using landmarks::Landmark;

std::optional<Landmark> ScenePoints::metAt(const DevicePoint &position, ray::Snap snap, double pixels) const
{
    const ray::SceneRays *rays = m_document.rays();
    if (!rays)
        return std::nullopt;
    const Result<std::optional<ray::SceneHit>> hit = rays->at(position, snap);
    if (!hit || !*hit)
        return std::nullopt;
    return ray::landmarkAt(**hit, snap, *rays, position, m_document.objects()[(*hit)->object].name, pixels);
}

std::optional<Landmark> ScenePoints::onMeshAt(const DevicePoint &position, double pixels) const
{
    return metAt(position, m_document.snap(), pixels);
}

std::optional<Landmark> ScenePoints::onSurfaceAt(const DevicePoint &position, double pixels) const
{
    return metAt(position, ray::Snap::Surface, pixels);
}

std::optional<Landmark> ScenePoints::of(const Pick &pick) const
{
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    if (!pick.hit() || !world)
        return std::nullopt;
    Landmark landmark;
    landmark.world = *world;
    landmark.uncertainty = pick.withinPixel.world;
    if (*pick.object < m_document.objects().size())
        landmark.object = m_document.objects()[*pick.object].name;
    return landmark;
}

std::optional<Landmark> ScenePoints::placedAt(const WidgetPoint &position,
                                              const std::optional<DepthSample> &sample) const
{
    const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.geometry().surface, position);
    if (!pixel)
        return std::nullopt;
    if (std::optional<Landmark> met = onMeshAt(pixelCenter(*pixel)))
        return met;
    if (!sample)
        return std::nullopt;
    const Result<Pick> pick = m_document.unprojected({position, *pixel, *sample});
    return pick ? of(*pick) : std::nullopt;
}

} // namespace unprojector::gui
