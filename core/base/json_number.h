#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace unprojector::base {

// A number that another program wrote with more digits than a double holds is kept as written, so
// that rewriting does not change it. JSON has no such type: a binary value, which no text can have,
// represents it. So ask isJsonNumber(), not the library's is_number().

/// @param written  a number in JSON's own form
/// @param value    its value as a double
nlohmann::ordered_json readJsonNumber(double value, const std::string &written);
/// Returns whether it is a number, including one kept as written.
bool isJsonNumber(const nlohmann::ordered_json &json);
/// The value of a number. @pre isJsonNumber(json)
double valueOfJsonNumber(const nlohmann::ordered_json &json);
/// The digits of a number: all of them, as written where they are kept. @pre isJsonNumber(json)
std::string jsonNumberText(const nlohmann::ordered_json &json);

} // namespace unprojector::base
