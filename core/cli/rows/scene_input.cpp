#include "core/cli/rows/scene_input.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/cli/terminal/refusal.h"
#include "core/mesh/import/file_contents.h"
#include "core/opening/models.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace unproject;
using namespace scene_file;
using namespace base;
using namespace mesh;

SceneOrClicks sceneOrClicks(const std::string &file)
{
    const std::string name = inputName(file);
    const std::string text =
        file == "-" ? ByteSource(file).readAll(kMostSceneBytes) : needed(readSceneText(pathFromUtf8(file)));
    base::Expected<SceneOrClicks, base::Error> given = parseSceneOrClicks(text, name);
    if (given)
        return std::move(given).value();
    constexpr std::size_t kStart = 512;
    std::string advice = reader::adviceByContents(text.substr(0, kStart), "json");
    if (advice.empty())
        refuse(given.error().message());
    if (const std::size_t dot = file.rfind('.'); dot != file.npos && advice.ends_with(file.substr(dot)))
        advice = tr("it is a model; open it in the window, and give the scene that File > Save Scene writes");
    if (file == "-")
        advice = tr("a model is not read from standard input, give it by its name");
    refuse(tr("%1: is not a scene; %2", name, advice));
}

InputFiles filesOf(const SceneOrClicks &given, const std::string &file)
{
    InputFiles files{file};
    const auto add = [&](const SceneFile &scene) {
        for (const auto &model : opening::modelFiles(scene, file == "-" ? "" : pathFromUtf8(file)))
            files.push_back(utf8FromPath(model));
    };
    if (const auto *clicks = std::get_if<std::vector<Click>>(&given))
        std::for_each(clicks->begin(), clicks->end(), [&add](const Click &click) { add(click.scene); });
    else
        add(std::get<SceneFile>(given));
    return files;
}

SceneFile sceneOf(const SceneOrClicks &given, const std::string &file)
{
    SceneFile scene = needed(oneScene(given, inputName(file)));
    const ApiConventions &api = conventionsOf(scene.conventions.value_or(Api::OpenGl));
    if (std::holds_alternative<SceneFile>(given) && api.isWorldMirrored)
        complain(inputName(file) + ": conventions: "
                 + tr("%1's own world has z negated; world coordinates here are the scene's, right-handed", api.name));
    return scene;
}

SceneFile readScene(const std::string &file)
{
    return sceneOf(sceneOrClicks(file), file);
}

namespace {

/// The object of a name. Refuses a name that no object has, or several.
const SceneFileObject &objectNamed(const SceneFile &scene, const std::string &name)
{
    const SceneFileObject *found = nullptr;
    std::string alike, names;
    const auto add = [](std::string &list, const std::string &word) { list += (list.empty() ? "" : ", ") + word; };
    for (const SceneFileObject &object : scene.objects) {
        add(names, object.name);
        if (object.name != name)
            continue;
        add(alike, "objects[" + std::to_string(&object - scene.objects.data()) + ']');
        if (found == nullptr)
            found = &object;
    }
    if (found == nullptr)
        refuse(tr(names.empty() ? "the scene has no object \"%1\"; it has none"
                                : "the scene has no object \"%1\"; it has: %2",
                  name, names));
    if (alike.find(',') != alike.npos)
        refuse(tr("the scene has several objects called \"%1\": %2; give each a name of its own", name, alike));
    return *found;
}

} // namespace

RowScene rowScene(const SceneOrClicks &given, const RowOptions &options)
{
    if (options.scene == "-" && options.input == "-")
        refuse(tr("the scene and the points cannot both come from standard input; give a file for one of them"));
    const SceneFile scene = sceneOf(given, options.scene);
    RowScene found{setupOf(scene), batchSpace(options.space, scene), filesOf(scene, options.scene)};
    found.inputs.push_back(options.input);
    return found;
}

BatchSpace batchSpace(const std::string &space, const SceneFile &scene)
{
    const std::string_view object = "object:";
    if (space == "eye")
        return {BatchSpace::Kind::Eye, {}};
    if (space == "world")
        return {};
    if (!space.starts_with(object))
        refuse(tr("--space %1: give world, eye or object:NAME", space));
    const SceneFileObject &placed = objectNamed(scene, space.substr(object.size()));
    return {BatchSpace::Kind::Object, preciseWorldFromObject(placed.transform)};
}

} // namespace unprojector::cli
