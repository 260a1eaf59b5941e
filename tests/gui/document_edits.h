#pragma once

#include "gui/document/scene_edits.h"

#include <optional>
#include <utility>
#include <vector>

/// Edits of single settings, as the window's panels make them.
namespace unprojector::gui {

/// A projection, and what of it follows something else.
struct ProjectionRule {
    Projection projection;
    bool followsViewport = true; ///< its proportions
    bool fitsObjects = true;     ///< its near and far planes
};

inline Check editTransform(SceneDocument &document, std::size_t index, std::vector<TransformStep> steps,
                           const Deed &deed)
{
    return document.edit(deed, [&](Scene &scene) { scene.objects[index].transform = std::move(steps); });
}

inline Check editCamera(SceneDocument &document, const LookAt &camera, const Deed &deed)
{
    return document.edit(deed, [&](Scene &scene) { scene.camera = camera; });
}

inline Check editProjection(SceneDocument &document, const ProjectionRule &rule, const Deed &deed)
{
    return document.edit(deed, [&](Scene &scene) {
        scene.projection = rule.projection;
        scene.projectionFollowsViewport = rule.followsViewport;
        scene.clipDistancesFitObjects = rule.fitsObjects;
    });
}

inline Check editSettings(SceneDocument &document, const SceneSettings &settings, const Deed &deed)
{
    return document.edit(deed, [&](Scene &scene) { static_cast<SceneSettings &>(scene) = settings; });
}

inline Check editViewport(SceneDocument &document, const ViewportRule &rule, const DepthRange &range, const Deed &deed)
{
    return document.edit(deed, [&](Scene &scene) {
        scene.viewport = rule;
        scene.depthRange = range;
    });
}

inline Check editClipPlanes(SceneDocument &document, std::vector<glm::dvec4> planes, std::vector<ClipPlaneOff> off,
                            const Deed &deed)
{
    return document.edit(deed, [&](Scene &scene) {
        scene.clipPlanes = std::move(planes);
        scene.clipPlanesOff = std::move(off);
    });
}

inline Check editGivenPoint(SceneDocument &document, std::optional<GivenPoint> point, const Deed &deed)
{
    return document.edit(deed, [&](Scene &scene) { scene.givenPoint = std::move(point); });
}

inline Check editConventions(SceneDocument &document, Api conventions, const Deed &deed)
{
    return document.edit(deed, [&](Scene &scene) { scene.conventions = conventions; });
}

} // namespace unprojector::gui
