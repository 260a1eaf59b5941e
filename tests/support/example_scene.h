#pragma once

#include "core/examples/examples.h"
#include "core/opening/models.h"
#include "core/scene_file/scene_file.h"

#include <QtGlobal>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

/// The scene of one of examples::kExamples, with its models.
inline const unprojector::scene::Scene &sceneOfExample(std::string_view id)
{
    namespace files = unprojector::scene_file;
    static std::map<std::string, unprojector::scene::Scene> scenes;
    const std::string name(id);
    if (const auto known = scenes.find(name); known != scenes.end())
        return known->second;
    const auto file = files::parseScene(unprojector::examples::exampleScene(id), name);
    if (!file)
        qFatal("%s", file.error().message().c_str());
    auto objects = unprojector::opening::objectsOf(*file, {}, [](const std::filesystem::path &) {
        return unprojector::opening::ReadModel(unprojector::base::Error{}); // no example names a file
    });
    if (!objects)
        qFatal("%s: %s", name.c_str(), objects.error().message().c_str());
    const auto scene = files::sceneFromFile(*file, name, std::move(objects).value());
    if (!scene)
        qFatal("%s", scene.error().message().c_str());
    return scenes.emplace(name, *scene).first->second;
}
