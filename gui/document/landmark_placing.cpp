#include "gui/document/landmark_placing.h"

#include "core/ray/placed_landmark.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

namespace {

using landmarks::Landmark;

std::optional<Landmark> landmarkMet(const SceneDocument &document, const DevicePoint &position, ray::Snap snap,
                                    double pixels)
{
    const ray::SceneRays *rays = document.picks().rays();
    if (!rays)
        return std::nullopt;
    const Result<std::optional<ray::SceneHit>> hit = rays->at(position, snap);
    if (!hit || !*hit)
        return std::nullopt;
    const std::vector<SceneObject> &objects = document.objects();
    Landmark landmark = ray::landmarkAt(**hit, snap, *rays, position, objects[(*hit)->object].name, pixels);
    if (!std::holds_alternative<landmarks::AtVertex>(landmark.anchor)) {
        if (const auto edge = ray::edgeInPixel(*rays, position, *hit, pixels))
            ray::addEdge(landmark, *edge, edge->object ? objects[*edge->object].name : std::string());
    }
    return landmark;
}

/// The formula's point of a pick, without an anchor.
/// @return nothing for the background
std::optional<Landmark> landmarkOf(const Pick &pick, const std::vector<SceneObject> &objects)
{
    const Result<WorldPoint> &world = pick.point.world[Method::Formula];
    if (!pick.hit() || !world)
        return std::nullopt;
    Landmark landmark;
    landmark.world = *world;
    landmark.uncertainty = pick.withinPixel.world;
    if (*pick.object < objects.size())
        landmark.object = objects[*pick.object].name;
    return landmark;
}

} // namespace

std::optional<Landmark> landmarkOnMesh(const SceneDocument &document, const DevicePoint &position, double pixels)
{
    return landmarkMet(document, position, document.picks().snap(), pixels);
}

std::optional<Landmark> landmarkOnSurface(const SceneDocument &document, const DevicePoint &position, double pixels)
{
    return landmarkMet(document, position, ray::Snap::Surface, pixels);
}

std::optional<Landmark> landmarkOfClick(const SceneDocument &document, const WidgetPoint &position,
                                        const std::optional<DepthSample> &sample)
{
    const Result<DevicePixel> pixel = devicePixelFromWidget(document.setup().surface, position);
    if (!pixel)
        return std::nullopt;
    if (std::optional<Landmark> met = landmarkOnMesh(document, pixelCenter(*pixel)))
        return met;
    if (!sample)
        return std::nullopt;
    const Result<Pick> pick = document.picks().unprojected({position, *pixel, *sample});
    return pick ? landmarkOf(*pick, document.objects()) : std::nullopt;
}

} // namespace unprojector::gui
