#include "core/base/path_text.h"
#include "core/geometry/drawable.h"
#include "core/geometry/error_text.h"
#include "core/scene/given_matrices.h"
#include "core/scene/reach.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

namespace unprojector::scene_file {
using namespace geometry;
using namespace scene;

namespace {

/// The path from the root, without "." and "..". Links stay as named, except one before a "..": the
/// parent folder is the target's, not the link's.
std::filesystem::path absolutePath(const std::filesystem::path &path)
{
    std::error_code failed;
    const std::filesystem::path whole = path.empty() ? path : std::filesystem::absolute(path, failed);
    if (failed || path.empty())
        return path.lexically_normal();
    std::filesystem::path result = whole.root_path();
    for (const std::filesystem::path &part : whole.relative_path()) {
        if (part == "..") {
            std::error_code error;
            if (std::filesystem::is_symlink(std::filesystem::symlink_status(result, error))) {
                const std::filesystem::path target = std::filesystem::canonical(result, error);
                result = error ? result : target;
            }
            result = result.parent_path();
        } else if (part != ".") {
            result /= part;
        }
    }
    return result;
}

/// The path of a file from a folder: relative, if both are on one drive.
/// @param file, folder  absolute, see absolutePath
std::filesystem::path relativePath(const std::filesystem::path &file, const std::filesystem::path &folder)
{
    std::filesystem::path relative = file.lexically_proximate(folder);
    if (absolutePath(folder / relative) == file)
        return relative;
    // The folder is behind a link, so the way up differs from its name.
    std::error_code failed, failedToo;
    const std::filesystem::path from = std::filesystem::weakly_canonical(folder, failed);
    const std::filesystem::path to = std::filesystem::weakly_canonical(file.parent_path(), failedToo);
    return failed || failedToo ? file : (to / file.filename()).lexically_proximate(from);
}

base::Error failed(const std::string &name, std::string path, const Error &cause)
{
    return {errorText(cause), std::move(path), name};
}

} // namespace

std::optional<base::Error> whyNotShown(const SceneFile &file, const std::string &name)
{
    // The first of the two that the window would use, see sceneFromFile.
    const ViewportRule *rule = file.ui.viewportRule ? &*file.ui.viewportRule : nullptr;
    const bool isFixed = rule && rule->kind == ViewportRule::Kind::Fixed;
    if (isFixed || (!rule && file.viewport)) {
        const std::string path = isFixed ? "ui.viewportRule.fixed." : "viewport.";
        const auto &[x, y, width, height] = isFixed ? rule->fixed : *file.viewport;
        for (const auto &[key, pixels] :
             {std::pair("x", x), std::pair("y", y), std::pair("width", width), std::pair("height", height)}) {
            if (const Check valid = checkViewportNumber(pixels); !valid)
                return failed(name, path + key, valid.error());
        }
    }
    const auto &[atNear, atFar] = file.depthRange;
    for (const auto &[key, depth] : {std::pair("depthRange[0]", atNear), std::pair("depthRange[1]", atFar)}) {
        if (const Check valid = checkDepthRangeEnd(depth); !valid)
            return failed(name, key, valid.error());
    }
    if (static_cast<float>(atNear) == static_cast<float>(atFar)) // OpenGL takes single precision only
        return failed(name, "depthRange", {ErrorCode::EmptyDepthRange, atNear});
    if (const auto *matrix = std::get_if<MatrixProjection>(&file.projection)) {
        if (const auto form = recognised(*matrix); !form)
            return failed(name, "projection.matrix", form.error());
    }
    if (const Result<Setup> setup = byParameters(setupOf(file)); !setup)
        return failed(name, std::holds_alternative<glm::dmat4>(file.view) ? "view.matrix" : "projection",
                      setup.error());
    return std::nullopt;
}

Setup setupOf(const SceneFile &scene)
{
    const Surface surface = surfaceFromWidget(scene.windowWidth, scene.windowHeight, scene.devicePixelRatio);
    return {surface, scene.viewport.value_or(wholeSurface(surface)), scene.depthRange, scene.projection, scene.view};
}

std::filesystem::path objectFile(const SceneFileObject &object, const std::filesystem::path &sceneFile)
{
    if (object.file.empty())
        return {};
    std::filesystem::path file = sceneFile.parent_path() / object.file;
    std::error_code failed;
    if (std::filesystem::exists(file, failed))
        return file;
    // A recovered scene may name its models from a folder that is gone: no system follows its "..".
    std::filesystem::path whole = absolutePath(file);
    return std::filesystem::exists(whole, failed) ? whole : file;
}

base::Expected<Scene, base::Error> sceneFromFile(const SceneFile &file, const std::filesystem::path &sceneFile,
                                                 std::vector<SceneObject> objects)
{
    const std::string name = base::utf8FromPath(sceneFile.filename());
    if (const std::optional<base::Error> error = whyNotShown(file, name))
        return *error;
    const Setup setup = setupOf(file);
    Scene scene;
    scene.depthRange = setup.depthRange;
    static_cast<SceneSettings &>(scene) = withSetup(scene, setup).value();
    if (file.isWindowFixed)
        scene.windowSize = setup.surface;
    scene.home = scene.camera;
    if (file.ui.home)
        scene.home = *file.ui.home;
    scene.projectionFollowsViewport = file.ui.projectionFollowsViewport.value_or(file.aspectFromViewport);
    scene.clipDistancesFitObjects = file.ui.clipDistancesFitObjects.value_or(false);
    if (file.ui.viewportRule)
        scene.viewport = *file.ui.viewportRule;
    else if (file.viewport && *file.viewport != wholeSurface(setup.surface)) {
        scene.viewport.kind = ViewportRule::Kind::Fixed;
        scene.viewport.fixed = *file.viewport;
    }
    scene.objects = std::move(objects);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (const Check valid = reachable(scene.objects[i]); !valid)
            return failed(name, "objects[" + std::to_string(i) + "].transform", valid.error());
    }
    scene.clipPlanes = file.clipPlanes;
    scene.landmarks = file.landmarks;
    scene.givenPoint = file.point;
    scene.conventions = file.conventions.value_or(Api::OpenGl);
    scene.clipPlanesOff = file.ui.clipPlanesOff;
    scene.fileKeys = {file.viewport.has_value(), file.conventions.has_value(), file.extra};
    return scene;
}

SceneFileObject sceneFileObject(const SceneObject &object, const std::filesystem::path &sceneFile)
{
    SceneFileObject described;
    described.name = object.name;
    if (object.file.empty())
        described.bundled = object.model ? object.model->name : object.name;
    else
        described.file = relativePath(absolutePath(object.file), absolutePath(sceneFile).parent_path());
    described.transform = object.transform;
    described.isHidden = object.isHidden;
    described.extra = object.extra;
    return described;
}

SceneFile sceneFileFrom(const Scene &scene, const Setup &setup, const std::filesystem::path &sceneFile)
{
    SceneFile file;
    file.windowWidth = logicalFromDevice(setup.surface, setup.surface.widthPixels);
    file.windowHeight = logicalFromDevice(setup.surface, setup.surface.heightPixels);
    file.devicePixelRatio = setup.surface.devicePixelRatio;
    file.isWindowFixed = scene.windowSize.has_value();
    if (scene.viewport.kind != ViewportRule::Kind::WholeWindow || scene.fileKeys.hasViewport)
        file.viewport = setup.viewport;
    file.depthRange = scene.depthRange;
    file.projection = setup.projection();
    if (const MatrixProjection *matrix = scene.projection.matrix(); matrix && setup.projection() == *scene.projection) {
        file.projection = *matrix;
        if (scene.isDepthRangeTurned)
            std::swap(file.depthRange.atNear, file.depthRange.atFar);
    }
    file.aspectFromViewport =
        scene.projectionFollowsViewport && std::holds_alternative<Perspective>(setup.projection());
    file.view = setup.camera();
    if (const glm::dmat4 *matrix = scene.camera.matrix(); matrix && setup.camera() == *scene.camera)
        file.view = *matrix;
    file.clipPlanes = scene.clipPlanes;
    file.landmarks = scene.landmarks;
    file.point = scene.givenPoint;
    if (scene.conventions != Api::OpenGl || scene.fileKeys.hasConventions)
        file.conventions = scene.conventions;
    file.ui = {scene.viewport, scene.projectionFollowsViewport, scene.clipDistancesFitObjects, scene.home,
               scene.clipPlanesOff};
    file.extra = scene.fileKeys.extra;

    for (const SceneObject &object : scene.objects)
        file.objects.push_back(sceneFileObject(object, sceneFile));
    return file;
}

} // namespace unprojector::scene_file
