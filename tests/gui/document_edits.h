#pragma once

#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"

#include <optional>
#include <utility>
#include <vector>

/// Edits of single settings, as the window's panels make them, and picks, as clicks in the view make them.
namespace unprojector::gui {

/// A projection, and what of it follows something else.
struct ProjectionRule {
    Projection projection;
    bool followsViewport = true; ///< its proportions
    bool fitsObjects = true;     ///< its near and far planes
};

inline Check editTransform(SceneDocument &document, std::size_t index, std::vector<TransformStep> steps,
                           const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) { scene.objects[index].transform = std::move(steps); });
}

inline Check editCamera(SceneDocument &document, const LookAt &camera, const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) { scene.camera = camera; });
}

inline Check editProjection(SceneDocument &document, const ProjectionRule &rule, const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) {
        scene.projection = rule.projection;
        scene.projectionFollowsViewport = rule.followsViewport;
        scene.clipDistancesFitObjects = rule.fitsObjects;
    });
}

inline Check editSettings(SceneDocument &document, const SceneSettings &settings, const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) { static_cast<SceneSettings &>(scene) = settings; });
}

inline Check editViewport(SceneDocument &document, const ViewportRule &rule, const DepthRange &range,
                          const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) {
        scene.viewport = rule;
        scene.depthRange = range;
    });
}

inline Check editClipPlanes(SceneDocument &document, std::vector<glm::dvec4> planes, std::vector<ClipPlaneOff> off,
                            const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) {
        scene.clipPlanes = std::move(planes);
        scene.clipPlanesOff = std::move(off);
    });
}

inline Check editGivenPoint(SceneDocument &document, std::optional<GivenPoint> point, const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) { scene.givenPoint = std::move(point); });
}

inline Check editConventions(SceneDocument &document, Api conventions, const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) { scene.conventions = conventions; });
}

/// Picks the pixel that a position lies in.
inline void pickAt(SceneDocument &document, const WidgetPoint &position, const DepthSample &sample)
{
    const Result<DevicePixel> pixel = devicePixelFromWidget(document.picture().surface, position);
    document.picks().setPick(pixel ? document.picks().unprojected({position, *pixel, sample}) : pixel.error());
}

} // namespace unprojector::gui
