#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace unprojector::scene_file {

/// JSON laid out for people: what fits on a line stands on one, so that vectors and small objects are read at a glance.
/// Ends with a line feed. Numbers have all their digits.
/// @throw nlohmann::json::type_error  for text that is not UTF-8
std::string readableJson(const nlohmann::ordered_json &json);

/// A number as a person would write it: 1, not 1.0, where it is whole.
nlohmann::ordered_json jsonNumber(double value);

} // namespace unprojector::scene_file
