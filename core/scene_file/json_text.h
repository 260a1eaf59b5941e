#pragma once

#include "core/scene_file/scene_file_error.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace unprojector::scene_file {

/// JSON formatted for people: a value that fits on a line takes one line, so that vectors and small
/// objects are easy to read. Ends with a line feed. Numbers have all their digits.
/// @return NotUtf8, with the path of the first text that is not
geometry::Result<std::string, SceneFileError> readableJson(const nlohmann::ordered_json &json);

/// The same on a single line, without a line feed. Invalid UTF-8 is replaced.
std::string jsonLine(const nlohmann::ordered_json &json);
/// The same without blanks.
std::string compactJson(const nlohmann::ordered_json &json);

/// A number as a person would write it: a whole number as 1, not 1.0.
nlohmann::ordered_json jsonNumber(double value);

} // namespace unprojector::scene_file
