#pragma once

#include "core/scene_file/scene_file_error.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace unprojector::scene_file {

/// JSON laid out for people: what fits on a line stands on one, so that vectors and small objects are read at a glance.
/// Ends with a line feed. Numbers have all their digits.
/// @return NotUtf8, with the place of the first text that is not
geometry::Result<std::string, SceneFileError> readableJson(const nlohmann::ordered_json &json);

/// The same on a single line, without a line feed. What is not UTF-8 is replaced.
std::string jsonLine(const nlohmann::ordered_json &json);
/// The same without blanks.
std::string compactJson(const nlohmann::ordered_json &json);

/// A number as a person would write it: 1, not 1.0, where it is whole.
nlohmann::ordered_json jsonNumber(double value);

// A number that somebody else wrote with more digits than a double holds is kept as it is written, so that it is not
// another one when it is written again. JSON has no such kind of value: a binary one, which no text can have, stands for it.

/// @param written  a number in JSON's own form
/// @param value    what it is as a double
nlohmann::ordered_json readNumber(double value, const std::string &written);
/// Whether it is a number, one that is kept as it is written among them.
bool isNumber(const nlohmann::ordered_json &json);
/// @pre isNumber(json)
double numberOf(const nlohmann::ordered_json &json);

} // namespace unprojector::scene_file
