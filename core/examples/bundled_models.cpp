#include "core/examples/bundled_models.h"

#include "core/examples/bundled_scene.h"
#include "core/examples/examples.h"
#include "core/examples/head.h"

namespace unprojector::examples {
using namespace mesh;
using namespace scene;

namespace {

std::map<std::string, std::shared_ptr<const Model>> builtModels()
{
    std::map<std::string, std::shared_ptr<const Model>> models;
    const auto add = [&models](const std::vector<SceneObject> &objects) {
        for (const SceneObject &object : objects)
            models.try_emplace(object.model->name, object.model); // the first model of a name is used
    };
    add(bundledScene());
    const auto head = std::make_shared<Model>();
    head->name = "Head";
    head->meshes.push_back(headMesh());
    head->meshes.front().baseColor = {0.85f, 0.75f, 0.67f, 1.0f};
    head->bounds = boundsOf(head->meshes);
    models.try_emplace(head->name, head);
    for (const Example &example : examples())
        add(example.scene.objects);
    return models;
}

} // namespace

const std::map<std::string, std::shared_ptr<const Model>> &bundledModels()
{
    static const std::map<std::string, std::shared_ptr<const Model>> models = builtModels();
    return models;
}

} // namespace unprojector::examples
