#include "gui/document/scene_edits.h"

#include "core/geometry/camera_motion.h"
#include "core/scene/given_matrices.h"
#include "core/scene/opening_view.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace mesh;
using namespace scene;

namespace {

/// Returns whether an object is completely in the view: within its sides and, if
/// `withClipDistances`, between near and far.
bool isInSight(const Setup &setup, const SceneObject &object, bool withClipDistances)
{
    const Result<glm::dmat4> matrix = clipFromWorld(setup);
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

/// Shows all of these objects, of which the last `added` are new. Camera, near and far stay if they
/// already do.
void showAdded(SceneSettings &settings, Setup setup, const std::vector<SceneObject> &objects, std::size_t added)
{
    Box bounds;
    Framing framing(setup);
    for (const SceneObject &object : objects) {
        if (object.isHidden)
            continue;
        bounds.add(boundsOf(object));
        add(framing, object);
    }
    const auto areNewInSight = [&](bool withClipDistances) {
        return std::all_of(objects.end() - static_cast<std::ptrdiff_t>(added), objects.end(),
                           [&](const SceneObject &object) { return isInSight(setup, object, withClipDistances); });
    };
    if (!areNewInSight(false))
        setup = framing.setup();
    if (!settings.clipDistancesFitObjects && !areNewInSight(true))
        setup.projection() = withFittedClipDistances(setup, bounds, {});
    settings.camera = setup.camera();
    settings.projection = setup.projection();
}

} // namespace

Check addObjects(SceneDocument &document, std::vector<SceneObject> objects)
{
    return document.edit({SceneDocument::tr("Add objects")}, [&](Scene &scene) {
        const std::size_t added = objects.size();
        for (SceneObject &object : objects) {
            object.name = freeName(object.name, scene.objects);
            scene.objects.push_back(std::move(object));
        }
        showAdded(scene, document.setup(), scene.objects, added);
    });
}

Check removeObject(SceneDocument &document, std::size_t index)
{
    Q_ASSERT(index < document.objects().size());
    return document.edit({SceneDocument::tr("Remove object")}, [index](Scene &scene) {
        scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(index));
    });
}

Check moveObject(SceneDocument &document, std::size_t from, std::size_t to)
{
    Q_ASSERT(from < document.objects().size() && to < document.objects().size());
    return document.edit({SceneDocument::tr("Order of objects")}, [from, to](Scene &scene) {
        const auto at = [&scene](std::size_t index) {
            return scene.objects.begin() + static_cast<std::ptrdiff_t>(index);
        };
        if (from < to)
            std::rotate(at(from), at(from + 1), at(to + 1));
        else
            std::rotate(at(to), at(from), at(from + 1));
    });
}

Check setObjectHidden(SceneDocument &document, std::size_t index, bool isHidden)
{
    Q_ASSERT(index < document.objects().size());
    return document.edit({isHidden ? SceneDocument::tr("Hide object") : SceneDocument::tr("Show object")},
                         [index, isHidden](Scene &scene) { scene.objects[index].isHidden = isHidden; });
}

Check showAllObjects(SceneDocument &document)
{
    return document.edit({SceneDocument::tr("Show all objects")}, [](Scene &scene) {
        for (SceneObject &object : scene.objects)
            object.isHidden = false;
    });
}

bool hasHiddenObjects(const Scene &scene)
{
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const SceneObject &object) { return object.isHidden; });
}

NameFault renameObject(SceneDocument &document, std::size_t index, const QString &name)
{
    Q_ASSERT(index < document.objects().size());
    const std::string wanted = name.trimmed().toStdString();
    if (const NameFault fault = faultOf(wanted, index, document.objects()); fault != NameFault::None)
        return fault;
    // A name cannot make a setup invalid.
    static_cast<void>(
        document.edit({SceneDocument::tr("Rename object")}, [&](Scene &scene) { scene.objects[index].name = wanted; }));
    return NameFault::None;
}

Check editLandmarks(SceneDocument &document, std::vector<landmarks::Landmark> landmarks, const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) { scene.landmarks.landmarks = std::move(landmarks); });
}

Check editLandmarkSet(SceneDocument &document, landmarks::LandmarkSet set, const EditLabel &label)
{
    return document.edit(label, [&](Scene &scene) { scene.landmarks = std::move(set); });
}

Result<SceneSettings> withCamera(const SceneSettings &settings, Setup setup, const GivenCamera &given)
{
    if (given.projection)
        setup.lens = *given.projection;
    if (given.eyeFromWorld)
        setup.pose = *given.eyeFromWorld;
    const Result<SceneSettings> taken = withSetup(settings, setup);
    if (!taken)
        return taken.error();
    SceneSettings result = *taken;
    if (given.size) {
        result.windowSize = given.size;
        result.viewport.kind = ViewportRule::Kind::WholeWindow;
    }
    if (given.viewport) {
        result.viewport.kind = ViewportRule::Kind::Fixed;
        result.viewport.fixed = *given.viewport;
    }
    return result;
}

Check editCamera(SceneDocument &document, const GivenCamera &given, const EditLabel &label)
{
    const Result<SceneSettings> settings = withCamera(document.scene(), document.setup(), given);
    if (!settings)
        return settings.error();
    return document.edit(label, [&](Scene &scene) { static_cast<SceneSettings &>(scene) = *settings; });
}

} // namespace unprojector::gui
