#include "core/scene/bundled_models.h"

#include "core/scene/bundled_scene.h"
#include "core/scene/examples.h"

namespace unprojector::scene {

std::map<std::string, std::shared_ptr<const Model>> bundledModels()
{
    std::map<std::string, std::shared_ptr<const Model>> models;
    const auto add = [&models](const std::vector<SceneObject> &objects) {
        for (const SceneObject &object : objects)
            models.try_emplace(object.model->name, object.model); // the first of a name is it
    };
    add(bundledScene());
    for (const Example &example : examples())
        add(example.scene.objects);
    return models;
}

} // namespace unprojector::scene
