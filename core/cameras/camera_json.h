#pragma once

#include "core/cameras/foreign_camera.h"

#include <nlohmann/json_fwd.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

class Reading;

// JSON of other programs. A reader includes <nlohmann/json.hpp>.

/// Returns whether a text begins as a JSON object or list.
bool isJson(std::string_view text);

/// The document. Throws a base::Error with the position and reason of a mistake in its syntax.
nlohmann::ordered_json parsedJson(const NamedText &text);

/// The line, from 1, on which a key of a JSON text stands.
/// @param count  the key's index among the equal keys of the text, from 0
/// @return 0 if there is no such key
std::size_t lineOfKey(std::string_view text, std::string_view key, std::size_t count = 0);

/// The line of a member of an object of a JSON text; without the member, the object's own.
/// @param object  any copy of it
/// @return lineOfKey() if no object of the text is equal
std::size_t lineOfMember(std::string_view text, const nlohmann::ordered_json &object, std::string_view key);

/// The member of an object; null if there is none.
const nlohmann::ordered_json *memberOf(const nlohmann::ordered_json &object, std::string_view key);

/// The finite numbers of a member, nested lists one after the other; empty if there is none, or if it
/// has anything else. A single number is a list of one.
std::vector<double> numbersOf(const nlohmann::ordered_json &object, std::string_view key);

using JsonKeys = std::initializer_list<const char *>;

/// The document of a JSON text that has all these keys; null for another text. Throws as parsedJson().
nlohmann::ordered_json documentWith(const NamedText &text, JsonKeys keys);
/// The same for keys that other programs have, too: null for a mistake in the syntax. A reader of texts
/// may take it.
nlohmann::ordered_json strictDocumentWith(const NamedText &text, JsonKeys keys);

/// The value along a path of keys; null where a key is missing.
const nlohmann::ordered_json &inside(const nlohmann::ordered_json &object, JsonKeys path);

/// A member's text, or its value as JSON; empty without the member.
std::string wordOf(const nlohmann::ordered_json &object, std::string_view key);

/// The elements of a list; another value itself.
std::vector<const nlohmann::ordered_json *> elementsOf(const nlohmann::ordered_json &value);

/// The element of a list whose member is this word; null if there is none.
const nlohmann::ordered_json &entryOf(const nlohmann::ordered_json &list, std::string_view key,
                                      const std::string &word);

/// The finite numbers of a member, each a number or, as AliceVision writes it, a text.
std::vector<double> spelledNumbers(const nlohmann::ordered_json &object, std::string_view key);
/// The same, of a single number.
std::optional<double> spelledNumber(const nlohmann::ordered_json &object, std::string_view key);
/// The same; for another count it fails, in the line of the object's key.
std::vector<double> neededNumbers(const Reading &reading, const nlohmann::ordered_json &object, std::string_view key,
                                  std::size_t count);
double neededNumber(const Reading &reading, const nlohmann::ordered_json &object, std::string_view key);
glm::dvec3 neededVector(const Reading &reading, const nlohmann::ordered_json &object, std::string_view key);

/// The text of a member; the index if there is none.
std::string nameOf(const nlohmann::ordered_json &object, std::string_view key, std::size_t index);

/// A finite number among an object's members.
std::optional<double> numberOf(const nlohmann::ordered_json &object, std::string_view key);

} // namespace unprojector::cameras
