#pragma once

#include "core/scene_file/scene_file.h"

#include <nlohmann/json.hpp>

#include <QByteArray>

#include <utility>

/// Scene files there and back, for tests.
namespace scene_texts {

inline unprojector::scene_file::SceneFile parsed(const QByteArray &text)
{
    const auto scene =
        unprojector::scene_file::parseScene(std::string_view(text.constData(), std::size_t(text.size())), "scene.json");
    if (!scene)
        qFatal("%s", scene.error().message().c_str());
    return *scene;
}

/// The message of an error of a value, without the line and the column, which it must have.
inline QByteArray messageWithoutPlace(unprojector::base::Error error)
{
    if (std::exchange(error.line, 0) == 0 || std::exchange(error.column, 0) == 0)
        return "no place: " + QByteArray::fromStdString(error.message());
    return QByteArray::fromStdString(error.message());
}

inline QByteArray written(const unprojector::scene_file::SceneFile &scene)
{
    return QByteArray::fromStdString(sceneText(scene).value());
}

/// The objects of a scene file, all with this model.
inline std::vector<unprojector::scene::SceneObject>
objectsWith(const std::shared_ptr<const unprojector::mesh::Model> &model,
            const unprojector::scene_file::SceneFile &scene, const std::filesystem::path &sceneFile)
{
    std::vector<unprojector::scene::SceneObject> objects;
    for (const unprojector::scene_file::SceneFileObject &object : scene.objects)
        objects.push_back(
            {object.name, objectFile(object, sceneFile), model, object.transform, object.isHidden, object.extra});
    return objects;
}

using Json = nlohmann::ordered_json;

/// Puts an unknown key into every object that has room for one; the steps of a transform have none.
/// @return their number
inline std::size_t mark(Json &json)
{
    std::size_t marks = 0;
    for (const auto &[key, member] : json.items()) {
        if (member.is_structured() && key != "transform")
            marks += mark(member);
    }
    if (!json.is_object())
        return marks;
    json["mark"] = {{"deep", {1, 2.5, nullptr, true}}};
    return marks + 1;
}

/// The number of marks that are still in place.
inline std::size_t marksIn(const Json &json, const Json &marked)
{
    std::size_t marks = 0;
    if (marked.is_array()) {
        for (std::size_t i = 0; i < marked.size() && i < json.size(); ++i)
            marks += marksIn(json[i], marked[i]);
    }
    if (!marked.is_object() || !json.is_object())
        return marks;
    for (const auto &[key, value] : marked.items()) {
        if (key == "mark")
            marks += json.contains(key) && json[key] == value ? 1 : 0;
        else if (json.contains(key))
            marks += marksIn(json[key], value);
    }
    return marks;
}

} // namespace scene_texts
