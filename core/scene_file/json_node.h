#pragma once

#include "core/scene_file/scene_file_error.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace unprojector::scene_file {

/// A value of a JSON document and its place in it, or the place of one that is missing. What is asked of it and is not so
/// is noted as the document's error, with the place; only the first is kept. After an error everything reads as a default,
/// so that a reader need not ask after each step: it asks `failed` once at the end.
///
/// A node leans on the one it is a part of, which must live as long: the path is only put together for an error.
class JsonNode {
public:
    using Json = nlohmann::ordered_json;
    using FirstError = std::optional<SceneFileError>;

    JsonNode(const Json &root, FirstError &error) : m_json(&root), m_error(&error) {}
    JsonNode(const JsonNode &) = delete;
    JsonNode &operator=(const JsonNode &) = delete;

    bool failed() const { return m_error->has_value(); }
    bool exists() const { return m_json != nullptr; }
    /// "objects[0].transform[1].rotate"; empty for the whole document.
    std::string path() const;
    /// @pre exists()
    const Json &json() const { return *m_json; }

    /// A member of an object, there or missing.
    JsonNode member(const char *key) const;
    /// How many elements the array has; 0 after an error.
    std::size_t size() const;
    /// Whether it is an array of exactly so many elements.
    bool hasSize(std::size_t count, JsonKind expected) const;
    /// @pre index < size()
    JsonNode element(std::size_t index) const { return {(*m_json)[index], *this, nullptr, index}; }

    bool isObject() const { return is(JsonKind::Object, JsonKind::Object); }
    double number() const;
    double numberBetween(double lowest, double highest) const;
    /// A whole number within both ends.
    int count(int lowest, int highest) const;
    bool boolean() const;
    std::string text() const;
    /// The place of a text among the words that it may be; 0 after an error.
    std::size_t oneOf(std::span<const char *const> words) const;
    /// Exactly so many numbers.
    /// @param expected  what an error calls them
    void numbers(double *numbers, std::size_t count, JsonKind expected) const;

    void fail(SceneFileError error) const;
    void fail(SceneFileErrorCode code) const;
    /// What core says of a value.
    void fail(const geometry::Error &cause) const;

private:
    JsonNode(const Json &json, const JsonNode &parent, const char *key, std::size_t index)
        : m_json(&json), m_error(parent.m_error), m_parent(&parent), m_key(key), m_place(index)
    {
    }
    JsonNode(const JsonNode &parent, const char *key) : m_error(parent.m_error), m_parent(&parent), m_key(key) {}

    bool is(JsonKind kind, JsonKind expected) const;

    const Json *m_json = nullptr;
    FirstError *m_error;
    const JsonNode *m_parent = nullptr;
    const char *m_key = nullptr; ///< none for an element
    std::size_t m_place = 0;
};

} // namespace unprojector::scene_file
