#include "core/scene_file/json_text.h"

#include <cmath>
#include <optional>

namespace unprojector::scene_file {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineLength = 120;

/// Appends everything on one line and says whether it stayed within `limit` characters; else stops early.
bool appendOnOneLine(std::string &text, const Json &json, std::size_t limit,
                     Json::error_handler_t badText = Json::error_handler_t::strict)
{
    if (!json.is_structured()) {
        text += json.dump(-1, ' ', false, badText);
        return text.size() <= limit;
    }
    const bool isObject = json.is_object();
    text += isObject ? '{' : '[';
    const char *separator = "";
    for (auto it = json.begin(); it != json.end(); ++it) {
        text += separator;
        separator = ", ";
        if (isObject)
            text += Json(it.key()).dump(-1, ' ', false, badText) + ": ";
        if (!appendOnOneLine(text, *it, limit, badText))
            return false;
    }
    text += isObject ? '}' : ']';
    return text.size() <= limit;
}

/// @param reserved  characters of the line that are taken: the indent, the key before, the comma behind
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

/// "objects[1].name" of the first text that is not UTF-8; nothing where all are.
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

Json jsonNumber(double value)
{
    constexpr double kExact = 9007199254740992.0; // 2^53
    if (value == std::floor(value) && std::abs(value) < kExact && !(value == 0.0 && std::signbit(value)))
        return static_cast<std::int64_t>(value);
    return value;
}

} // namespace unprojector::scene_file
