#include "core/library/scene_data.h"

#include "core/library/internal.h"
#include "core/scene/measures.h"

namespace unprojector {

namespace {

SceneObject publicObject(const scene::SceneObject &object)
{
    SceneObject result;
    result.name = object.name;
    result.file = object.file;
    result.vertices = object.model->fileVertices > 0 ? object.model->fileVertices : object.model->vertexCount();
    result.triangles = object.model->triangleCount();
    result.points = object.model->pointCount();
    result.worldFromObject = geometry::worldFromObject(object.transform);
    const geometry::Box box = scene::boundsOf(object);
    if (!box.isEmpty()) {
        result.lowest = box.lowest;
        result.highest = box.highest;
    }
    result.isHidden = object.isHidden;
    for (const base::Note &note : object.model->notes)
        result.notes.push_back(note.text());
    return result;
}

} // namespace

Scene SceneAccess::make(opening::OpenedScene opened, const Setup &setup)
{
    std::vector<SceneObject> objects;
    for (const scene::SceneObject &object : opened.objects)
        objects.push_back(publicObject(object));
    return Scene(std::make_shared<const Scene::Data>(std::move(opened), setup, std::move(objects)));
}

SceneAccess::Rays SceneAccess::rays(const Scene &scene, const geometry::Setup &setup)
{
    if (const auto error = opening::unreachable(scene.m_data->opened))
        return publicError(*error);
    const auto unprojector = unproject::Unprojector::of(setup);
    if (!unprojector)
        return valueError(unprojector.error());
    const Scene::Data &data = *scene.m_data;
    std::call_once(data.areCastersBuilt, [&data] { data.casters = opening::castersOf(data.opened.objects); });
    const std::vector<glm::dvec4> clipPlanes =
        data.opened.file ? data.opened.file->clipPlanes : std::vector<glm::dvec4>();
    return std::make_shared<const ray::SceneRays>(*unprojector, data.opened.objects, data.casters, clipPlanes);
}

} // namespace unprojector
