#include "core/scene_file/landmark_fields.h"

#include <cmath>

namespace unprojector::scene_file {

using Json = nlohmann::ordered_json;

void ElementNumber::read(const JsonNode &node, std::uint32_t &number)
{
    const double value = node.numberBetween(0.0, double(std::numeric_limits<std::uint32_t>::max()));
    if (value == std::floor(value)) {
        number = static_cast<std::uint32_t>(value);
        return;
    }
    SceneFileError error;
    error.code = SceneFileErrorCode::NotWhole;
    error.value = value;
    node.fail(std::move(error));
}

void EdgeNumbers::read(const JsonNode &node, std::array<std::uint32_t, 2> &vertices)
{
    if (!node.hasSize(vertices.size(), JsonKind::TwoNumbers))
        return;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        ElementNumber::read(node.element(i), vertices[i]);
}

Json EdgeNumbers::write(const std::array<std::uint32_t, 2> &vertices)
{
    return Json::array({vertices[0], vertices[1]});
}

void ColorNumbers::read(const JsonNode &node, glm::u8vec3 &color)
{
    if (!node.hasSize(3, JsonKind::ThreeNumbers))
        return;
    for (int i = 0; i < 3; ++i)
        color[i] = static_cast<std::uint8_t>(node.element(std::size_t(i)).count(0, 255));
}

Json ColorNumbers::write(const glm::u8vec3 &color)
{
    return Json::array({int(color.r), int(color.g), int(color.b)});
}

} // namespace unprojector::scene_file
