#include "core/scene_file/json_node.h"

#include "core/base/json_number.h"
#include "core/scene_file/strict_json.h"

#include <cmath>

namespace unprojector::scene_file {
using namespace geometry;

namespace {

using Json = nlohmann::ordered_json;

JsonKind kindOf(const Json &json)
{
    if (json.is_null())
        return JsonKind::Null;
    if (json.is_boolean())
        return JsonKind::Boolean;
    if (base::isJsonNumber(json))
        return JsonKind::Number;
    if (json.is_string())
        return JsonKind::Text;
    return json.is_array() ? JsonKind::Array : JsonKind::Object;
}

} // namespace

std::string JsonNode::path() const
{
    if (m_parent == nullptr)
        return {};
    const std::string before = m_parent->path();
    if (m_key == nullptr)
        return before + '[' + std::to_string(m_place) + ']';
    return before.empty() ? m_key : before + '.' + m_key;
}

void JsonNode::fail(SceneFileError error) const
{
    if (failed())
        return;
    if (error.keyPath.empty())
        error.keyPath = path();
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

bool JsonNode::is(JsonKind kind, JsonKind expected) const
{
    if (failed())
        return false;
    if (!exists()) {
        fail(SceneFileErrorCode::Missing);
        return false;
    }
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

JsonNode JsonNode::member(const char *key) const
{
    if (isObject()) {
        if (const auto found = m_json->find(key); found != m_json->end())
            return {*found, *this, key, 0};
    }
    return {*this, key};
}

std::size_t JsonNode::size() const
{
    return is(JsonKind::Array, JsonKind::Array) ? m_json->size() : 0;
}

bool JsonNode::hasSize(std::size_t count, JsonKind expected) const
{
    if (!is(JsonKind::Array, expected))
        return false;
    if (m_json->size() == count)
        return true;
    SceneFileError error;
    error.code = SceneFileErrorCode::WrongCount;
    error.expectedKind = expected;
    error.value = double(m_json->size());
    error.limit = double(count);
    fail(std::move(error));
    return false;
}

double JsonNode::number() const
{
    return is(JsonKind::Number, JsonKind::Number) ? base::valueOfJsonNumber(*m_json) : 0.0;
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

std::size_t JsonNode::oneOf(std::span<const char *const> words) const
{
    const std::string word = text();
    std::size_t index = 0;
    for (const char *candidate : words) {
        if (word == candidate)
            return index;
        ++index;
    }
    SceneFileError error;
    error.code = SceneFileErrorCode::UnknownChoice;
    error.found = shortened(word);
    error.choices.assign(words.begin(), words.end());
    fail(std::move(error));
    return 0;
}

void JsonNode::numbers(double *numbers, std::size_t count, JsonKind expected) const
{
    if (!hasSize(count, expected))
        return;
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = element(i).number();
}

} // namespace unprojector::scene_file
