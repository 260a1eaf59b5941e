#include "core/opening/opened_scene.h"

#include "core/base/path_text.h"
#include "core/geometry/error_text.h"
#include "core/scene/opening_view.h"
#include "core/scene/reach.h"
#include "core/scene_file/clicks.h"

#include <map>
#include <utility>

namespace unprojector::opening {
using namespace geometry;
using namespace mesh;
using namespace scene;
using namespace scene_file;
using namespace base;

std::vector<std::string> filesOf(const std::filesystem::path &file, const Model &model)
{
    std::vector<std::string> files{utf8FromPath(file)};
    for (const std::filesystem::path &other : model.otherFiles)
        files.push_back(utf8FromPath(other));
    for (const Texture &texture : model.textures)
        files.push_back(utf8FromPath(texture.file));
    return files;
}

Expected<OpenedScene, base::Error> open(const std::filesystem::path &file)
{
    if (isMeantAsScene(file)) {
        const auto text = readSceneText(file);
        return text ? openText(*text, file, utf8FromPath(file)) : text.error();
    }
    const auto model = importModel(file, {});
    if (!model)
        return model.error();
    return OpenedScene{
        {{utf8FromPath(file.filename()), file, *model, {}}}, std::nullopt, utf8FromPath(file), filesOf(file, **model)};
}

Expected<OpenedScene, base::Error> openText(std::string_view text, const std::filesystem::path &path,
                                            const std::string &name)
{
    const auto given = parseSceneOrClicks(text, name);
    if (!given)
        return given.error();
    SceneOrError scene = oneScene(*given, name);
    return scene ? withModels(std::move(scene).value(), path, name) : scene.error();
}

Expected<OpenedScene, base::Error> withModels(SceneFile scene, const std::filesystem::path &path,
                                              const std::string &name)
{
    OpenedScene opened{{}, std::move(scene), name, {path.empty() ? "-" : utf8FromPath(path)}};
    ModelFiles store;
    auto objects = objectsOf(*opened.file, path, [&store](const std::filesystem::path &of) { return store.read(of); });
    if (!objects) {
        base::Error error = objects.error();
        error.file = name;
        return error;
    }
    opened.objects = std::move(objects).value();
    for (const SceneObject &object : opened.objects) {
        if (object.file.empty())
            continue;
        for (std::string &named : filesOf(object.file, *object.model))
            opened.files.push_back(std::move(named));
    }
    return opened;
}

std::optional<base::Error> unreachable(const OpenedScene &opened)
{
    for (const SceneObject &object : opened.objects) {
        if (const Check valid = reachable(object); !valid)
            return base::Error{geometry::errorText(valid.error()), object.name, opened.name};
    }
    return std::nullopt;
}

std::vector<std::shared_ptr<const ray::RayCaster>> castersOf(const std::vector<SceneObject> &objects)
{
    std::map<const Model *, std::shared_ptr<const ray::RayCaster>> built;
    std::vector<std::shared_ptr<const ray::RayCaster>> casters;
    for (const SceneObject &object : objects) {
        if (object.isHidden) {
            casters.push_back(nullptr);
            continue;
        }
        std::shared_ptr<const ray::RayCaster> &caster = built[object.model.get()];
        if (!caster)
            caster = ray::RayCaster::build(object.model, {});
        casters.push_back(caster);
    }
    return casters;
}

ray::SceneRays raysOf(const OpenedScene &opened, const unproject::Unprojector &unprojector)
{
    const std::vector<glm::dvec4> clipPlanes = opened.file ? opened.file->clipPlanes : std::vector<glm::dvec4>();
    return {unprojector, opened.objects, castersOf(opened.objects), clipPlanes};
}

Expected<Setup, base::Error> setupOf(const OpenedScene &opened, const std::optional<Surface> &size)
{
    if (opened.file && !size)
        return scene_file::setupOf(*opened.file);
    Surface surface = size.value_or(Surface{kUsualWidth, kUsualHeight, 1.0});
    surface.devicePixelRatio = 1.0;
    Scene scene;
    if (opened.file) {
        surface.devicePixelRatio = opened.file->devicePixelRatio;
        auto shown = sceneFromFile(*opened.file, pathFromUtf8(opened.name), opened.objects);
        if (!shown) {
            base::Error error = shown.error();
            error.file = opened.name;
            return error;
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
    return base::Error{.text = geometry::errorText(setup.error()), .file = opened.name};
}

} // namespace unprojector::opening
