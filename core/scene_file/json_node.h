#pragma once

#include "core/scene_file/scene_file_error.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace unprojector::scene_file {

/// A value of a JSON document with its path, or the path of a missing value. A failed query adds an
/// error with the path to the document; only the first error is kept. After an error every query
/// returns a default, so a reader checks `failed` only once, at the end.
///
/// A node refers to its parent, which must outlive it: the path is built only for an error.
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

    /// A member of an object, present or missing.
    JsonNode member(const char *key) const;
    /// The number of elements of the array; 0 after an error.
    std::size_t size() const;
    /// Returns whether it is an array of exactly `count` elements.
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
    /// The index of a text among the allowed words; 0 after an error.
    std::size_t oneOf(std::span<const char *const> words) const;
    /// Reads exactly `count` numbers.
    /// @param expected  the kind that an error names
    void numbers(double *numbers, std::size_t count, JsonKind expected) const;

    void fail(SceneFileError error) const;
    void fail(SceneFileErrorCode code) const;
    /// Adds an error of core about the value.
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
