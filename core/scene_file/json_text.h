#pragma once

#include "core/scene_file/scene_file_error.h"

#include <nlohmann/json.hpp>

#include <string>

namespace unprojector::scene_file {

/// JSON laid out for people: what fits on a line stands on one, so that vectors and small objects are read at a glance.
/// Ends with a line feed. Numbers have all their digits.
/// @return NotUtf8, with the place of the first text that is not
Result<std::string, SceneFileError> readableJson(const nlohmann::ordered_json &json);

/// The same on a single line, without a line feed. What is not UTF-8 is replaced.
std::string jsonLine(const nlohmann::ordered_json &json);

/// A number as a person would write it: 1, not 1.0, where it is whole.
nlohmann::ordered_json jsonNumber(double value);

} // namespace unprojector::scene_file
