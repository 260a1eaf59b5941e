#include "core/scene_file/json_text.h"
#include "core/scene_file/scene_fields.h"
#include "core/scene_file/scene_file.h"
#include "core/scene_file/strict_json.h"

#include <nlohmann/json.hpp>

namespace unprojector::scene_file {
using namespace geometry;

namespace {

Result<SceneFile, SceneFileError> readScene(const Result<nlohmann::ordered_json, SceneFileError> &json,
                                            const std::string &name)
{
    JsonNode::FirstError error;
    if (json) {
        SceneFile scene;
        static_cast<void>(FieldReader::read(JsonNode(*json, error), scene, Plain{}));
        if (!error)
            return scene;
    } else {
        error = json.error();
    }
    error->file = name;
    return *error;
}

} // namespace

Result<SceneFile, SceneFileError> parseScene(std::string_view text, const std::string &name, std::size_t mostBytes)
{
    return readScene(parseStrictJson(text, mostBytes), name);
}

Result<SceneFile, SceneFileError> changed(const SceneFile &scene, const base::JsonValue &change,
                                          const std::string &name)
{
    nlohmann::ordered_json document = FieldWriter::write(scene, Plain{}, nullptr);
    document.merge_patch(change.json());
    return readScene(std::move(document), name);
}

Result<std::string, SceneFileError> sceneText(const SceneFile &scene)
{
    return readableJson(FieldWriter::write(scene, Plain{}, nullptr));
}

} // namespace unprojector::scene_file
