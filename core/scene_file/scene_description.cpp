#include "core/scene_file/scene_file.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace unprojector::scene_file {
namespace {

bool isSame(const LookAt &a, const LookAt &b)
{
    return a.eye.coordinates() == b.eye.coordinates() && a.center.coordinates() == b.center.coordinates()
           && a.up == b.up;
}

/// Puts the matrices of `before` in place of the parameters that were read from them and are still the same.
void keepMatrices(SceneFile &file, const SceneFile &before)
{
    const auto *projection = std::get_if<MatrixProjection>(&before.projection);
    const auto *view = std::get_if<glm::dmat4>(&before.view);
    if (!projection && !view)
        return;
    const Result<ViewGeometry> read = viewGeometry(pictureGeometry(before));
    if (!read)
        return;
    if (projection && std::get<Projection>(file.projection) == read->projection) {
        file.projection = *projection;
        // Of a reversed matrix the window has turned the depth range round.
        if (const auto form = recognised(*projection); form && form->reversed)
            std::swap(file.depthRange.atNear, file.depthRange.atFar);
    }
    if (view && isSame(std::get<LookAt>(file.view), read->camera))
        file.view = *view;
}

} // namespace

PictureGeometry pictureGeometry(const SceneFile &scene)
{
    const Surface surface = surfaceFromWidget(scene.windowWidth, scene.windowHeight, scene.devicePixelRatio);
    return {surface, scene.viewport.value_or(wholeSurface(surface)), scene.depthRange, scene.projection, scene.view};
}

std::filesystem::path objectFile(const SceneFileObject &object, const std::filesystem::path &sceneFile)
{
    return object.file.empty() ? std::filesystem::path() : sceneFile.parent_path() / object.file;
}

Result<Scene> sceneFromFile(const SceneFile &file, const std::filesystem::path &sceneFile,
                            const std::vector<std::shared_ptr<const Model>> &models)
{
    assert(models.size() == file.objects.size());
    const Result<ViewGeometry> picture = viewGeometry(pictureGeometry(file));
    if (!picture)
        return picture.error();
    Scene scene;
    scene.camera = picture->camera;
    scene.home = file.ui.home.value_or(scene.camera);
    scene.projection = picture->projection;
    scene.projectionFollowsViewport = file.ui.projectionFollowsViewport.value_or(file.aspectFromViewport);
    scene.clipDistancesFitObjects = file.ui.clipDistancesFitObjects.value_or(false);
    if (file.ui.viewportRule)
        scene.viewport = *file.ui.viewportRule;
    else if (file.viewport && *file.viewport != wholeSurface(picture->surface)) {
        scene.viewport.kind = ViewportRule::Kind::Fixed;
        scene.viewport.fixed = *file.viewport;
    }
    scene.depthRange = picture->depthRange;
    for (std::size_t i = 0; i < file.objects.size() && i < models.size(); ++i) {
        const SceneFileObject &object = file.objects[i];
        scene.objects.push_back({object.name, objectFile(object, sceneFile), models[i], object.transform});
    }
    scene.clipPlanes = file.clipPlanes;
    scene.clipPlanesOff = file.ui.clipPlanesOff;
    return scene;
}

SceneFile sceneFileFrom(const Scene &scene, const ViewGeometry &geometry, const std::filesystem::path &sceneFile,
                        const SceneFile &before)
{
    SceneFile file;
    file.windowWidth = logicalFromDevice(geometry.surface, geometry.surface.widthPixels);
    file.windowHeight = logicalFromDevice(geometry.surface, geometry.surface.heightPixels);
    file.devicePixelRatio = geometry.surface.devicePixelRatio;
    if (scene.viewport.kind != ViewportRule::Kind::WholeWindow)
        file.viewport = geometry.viewport;
    file.depthRange = geometry.depthRange;
    file.projection = geometry.projection;
    file.aspectFromViewport =
        scene.projectionFollowsViewport && std::holds_alternative<Perspective>(geometry.projection);
    file.view = geometry.camera;
    file.clipPlanes = scene.clipPlanes;
    file.ui = {scene.viewport, scene.projectionFollowsViewport, scene.clipDistancesFitObjects, scene.home,
               scene.clipPlanesOff};
    file.extra = before.extra;
    keepMatrices(file, before);

    std::vector<SceneFileObject> known = before.objects;
    for (const SceneObject &object : scene.objects) {
        SceneFileObject described;
        described.name = object.name;
        if (object.file.empty())
            described.bundled = object.model ? object.model->name : object.name;
        else
            described.file = object.file.lexically_proximate(sceneFile.parent_path());
        described.transform = object.transform;
        for (auto it = known.begin(); it != known.end(); ++it) {
            if (it->name == described.name && it->file == described.file && it->bundled == described.bundled) {
                described.extra = std::move(it->extra);
                known.erase(it);
                break;
            }
        }
        file.objects.push_back(std::move(described));
    }
    return file;
}

} // namespace unprojector::scene_file
