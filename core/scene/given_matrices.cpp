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
    }
    if (givenLens(settings))
        settings.projectionFollowsViewport = settings.clipDistancesFitObjects = false;
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

std::optional<Lens> givenLens(const SceneSettings &settings)
{
    if (const MatrixProjection *matrix = settings.projection.matrix())
        return *matrix;
    const Projection &projection = *settings.projection;
    return std::holds_alternative<Pinhole>(projection) ? std::optional<Lens>(projection) : std::nullopt;
}

} // namespace unprojector::scene
