#include "core/files/path_text.h"
#include "core/geometry/drawable.h"
#include "core/scene/given_matrices.h"
#include "core/scene/reach.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

namespace unprojector::scene_file {
namespace {

/// The path from the root, without "." and "..". Links stay as they are named, except one before a "..": the folder above
/// is that of where the link leads, and not the one that the link lies in.
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

/// How to name a file from a folder: relative to it, where both are on one drive.
/// @param file, folder  absolute, see absolutePath
std::filesystem::path relativePath(const std::filesystem::path &file, const std::filesystem::path &folder)
{
    std::filesystem::path relative = file.lexically_proximate(folder);
    if (absolutePath(folder / relative) == file)
        return relative;
    // The folder is behind a link: the way up from it is another one than its name says.
    std::error_code failed, failedToo;
    const std::filesystem::path from = std::filesystem::weakly_canonical(folder, failed);
    const std::filesystem::path to = std::filesystem::weakly_canonical(file.parent_path(), failedToo);
    return failed || failedToo ? file : (to / file.filename()).lexically_proximate(from);
}

/// What a thing that is written again had of keys that are not ours: those of the first one `isIt` of those before, each
/// taken once.
template <class Thing, class IsIt>
text::JsonValue takeExtra(std::vector<Thing> &before, const IsIt &isIt)
{
    const auto found = std::find_if(before.begin(), before.end(), isIt);
    if (found == before.end())
        return {};
    text::JsonValue extra = std::move(found->extra);
    before.erase(found);
    return extra;
}

bool hasSameSource(const SceneFileObject &a, const SceneFileObject &b)
{
    const bool isSameFile =
        a.absoluteFile.empty() || b.absoluteFile.empty() ? a.file == b.file : a.absoluteFile == b.absoluteFile;
    return isSameFile && a.bundled == b.bundled;
}

/// What the steps of a transform had of keys that are not ours, each once: to the step that is as it was, else to the one
/// of its kind that stands in its place.
std::vector<text::JsonValue> keptExtra(const std::vector<TransformStep> &steps, const SceneFileObject &before)
{
    std::vector<text::JsonValue> extra(before.transformExtra.empty() ? 0 : steps.size());
    const std::size_t count = std::min(before.transform.size(), before.transformExtra.size());
    std::vector<bool> isTaken(count), isKnown(extra.size());
    const auto take = [&](std::size_t i, std::size_t k) {
        if (isTaken[k] || isKnown[i])
            return;
        extra[i] = before.transformExtra[k];
        isTaken[k] = isKnown[i] = true;
    };
    for (std::size_t i = 0; i < extra.size(); ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            if (steps[i] == before.transform[k])
                take(i, k);
        }
    }
    for (std::size_t i = 0; i < std::min(extra.size(), count); ++i) {
        if (steps[i].index() == before.transform[i].index())
            take(i, i);
    }
    return extra;
}

/// Gives objects the keys that are not ours of those before: each of them once, to the one that has its name, else to the
/// one that stands in its place, as one that was renamed does.
void keepUnknownKeys(std::vector<SceneFileObject> &objects, const std::vector<SceneFileObject> &before)
{
    std::vector<bool> isTaken(before.size()), isKnown(objects.size());
    const auto take = [&](std::size_t i, std::size_t k) {
        if (isTaken[k] || isKnown[i] || !hasSameSource(objects[i], before[k]))
            return;
        objects[i].extra = before[k].extra;
        objects[i].transformExtra = keptExtra(objects[i].transform, before[k]);
        isTaken[k] = isKnown[i] = true;
    };
    for (std::size_t i = 0; i < objects.size(); ++i) {
        for (std::size_t k = 0; k < before.size() && !isKnown[i]; ++k) {
            if (objects[i].name == before[k].name)
                take(i, k);
        }
    }
    for (std::size_t i = 0; i < std::min(objects.size(), before.size()); ++i)
        take(i, i);
}

SceneFileError failed(const std::string &name, std::string keyPath, const Error &cause)
{
    SceneFileError error;
    error.code = SceneFileErrorCode::InvalidValue;
    error.file = name;
    error.keyPath = std::move(keyPath);
    error.cause = cause;
    return error;
}

} // namespace

std::optional<SceneFileError> whyNotShown(const SceneFile &file, const std::string &name)
{
    // The first of the two that the window would take, see sceneFromFile.
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
    if (static_cast<float>(atNear) == static_cast<float>(atFar)) // which is all that OpenGL takes
        return failed(name, "depthRange", {ErrorCode::EmptyDepthRange, atNear});
    if (const auto *matrix = std::get_if<MatrixProjection>(&file.projection)) {
        if (const auto form = recognised(*matrix); !form)
            return failed(name, "projection.matrix", form.error());
    }
    if (const Result<Picture> picture = byParameters(pictureOf(file)); !picture)
        return failed(name, std::holds_alternative<glm::dmat4>(file.view) ? "view.matrix" : "projection",
                      picture.error());
    return std::nullopt;
}

Picture pictureOf(const SceneFile &scene)
{
    const Surface surface = surfaceFromWidget(scene.windowWidth, scene.windowHeight, scene.devicePixelRatio);
    return {surface, scene.viewport.value_or(wholeSurface(surface)), scene.depthRange, scene.projection, scene.view};
}

void locateObjects(SceneFile &scene, const std::filesystem::path &sceneFile)
{
    for (SceneFileObject &object : scene.objects)
        object.absoluteFile = absolutePath(objectFile(object, sceneFile));
}

std::filesystem::path objectFile(const SceneFileObject &object, const std::filesystem::path &sceneFile)
{
    return object.file.empty() ? std::filesystem::path() : sceneFile.parent_path() / object.file;
}

Result<Scene, SceneFileError> sceneFromFile(const SceneFile &file, const std::filesystem::path &sceneFile,
                                            std::vector<SceneObject> objects)
{
    const std::string name = files::utf8FromPath(sceneFile.filename());
    if (const std::optional<SceneFileError> error = whyNotShown(file, name))
        return *error;
    const Picture picture = pictureOf(file);
    Scene scene;
    scene.depthRange = picture.depthRange;
    static_cast<SceneSettings &>(scene) = withPicture(scene, picture).value();
    scene.home = scene.camera;
    if (file.ui.home)
        scene.home = *file.ui.home;
    scene.projectionFollowsViewport = file.ui.projectionFollowsViewport.value_or(file.aspectFromViewport);
    scene.clipDistancesFitObjects = file.ui.clipDistancesFitObjects.value_or(false);
    if (file.ui.viewportRule)
        scene.viewport = *file.ui.viewportRule;
    else if (file.viewport && *file.viewport != wholeSurface(picture.surface)) {
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
    for (const SceneFilePlaneOff &off : file.ui.clipPlanesOff)
        scene.clipPlanesOff.push_back({off.place, off.plane});
    return scene;
}

SceneFile sceneFileFrom(const Scene &scene, const Picture &geometry, const std::filesystem::path &sceneFile,
                        const SceneFile &before)
{
    SceneFile file;
    file.windowWidth = logicalFromDevice(geometry.surface, geometry.surface.widthPixels);
    file.windowHeight = logicalFromDevice(geometry.surface, geometry.surface.heightPixels);
    file.devicePixelRatio = geometry.surface.devicePixelRatio;
    if (scene.viewport.kind != ViewportRule::Kind::WholeWindow || before.viewport)
        file.viewport = geometry.viewport;
    file.depthRange = scene.depthRange;
    file.projection = geometry.projection();
    if (const MatrixProjection *matrix = scene.projection.matrix();
        matrix && geometry.projection() == *scene.projection) {
        file.projection = *matrix;
        if (scene.isDepthRangeTurned)
            std::swap(file.depthRange.atNear, file.depthRange.atFar);
    }
    file.aspectFromViewport =
        scene.projectionFollowsViewport && std::holds_alternative<Perspective>(geometry.projection());
    file.view = geometry.camera();
    if (const glm::dmat4 *matrix = scene.camera.matrix(); matrix && geometry.camera() == *scene.camera)
        file.view = *matrix;
    file.clipPlanes = scene.clipPlanes;
    file.landmarks = scene.landmarks;
    file.point = scene.givenPoint;
    if (scene.conventions != Api::OpenGl || before.conventions)
        file.conventions = scene.conventions;
    file.ui = {scene.viewport, scene.projectionFollowsViewport, scene.clipDistancesFitObjects, scene.home, {}};
    file.extra = before.extra;

    std::vector<SceneFilePlaneOff> knownPlanes = before.ui.clipPlanesOff;
    for (const ClipPlaneOff &off : scene.clipPlanesOff) {
        const auto isIt = [&](const SceneFilePlaneOff &known) { return known.plane == off.plane; };
        file.ui.clipPlanesOff.push_back({off.place, off.plane, takeExtra(knownPlanes, isIt)});
    }

    const std::filesystem::path folder = absolutePath(sceneFile).parent_path();
    for (const SceneObject &object : scene.objects) {
        SceneFileObject described;
        described.name = object.name;
        if (object.file.empty()) {
            described.bundled = object.model ? object.model->name : object.name;
        } else {
            described.absoluteFile = absolutePath(object.file);
            described.file = relativePath(described.absoluteFile, folder);
        }
        described.transform = object.transform;
        described.isHidden = object.isHidden;
        file.objects.push_back(std::move(described));
    }
    keepUnknownKeys(file.objects, before.objects);
    return file;
}

} // namespace unprojector::scene_file
