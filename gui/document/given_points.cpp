#include "gui/document/given_points.h"

#include "core/pipeline/pipeline.h"
#include "gui/document/document_change.h"

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;
using namespace scene;

std::optional<std::size_t> indexOf(const GivenPoint &given, const std::vector<SceneObject> &objects)
{
    if (!std::holds_alternative<ObjectPoint>(given.point) || given.object.empty())
        return std::nullopt;
    const auto found = std::find_if(objects.begin(), objects.end(),
                                    [&](const SceneObject &object) { return object.name == given.object; });
    return found == objects.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - objects.begin()));
}

std::optional<WorldPoint> givenWorld(const Scene &scene, const Setup &setup)
{
    if (!scene.givenPoint)
        return std::nullopt;
    const std::optional<std::size_t> object = indexOf(*scene.givenPoint, scene.objects);
    const Result<pipeline::Pipeline> pipeline =
        pipeline::pipelineOf(setup, object ? worldFromObject(scene.objects[*object].transform) : glm::dmat4(1.0));
    if (!pipeline)
        return std::nullopt;
    const Result<WorldPoint> world = pointsFrom(*pipeline, *scene.givenPoint).world;
    return world ? std::optional(*world) : std::nullopt;
}

GivenPoint withObjects(const GivenPoint &given, const std::vector<SceneObject> &before,
                       const std::vector<SceneObject> &after)
{
    const std::optional<std::size_t> index = indexOf(given, before);
    if (!index)
        return given;
    const bool isOtherList = changesBetween(before, after).testFlag(Change::Objects);
    if (const std::optional<std::size_t> now = isOtherList ? indexAfter(before, *index, after) : index)
        return {given.point, after[*now].name};
    const glm::dvec4 object(std::get<ObjectPoint>(given.point).coordinates(), 1.0);
    return {WorldPoint(glm::dvec3(worldFromObject(before[*index].transform) * object)), {}};
}

} // namespace unprojector::gui
