#include "core/scene/given_matrices.h"

#include <utility>

namespace unprojector::scene {
using namespace geometry;

Result<SceneSettings> withSetup(SceneSettings settings, Setup given)
{
    const auto *matrix = std::get_if<MatrixProjection>(&given.lens);
    given.depthRange = settings.depthRange;
    if (matrix && settings.isDepthRangeTurned)
        std::swap(given.depthRange.atNear, given.depthRange.atFar);
    const Result<Setup> shown = byParameters(given);
    if (!shown)
        return shown.error();
    settings.projection = shown->projection();
    settings.camera = shown->camera();
    settings.depthRange = shown->depthRange;
    if (matrix) {
        settings.projection = SceneProjection(*matrix, shown->projection());
        settings.isDepthRangeTurned = shown->depthRange != given.depthRange;
        settings.projectionFollowsViewport = settings.clipDistancesFitObjects = false;
    }
    if (const auto *eyeFromWorld = std::get_if<glm::dmat4>(&given.pose))
        settings.camera = SceneCamera(*eyeFromWorld, shown->camera());
    return settings;
}

SceneSettings afterChange(const SceneSettings &before, SceneSettings settings)
{
    if (settings.depthRange != before.depthRange && !before.projection.matrix() && !settings.projection.matrix())
        settings.isDepthRangeTurned = false;
    return settings;
}

} // namespace unprojector::scene
