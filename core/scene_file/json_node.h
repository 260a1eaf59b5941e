#pragma once

#include "core/scene_file/scene_file_error.h"

#include <nlohmann/json.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::scene_file {

/// A value of a JSON document and the path to it. What is asked of it and is not so is noted as the document's error,
/// with the path; only the first is kept. After an error everything reads as a default, so that a reader need not ask
/// after each step: it asks `failed` once at the end.
class JsonNode {
public:
    using Json = nlohmann::ordered_json;
    using FirstError = std::optional<SceneFileError>;

    JsonNode(const Json &json, FirstError &error) : m_json(&json), m_error(&error) {}

    bool failed() const { return m_error->has_value(); }
    const std::string &path() const { return m_path; }

    /// A member that must be there, or one that may be missing.
    JsonNode member(const char *key) const;
    std::optional<JsonNode> optionalMember(const char *key) const;
    /// All elements of an array.
    std::vector<JsonNode> elements() const;
    /// Exactly so many elements.
    std::vector<JsonNode> elements(std::size_t count, JsonKind expected) const;

    double number() const;
    /// A whole number within both ends.
    int count(int lowest, int highest) const;
    double numberBetween(double lowest, double highest) const;
    bool boolean() const;
    std::string text() const;
    glm::dvec3 vector3() const;
    glm::dvec4 vector4() const;
    /// 16 numbers, column by column.
    glm::dmat4 matrix() const;

    /// The one key of `choices` that the object has; it must have no other key. Empty after an error.
    std::string oneKeyOf(std::initializer_list<const char *> choices) const;
    /// The members whose keys are none of these; null where there are none.
    Json except(std::initializer_list<const char *> known) const;
    void mustBeObject() const;
    /// The value as JSON, shortened, for a message.
    std::string shown() const;

    void fail(SceneFileError error) const;
    void fail(SceneFileErrorCode code) const;
    /// What core says of a value.
    void fail(const Error &cause) const;

private:
    JsonNode child(const Json &json, const std::string &step) const;
    bool is(JsonKind kind, JsonKind expected) const;

    const Json *m_json;
    FirstError *m_error;
    std::string m_path;
};

} // namespace unprojector::scene_file
