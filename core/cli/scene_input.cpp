#include "core/cli/scene_input.h"

#include "core/cli/byte_stream.h"
#include "core/files/path_text.h"
#include "core/scene_file/scene_error_text.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>

namespace unprojector::cli {
using namespace scene_file;
using namespace files;

std::optional<SceneInput> sceneInput(const std::string &file)
{
    const auto scene = readSceneFile(pathFromUtf8(file));
    if (!scene) {
        complain(sceneErrorText(scene.error()));
        return std::nullopt;
    }
    SceneInput input{pictureOf(*scene), {}};
    for (const SceneFileObject &object : scene->objects)
        input.objects.push_back({object.name, worldFromObject(object.transform)});
    return input;
}

const PlacedObject *objectNamed(const SceneInput &scene, const std::string &name)
{
    const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                    [&](const PlacedObject &object) { return object.name == name; });
    if (found != scene.objects.end())
        return &*found;
    std::string names;
    for (const PlacedObject &object : scene.objects)
        names += (names.empty() ? "" : ", ") + object.name;
    complain("the scene has no object \"" + name + "\"; " + (names.empty() ? "it has none" : "it has: " + names));
    return nullptr;
}

std::optional<BatchSpace> batchSpace(const std::string &space, const SceneInput &scene)
{
    const std::string_view object = "object:";
    if (space == "eye")
        return BatchSpace{BatchSpace::Kind::Eye, glm::dmat4(1.0)};
    if (space == "world")
        return BatchSpace{};
    if (!space.starts_with(object)) {
        complain("--space " + space + ": give eye, world or object:NAME");
        return std::nullopt;
    }
    const PlacedObject *placed = objectNamed(scene, space.substr(object.size()));
    if (placed == nullptr)
        return std::nullopt;
    return BatchSpace{BatchSpace::Kind::Object, placed->worldFromObject};
}

} // namespace unprojector::cli
