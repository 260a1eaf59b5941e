#include "core/scene_file/lost_keys.h"

#include "core/scene_file/scene_file.h"

#include <nlohmann/json.hpp>

namespace unprojector::scene_file {
using base::Json;
namespace {

std::string element(const std::string &list, std::size_t i)
{
    return list + "[" + std::to_string(i) + "]";
}

void addKeys(const Json &object, const std::string &path, std::vector<std::string> &keys)
{
    for (const auto &member : object.items())
        keys.push_back(path + "." + member.key());
}

} // namespace

LostKeys lostKeys(std::string_view text, const SceneFile &scene)
{
    LostKeys lost;
    const base::Expected<Json, base::Error> json = base::parseJson(text);
    for (std::size_t i = 0; json && i < scene.objects.size(); ++i) {
        for (std::size_t j = 0; j < scene.objects[i].transform.size(); ++j) {
            Json step = (*json)["objects"][i]["transform"][j];
            for (const char *known : {"translate", "rotate", "scale"})
                step.erase(known);
            addKeys(step, element(element("objects", i) + ".transform", j), lost.ofSteps);
        }
    }
    for (std::size_t i = 0; i < scene.ui.clipPlanesOff.size(); ++i)
        addKeys(scene.ui.clipPlanesOff[i].extra.json(), element("ui.clipPlanesOff", i), lost.ofPlanes);
    return lost;
}

} // namespace unprojector::scene_file
