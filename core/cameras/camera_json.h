#pragma once

#include "core/cameras/foreign_camera.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

// JSON of other programs. A reader includes <nlohmann/json.hpp>.

/// Returns whether a text begins as a JSON object or list.
bool isJson(std::string_view text);

/// The document. Throws a base::Error with the position and reason of a mistake in its syntax.
nlohmann::ordered_json parsedJson(const NamedText &text);

/// The line, from 1, on which a key of a JSON text stands.
/// @param count  the key's index among the equal keys of the text, from 0
/// @return 0 if there is no such key
std::size_t lineOfKey(std::string_view text, std::string_view key, std::size_t count = 0);

/// The member of an object; null if there is none.
const nlohmann::ordered_json *memberOf(const nlohmann::ordered_json &object, std::string_view key);

/// The finite numbers of a member, nested lists one after the other; empty if there is none, or if it
/// has anything else. A single number is a list of one.
std::vector<double> numbersOf(const nlohmann::ordered_json &object, std::string_view key);

/// The text of a member; the index if there is none.
std::string nameOf(const nlohmann::ordered_json &object, std::string_view key, std::size_t index);

/// A finite number among an object's members.
std::optional<double> numberOf(const nlohmann::ordered_json &object, std::string_view key);

} // namespace unprojector::cameras
