#include "core/scene_file/json_text.h"

#include "core/base/json_number.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::scene_file {
using namespace geometry;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineLength = 120;
constexpr double kExact = 9007199254740992.0; // 2^53: all smaller whole numbers are doubles

std::string leafText(const Json &leaf, Json::error_handler_t badText)
{
    return base::isJsonNumber(leaf) ? base::jsonNumberText(leaf) : leaf.dump(-1, ' ', false, badText);
}

/// Appends everything on one line; stops early beyond `limit` characters.
/// @param blank  after commas and colons
/// @return whether it fits
bool appendOnOneLine(std::string &text, const Json &json, std::size_t limit,
                     Json::error_handler_t badText = Json::error_handler_t::strict, std::string_view blank = " ")
{
    if (!json.is_structured()) {
        text += leafText(json, badText);
        return text.size() <= limit;
    }
    const bool isObject = json.is_object();
    text += isObject ? '{' : '[';
    bool isFirst = true;
    for (auto it = json.begin(); it != json.end(); ++it) {
        if (!std::exchange(isFirst, false))
            text.append(",").append(blank);
        if (isObject)
            text.append(Json(it.key()).dump(-1, ' ', false, badText)).append(":").append(blank);
        if (!appendOnOneLine(text, *it, limit, badText, blank))
            return false;
    }
    text += isObject ? '}' : ']';
    return text.size() <= limit;
}

/// @param reserved  used characters of the line: the indent, the key before, the comma after
void append(std::string &text, const Json &json, std::size_t indent, std::size_t reserved, bool mayBeOneLine)
{
    std::string line;
    if (!json.is_structured() || json.empty()) {
        appendOnOneLine(text, json, std::string::npos);
        return;
    }
    if (mayBeOneLine && reserved < kLineLength && appendOnOneLine(line, json, kLineLength - reserved)) {
        text += line;
        return;
    }
    const bool isObject = json.is_object();
    text += isObject ? "{\n" : "[\n";
    const char *separator = "";
    for (auto it = json.begin(); it != json.end(); ++it) {
        text += separator;
        separator = ",\n";
        text.append(indent + 2, ' ');
        const std::string key = isObject ? Json(it.key()).dump() + ": " : std::string();
        text += key;
        append(text, *it, indent + 2, indent + 3 + key.size(), true);
    }
    text += '\n';
    text.append(indent, ' ');
    text += isObject ? '}' : ']';
}

bool isUtf8(const Json &text)
{
    try {
        static_cast<void>(text.dump());
        return true;
    } catch (const Json::type_error &) {
        return false;
    }
}

/// The path of the first text that is not UTF-8, such as "objects[1].name"; nothing if all are.
std::optional<std::string> placeOfBadText(const Json &json)
{
    if (json.is_string() && !isUtf8(json))
        return std::string();
    if (!json.is_structured())
        return std::nullopt;
    std::size_t place = 0;
    for (auto it = json.begin(); it != json.end(); ++it, ++place) {
        const std::optional<std::string> within = placeOfBadText(*it);
        if (!within)
            continue;
        const bool isNamed = !within->empty() && within->front() != '[';
        return (json.is_object() ? it.key() : '[' + std::to_string(place) + ']') + (isNamed ? "." : "") + *within;
    }
    return std::nullopt;
}

} // namespace

Result<std::string, SceneFileError> readableJson(const Json &json)
{
    try {
        std::string text;
        append(text, json, 0, 0, false);
        text += '\n';
        return text;
    } catch (const Json::type_error &) {
        SceneFileError error;
        error.code = SceneFileErrorCode::NotUtf8;
        error.keyPath = placeOfBadText(json).value_or(std::string());
        return error;
    }
}

std::string jsonLine(const Json &json)
{
    std::string text;
    appendOnOneLine(text, json, std::string::npos, Json::error_handler_t::replace);
    return text;
}

std::string compactJson(const Json &json)
{
    std::string text;
    appendOnOneLine(text, json, std::string::npos, Json::error_handler_t::replace, {});
    return text;
}

Json jsonNumber(double value)
{
    if (value == std::floor(value) && std::abs(value) < kExact && !(value == 0.0 && std::signbit(value)))
        return static_cast<std::int64_t>(value);
    return value;
}

} // namespace unprojector::scene_file
