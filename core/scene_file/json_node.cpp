#include "core/scene_file/json_node.h"

#include "core/scene_file/strict_json.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace unprojector::scene_file {
namespace {

using Json = nlohmann::ordered_json;

const Json &nullJson()
{
    static const Json null;
    return null;
}

JsonKind kindOf(const Json &json)
{
    if (json.is_null())
        return JsonKind::Null;
    if (json.is_boolean())
        return JsonKind::Boolean;
    if (json.is_number())
        return JsonKind::Number;
    if (json.is_string())
        return JsonKind::Text;
    return json.is_array() ? JsonKind::Array : JsonKind::Object;
}

bool isOneOf(std::initializer_list<const char *> keys, const std::string &key)
{
    return std::any_of(keys.begin(), keys.end(), [&](const char *one) { return key == one; });
}

} // namespace

void JsonNode::fail(SceneFileError error) const
{
    if (failed())
        return;
    if (error.keyPath.empty())
        error.keyPath = m_path;
    *m_error = std::move(error);
}

void JsonNode::fail(SceneFileErrorCode code) const
{
    SceneFileError error;
    error.code = code;
    fail(std::move(error));
}

void JsonNode::fail(const Error &cause) const
{
    SceneFileError error;
    error.code = SceneFileErrorCode::InvalidValue;
    error.cause = cause;
    fail(std::move(error));
}

JsonNode JsonNode::child(const Json &json, const std::string &step) const
{
    JsonNode node(json, *m_error);
    node.m_path = m_path.empty() || step.front() == '[' ? m_path + step : m_path + "." + step;
    return node;
}

bool JsonNode::is(JsonKind kind, JsonKind expected) const
{
    if (failed())
        return false;
    if (kindOf(*m_json) == kind)
        return true;
    SceneFileError error;
    error.code = SceneFileErrorCode::WrongType;
    error.expectedKind = expected;
    error.foundKind = kindOf(*m_json);
    if (m_json->is_string())
        error.found = shortened(m_json->get_ref<const std::string &>());
    fail(std::move(error));
    return false;
}

void JsonNode::mustBeObject() const
{
    static_cast<void>(is(JsonKind::Object, JsonKind::Object));
}

std::string JsonNode::shown() const
{
    return shortened(m_json->dump());
}

std::optional<JsonNode> JsonNode::optionalMember(const char *key) const
{
    if (!is(JsonKind::Object, JsonKind::Object))
        return std::nullopt;
    const auto found = m_json->find(key);
    if (found == m_json->end())
        return std::nullopt;
    return child(*found, key);
}

JsonNode JsonNode::member(const char *key) const
{
    if (std::optional<JsonNode> found = optionalMember(key))
        return *found;
    const JsonNode missing = child(nullJson(), key);
    missing.fail(SceneFileErrorCode::Missing); // unless it was noted already that this is no object
    return missing;
}

std::vector<JsonNode> JsonNode::elements() const
{
    std::vector<JsonNode> nodes;
    if (!is(JsonKind::Array, JsonKind::Array))
        return nodes;
    nodes.reserve(m_json->size());
    for (const Json &element : *m_json)
        nodes.push_back(child(element, "[" + std::to_string(nodes.size()) + "]"));
    return nodes;
}

std::vector<JsonNode> JsonNode::elements(std::size_t count, JsonKind expected) const
{
    if (!is(JsonKind::Array, expected))
        return {};
    if (m_json->size() != count) {
        SceneFileError error;
        error.code = SceneFileErrorCode::WrongCount;
        error.expectedKind = expected;
        error.value = double(m_json->size());
        error.limit = double(count);
        fail(std::move(error));
        return {};
    }
    return elements();
}

double JsonNode::number() const
{
    return is(JsonKind::Number, JsonKind::Number) ? m_json->get<double>() : 0.0;
}

double JsonNode::numberBetween(double lowest, double highest) const
{
    const double value = number();
    if (failed() || (value >= lowest && value <= highest))
        return value;
    SceneFileError error;
    error.code = SceneFileErrorCode::OutOfRange;
    error.value = value;
    error.lowest = lowest;
    error.limit = highest;
    fail(std::move(error));
    return lowest;
}

int JsonNode::count(int lowest, int highest) const
{
    const double value = numberBetween(lowest, highest);
    if (failed())
        return lowest;
    if (value != std::floor(value)) {
        SceneFileError error;
        error.code = SceneFileErrorCode::NotWhole;
        error.value = value;
        fail(std::move(error));
        return lowest;
    }
    return static_cast<int>(value);
}

bool JsonNode::boolean() const
{
    return is(JsonKind::Boolean, JsonKind::Boolean) && m_json->get<bool>();
}

std::string JsonNode::text() const
{
    return is(JsonKind::Text, JsonKind::Text) ? m_json->get<std::string>() : std::string();
}

glm::dvec3 JsonNode::vector3() const
{
    glm::dvec3 v(0.0);
    int i = 0;
    for (const JsonNode &node : elements(3, JsonKind::ThreeNumbers))
        v[i++] = node.number();
    return v;
}

glm::dvec4 JsonNode::vector4() const
{
    glm::dvec4 v(0.0);
    int i = 0;
    for (const JsonNode &node : elements(4, JsonKind::FourNumbers))
        v[i++] = node.number();
    return v;
}

glm::dmat4 JsonNode::matrix() const
{
    glm::dmat4 m(0.0);
    int i = 0;
    for (const JsonNode &node : elements(16, JsonKind::Matrix)) {
        m[i / 4][i % 4] = node.number();
        ++i;
    }
    return m;
}

std::string JsonNode::oneKeyOf(std::initializer_list<const char *> choices) const
{
    if (!is(JsonKind::Object, JsonKind::Object))
        return {};
    if (m_json->size() == 1 && isOneOf(choices, m_json->begin().key()))
        return m_json->begin().key();
    SceneFileError error;
    error.code = SceneFileErrorCode::NotOneChoice;
    error.choices.assign(choices.begin(), choices.end());
    fail(std::move(error));
    return {};
}

JsonNode::Json JsonNode::except(std::initializer_list<const char *> known) const
{
    Json rest;
    if (failed() || !m_json->is_object())
        return rest;
    const auto &members = m_json->get_ref<const Json::object_t &>();
    for (const auto &[key, value] : members) {
        if (isOneOf(known, key)) {
            continue;
        }
        if (rest.is_null())
            rest = Json::object();
        static_cast<Json::object_t::Container &>(rest.get_ref<Json::object_t &>()).emplace_back(key, value);
    }
    return rest;
}

} // namespace unprojector::scene_file
