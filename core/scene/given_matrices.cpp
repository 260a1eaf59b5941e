#include "core/scene/given_matrices.h"

#include <utility>

namespace unprojector::scene {
namespace {

bool isReversed(const std::optional<GivenProjection> &given)
{
    const auto form = given ? recognised(given->matrix) : Error{};
    return form && form->reversed;
}

} // namespace

const MatrixProjection *givenProjection(const SceneSettings &settings)
{
    return settings.given && settings.given->converted == settings.projection ? &settings.given->matrix : nullptr;
}

const glm::dmat4 *givenView(const SceneSettings &settings)
{
    return settings.givenView && settings.givenView->converted == settings.camera ? &settings.givenView->eyeFromWorld
                                                                                  : nullptr;
}

Result<SceneSettings> withMatrices(SceneSettings settings, Picture picture,
                                   const std::optional<MatrixProjection> &projection,
                                   const std::optional<glm::dmat4> &eyeFromWorld)
{
    picture.depthRange = settings.depthRange;
    if (projection) {
        // A reversed matrix has turned the depth range round, whatever became of the projection since; with it that goes.
        if (isReversed(settings.given))
            std::swap(picture.depthRange.atNear, picture.depthRange.atFar);
        picture.lens = *projection;
    }
    if (eyeFromWorld)
        picture.pose = *eyeFromWorld;
    const Result<Picture> shown = byParameters(picture);
    if (!shown)
        return shown.error();
    settings.depthRange = shown->depthRange;
    if (projection) {
        settings.projection = shown->projection();
        settings.given = {*projection, settings.projection};
        settings.projectionFollowsViewport = settings.clipDistancesFitObjects = false;
    }
    if (eyeFromWorld) {
        settings.camera = shown->camera();
        settings.givenView = {*eyeFromWorld, settings.camera};
    }
    return settings;
}

SceneSettings afterChange(const SceneSettings &before, SceneSettings settings)
{
    if (settings.depthRange != before.depthRange && settings.given == before.given && isReversed(settings.given)
        && !givenProjection(before))
        settings.given.reset();
    return settings;
}

} // namespace unprojector::scene
