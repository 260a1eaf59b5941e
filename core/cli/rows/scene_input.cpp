#include "core/cli/rows/scene_input.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/mesh/import/file_contents.h"
#include "core/opening/models.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace unproject;
using namespace scene_file;
using namespace base;
using namespace mesh;

namespace {

/// Reads stdin as readSceneText reads a file.
base::Expected<std::string, base::Error> standardInput(const std::string &name)
{
    ByteSource source("-");
    std::string text = source.readAll(kMostSceneBytes);
    if (!source.hasFailed())
        return text;
    return notReadable(name);
}

} // namespace

std::optional<SceneOrClicks> sceneOrClicks(const std::string &file)
{
    const std::string name = file == "-" ? "stdin" : file;
    const base::Expected<std::string, base::Error> text =
        file == "-" ? standardInput(name) : readSceneText(pathFromUtf8(file));
    if (!text) {
        complain(text.error().message());
        return std::nullopt;
    }
    base::Expected<SceneOrClicks, base::Error> given = parseSceneOrClicks(*text, name);
    constexpr std::size_t kStart = 512;
    std::string advice = given ? std::string() : reader::adviceByContents(text->substr(0, kStart), "json");
    if (!advice.empty()) {
        if (const std::size_t dot = file.rfind('.'); dot != file.npos && advice.ends_with(file.substr(dot)))
            advice = tr("it is a model; open it in the window, and give the scene that File > Save Scene writes");
        if (file == "-")
            advice = tr("a model is not read from standard input, give it by its name");
        complain(tr("%1: is not a scene; %2", name, advice));
        return std::nullopt;
    }
    if (!given) {
        complain(given.error().message());
        return std::nullopt;
    }
    return std::move(given).value();
}

InputFiles filesOf(const SceneOrClicks &given, const std::string &file)
{
    InputFiles files{file};
    std::unordered_set<std::string> known{file};
    const auto add = [&](const SceneFile &scene) {
        for (const auto &model : opening::modelFiles(scene, file == "-" ? "" : pathFromUtf8(file))) {
            if (std::string named = utf8FromPath(model); known.insert(named).second)
                files.push_back(std::move(named));
        }
    };
    if (const auto *clicks = std::get_if<std::vector<Click>>(&given))
        std::for_each(clicks->begin(), clicks->end(), [&add](const Click &click) { add(click.scene); });
    else
        add(std::get<SceneFile>(given));
    return files;
}

std::optional<SceneFile> sceneOf(const SceneOrClicks &given, const std::string &file)
{
    const std::string name = file == "-" ? "stdin" : file;
    const Result<SceneFile, std::string> scene = oneScene(given);
    if (!scene) {
        complain(name + ": " + scene.error());
        return std::nullopt;
    }
    const ApiConventions &api = conventionsOf(scene->conventions.value_or(Api::OpenGl));
    if (std::holds_alternative<SceneFile>(given) && api.isWorldMirrored)
        complain(name + ": conventions: "
                 + tr("%1's own world has z negated; world coordinates here are the scene's, right-handed", api.name));
    return *scene;
}

std::optional<SceneFile> readScene(const std::string &file)
{
    const std::optional<SceneOrClicks> given = sceneOrClicks(file);
    return given ? sceneOf(*given, file) : std::nullopt;
}

namespace {

/// The object of a name. If there is none, stderr lists the names; if there are several, stderr
/// lists those.
const SceneFileObject *objectNamed(const SceneFile &scene, const std::string &name)
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].name == name)
            indices.push_back(i);
    }
    if (indices.size() == 1)
        return &scene.objects[indices[0]];
    if (!indices.empty()) {
        std::string alike;
        for (const std::size_t index : indices)
            alike += (alike.empty() ? "objects[" : ", objects[") + std::to_string(index) + ']';
        complain(tr("the scene has several objects called \"%1\": %2; give each a name of its own", name, alike));
        return nullptr;
    }
    std::string names;
    for (const SceneFileObject &object : scene.objects)
        names += (names.empty() ? "" : ", ") + object.name;
    complain(
        tr(names.empty() ? "the scene has no object \"%1\"; it has none" : "the scene has no object \"%1\"; it has: %2",
           name, names));
    return nullptr;
}

} // namespace

std::optional<RowScene> rowScene(const SceneOrClicks &given, const RowOptions &options)
{
    if (options.scene == "-" && options.input == "-") {
        complain(tr("the scene and the points cannot both come from standard input; give a file for one of them"));
        return std::nullopt;
    }
    const std::optional<SceneFile> scene = sceneOf(given, options.scene);
    const std::optional<BatchSpace> space = scene ? batchSpace(options.space, *scene) : std::nullopt;
    if (!space)
        return std::nullopt;
    RowScene found{setupOf(*scene), *space, filesOf(*scene, options.scene)};
    found.inputs.push_back(options.input);
    return found;
}

std::optional<BatchSpace> batchSpace(const std::string &space, const SceneFile &scene)
{
    const std::string_view object = "object:";
    if (space == "eye")
        return BatchSpace{BatchSpace::Kind::Eye, {}};
    if (space == "world")
        return BatchSpace{};
    if (!space.starts_with(object)) {
        complain(tr("--space %1: give world, eye or object:NAME", space));
        return std::nullopt;
    }
    const SceneFileObject *placed = objectNamed(scene, space.substr(object.size()));
    if (placed == nullptr)
        return std::nullopt;
    return BatchSpace{BatchSpace::Kind::Object, preciseWorldFromObject(placed->transform)};
}

} // namespace unprojector::cli
