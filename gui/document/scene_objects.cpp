// What is done to the list of objects; the rest of the document is in scene_document.cpp.

#include "gui/document/scene_document.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace unprojector::gui {
namespace {

/// Whether all of an object is in the picture: between its rims and, where they count, between near and far.
bool isInSight(const Picture &picture, const SceneObject &object, bool withClipDistances)
{
    const Result<glm::dmat4> matrix = clipFromWorld(picture);
    if (!matrix)
        return false;
    const glm::dmat4 clipFromObject = *matrix * worldFromObject(object.transform);
    const auto isSeen = [&](const Mesh &mesh, std::size_t vertex) {
        const glm::dvec4 clip = clipFromObject * glm::dvec4(mesh.position(vertex), 1.0);
        return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w
               && (!withClipDistances || std::abs(clip.z) <= clip.w);
    };
    const std::vector<Mesh> &meshes = object.model->meshes;
    return std::all_of(meshes.begin(), meshes.end(), [&](const Mesh &mesh) {
        for (std::size_t element = 0; element < mesh.elementCount(); ++element) {
            if (!isSeen(mesh, mesh.vertexAt(element)))
                return false;
        }
        return true;
    });
}

} // namespace

SceneSettings SceneDocument::showing(const std::vector<SceneObject> &objects, std::size_t added) const
{
    SceneSettings settings = m_state.settings;
    Picture picture = geometry();
    Box bounds;
    Framing framing(picture);
    for (const SceneObject &object : objects) {
        if (object.isHidden)
            continue;
        bounds.add(boundsOf(object));
        add(framing, object);
    }
    const auto areNewInSight = [&](bool withClipDistances) {
        return std::all_of(objects.end() - static_cast<std::ptrdiff_t>(added), objects.end(),
                           [&](const SceneObject &object) { return isInSight(picture, object, withClipDistances); });
    };
    if (!areNewInSight(false))
        picture = framing.picture();
    if (!settings.clipDistancesFitObjects && !areNewInSight(true))
        picture.projection() = withFittedClipDistances(picture, bounds, {});
    settings.camera = picture.camera();
    settings.projection = picture.projection();
    return settings;
}

Check SceneDocument::addObjects(std::vector<SceneObject> objects)
{
    const std::size_t added = objects.size();
    std::vector<SceneObject> all = *m_state.objects;
    for (SceneObject &object : objects) {
        object.name = freeName(object.name, all);
        all.push_back(std::move(object));
    }
    SceneSettings settings = showing(all, added);
    SceneState state = with(std::move(all));
    state.settings = std::move(settings);
    return record(std::move(state), {tr("Add objects")});
}

Check SceneDocument::removeObject(std::size_t place)
{
    Q_ASSERT(place < objects().size());
    std::vector<SceneObject> others = *m_state.objects;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(place));
    return edit(std::move(others), {tr("Remove object")});
}

Check SceneDocument::moveObject(std::size_t from, std::size_t to)
{
    Q_ASSERT(from < objects().size() && to < objects().size());
    std::vector<SceneObject> moved = *m_state.objects;
    const auto at = [&moved](std::size_t place) { return moved.begin() + static_cast<std::ptrdiff_t>(place); };
    if (from < to)
        std::rotate(at(from), at(from + 1), at(to + 1));
    else
        std::rotate(at(to), at(from), at(from + 1));
    return edit(std::move(moved), {tr("Order of objects")});
}

Check SceneDocument::setObjectHidden(std::size_t place, bool isHidden)
{
    Q_ASSERT(place < objects().size());
    std::vector<SceneObject> objects = *m_state.objects;
    objects[place].isHidden = isHidden;
    return edit(std::move(objects), {isHidden ? tr("Hide object") : tr("Show object")});
}

Check SceneDocument::showAllObjects()
{
    std::vector<SceneObject> objects = *m_state.objects;
    for (SceneObject &object : objects)
        object.isHidden = false;
    return edit(std::move(objects), {tr("Show all objects")});
}

bool SceneDocument::hasHiddenObjects() const
{
    return std::any_of(objects().begin(), objects().end(), [](const SceneObject &object) { return object.isHidden; });
}

NameFault SceneDocument::renameObject(std::size_t place, const QString &name)
{
    Q_ASSERT(place < objects().size());
    const std::string wanted = name.trimmed().toStdString();
    if (const NameFault fault = faultOf(wanted, place, objects()); fault != NameFault::None)
        return fault;
    std::vector<SceneObject> objects = *m_state.objects;
    objects[place].name = wanted;
    // A name is no number of a picture: there is nothing that it could make invalid.
    static_cast<void>(edit(std::move(objects), {tr("Rename object")}));
    return NameFault::None;
}

} // namespace unprojector::gui
