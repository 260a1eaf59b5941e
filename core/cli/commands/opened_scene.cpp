#include "core/cli/commands/opened_scene.h"

#include "core/cli/commands/size_text.h"
#include "core/cli/rows/scene_input.h"
#include "core/files/path_text.h"
#include "core/mesh/import/import_error_text.h"
#include "core/opening/models.h"
#include "core/scene/opening_view.h"
#include "core/scene/reach.h"
#include "core/scene_file/scene_error_text.h"
#include "core/text/error_text.h"
#include "core/text/translation.h"

#include <filesystem>
#include <map>
#include <memory>
#include <utility>

namespace unprojector::cli {
using namespace geometry;
using namespace mesh;
using namespace scene;
using namespace scene_file;
using namespace unproject;
using namespace files;
using namespace text;
namespace {

std::optional<OpenedScene> openModel(const std::string &file)
{
    const std::filesystem::path path = pathFromUtf8(file);
    const auto model = importModel(path, {});
    if (!model) {
        complain(importErrorText(model.error()));
        return std::nullopt;
    }
    return OpenedScene{{{utf8FromPath(path.filename()), path, *model, {}}}, std::nullopt, file, filesOf(path, **model)};
}

} // namespace

InputFiles filesOf(const std::filesystem::path &file, const Model &model)
{
    InputFiles files{utf8FromPath(file)};
    for (const std::filesystem::path &other : model.otherFiles)
        files.push_back(utf8FromPath(other));
    for (const Texture &texture : model.textures)
        files.push_back(utf8FromPath(texture.file));
    return files;
}

bool isMeantAsScene(const std::string &file)
{
    return file == "-" || opening::isMeantAsScene(pathFromUtf8(file));
}

std::optional<OpenedScene> openScene(const std::string &file)
{
    if (!isMeantAsScene(file))
        return openModel(file);
    std::optional<SceneFile> scene = readScene(file);
    if (!scene)
        return std::nullopt;
    OpenedScene opened{{}, std::move(scene), file == "-" ? "stdin" : file, {file}};
    const std::filesystem::path path = file == "-" ? std::filesystem::path() : pathFromUtf8(file);
    opening::ModelFiles store;
    auto objects =
        opening::objectsOf(*opened.file, path, [&store](const std::filesystem::path &of) { return store.read(of); });
    if (!objects) {
        complain(opened.name + ": " + objects.error());
        return std::nullopt;
    }
    opened.objects = std::move(objects).value();
    for (const SceneObject &object : opened.objects) {
        for (std::string &named : object.file.empty() ? InputFiles() : filesOf(object.file, *object.model))
            opened.files.push_back(std::move(named));
    }
    return opened;
}

bool areReachable(const OpenedScene &opened)
{
    for (const SceneObject &object : opened.objects) {
        if (const Check valid = reachable(object); !valid) {
            complain(opened.name + ": " + object.name + ": " + errorText(valid.error()));
            return false;
        }
    }
    return true;
}

ray::SceneRays raysOf(const OpenedScene &opened, const Unprojector &unprojector)
{
    std::map<const Model *, std::shared_ptr<const ray::RayCaster>> built;
    std::vector<std::shared_ptr<const ray::RayCaster>> casters;
    for (const SceneObject &object : opened.objects) {
        if (object.isHidden) {
            casters.push_back(nullptr);
            continue;
        }
        std::shared_ptr<const ray::RayCaster> &caster = built[object.model.get()];
        if (!caster)
            caster = ray::RayCaster::build(object.model, {});
        casters.push_back(caster);
    }
    const std::vector<glm::dvec4> clipPlanes = opened.file ? opened.file->clipPlanes : std::vector<glm::dvec4>();
    return {unprojector, opened.objects, casters, clipPlanes};
}

std::optional<Setup> setupOf(const OpenedScene &opened, const std::string &size)
{
    const std::optional<SizeGiven> given =
        size.empty() ? SizeGiven{kUsualWidth, kUsualHeight} : sizeGiven("--size", size);
    if (!given)
        return std::nullopt;
    if (opened.file && size.empty())
        return scene_file::setupOf(*opened.file);

    Surface surface{given->width, given->height, 1.0};
    if (const Check valid = check(surface); !valid) {
        complain("--size " + size + ": " + errorText(valid.error()));
        return std::nullopt;
    }
    Scene scene;
    if (opened.file) {
        surface.devicePixelRatio = opened.file->devicePixelRatio;
        Result<Scene, SceneFileError> shown = sceneFromFile(*opened.file, pathFromUtf8(opened.name), opened.objects);
        if (!shown) {
            SceneFileError error = shown.error();
            error.file = opened.name;
            complain(sceneErrorText(error));
            return std::nullopt;
        }
        scene = std::move(shown).value();
    } else {
        scene.objects = opened.objects;
        scene.camera = scene.home = openingCamera(opened.objects, surface);
        scene.projection = openingProjection();
    }
    const Result<Setup> setup = scene::setupOf(scene, surface, groundUnder(boundsOf(scene)).box);
    if (setup)
        return *setup;
    complain(opened.name + ": " + errorText(setup.error()));
    return std::nullopt;
}

} // namespace unprojector::cli
