#pragma once

#include "core/base/error.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// JSON: parsed strictly, and written for people. Code that works with a value includes
// <nlohmann/json.hpp>, whose 25,000 lines this header spares all others.
//
// A number that another program wrote with more digits than a double holds is kept as written, so
// that rewriting does not change it. JSON has no such type: a binary value, which no text can have,
// represents it. So ask isJsonNumber(), not the library's is_number().

namespace unprojector::base {

using Json = nlohmann::ordered_json;

/// A JSON value to keep in a struct. Copies share the value until one of them is edited, so a copy
/// costs a pointer.
class JsonValue {
public:
    JsonValue() = default; ///< null
    /// Explicit, because braces that are an object in JSON would become a list here. For those, see
    /// edit().
    explicit JsonValue(Json json);

    const Json &json() const;
    /// The value to change. The reference is valid until this object is copied, assigned or
    /// destroyed.
    Json &edit();

    friend bool operator==(const JsonValue &a, const JsonValue &b);

private:
    std::shared_ptr<Json> m_json; ///< none for null
};

/// The deepest nesting of brackets, which the writer's stack allows.
constexpr std::size_t kMostJsonLevels = 64;

/// Parses a text. Rejects duplicate keys, nesting beyond kMostJsonLevels, numbers beyond the range
/// of doubles, zero bytes and all that is not UTF-8. A byte order mark may come first.
/// @param file  its name, for the error
/// @return an error with line and column; without them for an empty file
Expected<Json, Error> parseJson(std::string_view text, const std::string &file = {});

/// Returns whether the value of a key may have duplicate keys, because no one reads it.
/// @param object  the key whose value is the object that contains the key
using IsUnread = std::function<bool(std::string_view object, std::string_view key)>;
/// Checks a text as parseJson does, for another parser that is less strict.
Done checkJson(std::string_view text, std::size_t mostLevels, const IsUnread &isUnread);

/// A step from a value to one inside it: a member, or an element.
struct JsonStep {
    std::string_view key; ///< without data for an element
    std::size_t index = 0;
};
using JsonPath = std::vector<JsonStep>;

/// Sets an error's subject to the path of a value, and its line and column. Reads the text only up
/// to the value.
/// @return false if there is no such value, or a mistake comes before it
bool setPlace(Error &error, std::string_view text, const JsonPath &path);

/// Returns whether a text is a number in JSON's syntax.
bool isJsonNumber(std::string_view text);
/// Returns whether a value is a number, including one kept as written.
bool isJsonNumber(const Json &json);
/// The value of a number. @pre isJsonNumber(json)
double valueOfJsonNumber(const Json &json);
/// A number as a person would write it: a whole number as 1, not 1.0.
Json jsonNumber(double value);

/// JSON formatted for people: a value that fits on a line takes one line, so that vectors and small
/// objects are easy to read. Ends with a line feed. Numbers have all their digits.
/// @return an error with the path of the first text that is not UTF-8
Expected<std::string, Error> readableJson(const Json &json);
/// The same on a single line, without a line feed. Invalid UTF-8 is replaced.
std::string jsonLine(const Json &json);
/// The same without blanks.
std::string compactJson(const Json &json);

} // namespace unprojector::base
