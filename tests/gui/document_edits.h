#pragma once

#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"

#include <optional>
#include <utility>
#include <vector>

/// Edits of single settings, as the window's panels make them, and picks, as clicks in the view
/// make them.
namespace unprojector::gui {

/// A projection, and the rules for its dependent parts.
struct ProjectionRule {
    geometry::Projection projection;
    bool followsViewport = true; ///< its proportions
    bool fitsObjects = true;     ///< its near and far planes
};

inline geometry::Check editTransform(SceneDocument &document, std::size_t index,
                                     std::vector<geometry::TransformStep> steps, const EditLabel &label)
{
    return document.edit(label, [&](scene::Scene &scene) { scene.objects[index].transform = std::move(steps); });
}

inline geometry::Check editCamera(SceneDocument &document, const geometry::LookAt &camera, const EditLabel &label)
{
    return document.edit(label, [&](scene::Scene &scene) { scene.camera = camera; });
}

inline geometry::Check editProjection(SceneDocument &document, const ProjectionRule &rule, const EditLabel &label)
{
    return document.edit(label, [&](scene::Scene &scene) {
        scene.projection = rule.projection;
        scene.projectionFollowsViewport = rule.followsViewport;
        scene.clipDistancesFitObjects = rule.fitsObjects;
    });
}

inline geometry::Check editSettings(SceneDocument &document, const scene::SceneSettings &settings,
                                    const EditLabel &label)
{
    return document.edit(label, [&](scene::Scene &scene) { static_cast<scene::SceneSettings &>(scene) = settings; });
}

inline geometry::Check editViewport(SceneDocument &document, const scene::ViewportRule &rule,
                                    const geometry::DepthRange &range, const EditLabel &label)
{
    return document.edit(label, [&](scene::Scene &scene) {
        scene.viewport = rule;
        scene.depthRange = range;
    });
}

inline geometry::Check editClipPlanes(SceneDocument &document, std::vector<glm::dvec4> planes,
                                      std::vector<scene::ClipPlaneOff> off, const EditLabel &label)
{
    return document.edit(label, [&](scene::Scene &scene) {
        scene.clipPlanes = std::move(planes);
        scene.clipPlanesOff = std::move(off);
    });
}

inline geometry::Check editGivenPoint(SceneDocument &document, std::optional<geometry::GivenPoint> point,
                                      const EditLabel &label)
{
    return document.edit(label, [&](scene::Scene &scene) { scene.givenPoint = std::move(point); });
}

inline geometry::Check editConventions(SceneDocument &document, geometry::Api conventions, const EditLabel &label)
{
    return document.edit(label, [&](scene::Scene &scene) { scene.conventions = conventions; });
}

/// Picks the pixel that a position lies in.
inline void pickAt(SceneDocument &document, const geometry::WidgetPoint &position, const unproject::DepthSample &sample)
{
    const geometry::Result<geometry::DevicePixel> pixel = devicePixelFromWidget(document.setup().surface, position);
    document.picks().setPick(pixel ? document.picks().unprojected({position, *pixel, sample}) : pixel.error());
}

} // namespace unprojector::gui
