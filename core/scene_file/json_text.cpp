#include "core/scene_file/json_text.h"

#include "core/text/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace unprojector::scene_file {
using namespace geometry;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineLength = 120;
constexpr double kExact = 9007199254740992.0; // 2^53: all smaller whole numbers are doubles

std::string_view keptDigits(const Json &json)
{
    const Json::binary_t &bytes = json.get_binary();
    return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
}

/// The same digits as in all other texts: the library's differ in the last one if two are equally
/// near.
std::string numberText(double value)
{
    if (!std::isfinite(value)) // JSON has no such number
        return "null";
    std::string digits = text::shortestText(value);
    if (digits.find_first_of(".e") != std::string::npos)
        return digits;
    if (std::abs(value) < kExact)
        return digits + ".0";
    std::array<char, 32> power; // written in full, most of its digits would be meaningless
    const auto end = std::to_chars(power.data(), power.data() + power.size(), value, std::chars_format::scientific);
    return {power.data(), end.ptr};
}

std::string leafText(const Json &leaf, Json::error_handler_t badText)
{
    if (leaf.is_binary())
        return std::string(keptDigits(leaf));
    return leaf.is_number_float() ? numberText(leaf.get<double>()) : leaf.dump(-1, ' ', false, badText);
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

Json readNumber(double value, const std::string &written)
{
    constexpr std::ptrdiff_t kDigitsOfDoubles = 15; // any number with this many survives
    const std::string_view mantissa(written.data(), std::min(written.find_first_of("eE"), written.size()));
    const auto digits = std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (digits <= kDigitsOfDoubles || numberText(value) == written)
        return value;
    return Json::binary(std::vector<std::uint8_t>(written.begin(), written.end()));
}

bool isNumber(const Json &json)
{
    return json.is_number() || json.is_binary();
}

double numberOf(const Json &json)
{
    if (!json.is_binary())
        return json.get<double>();
    double value = 0.0;
    const std::string_view digits = keptDigits(json);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    // Only a number that is too small for a double is left: the parser rejects numbers that are too
    // large.
    return read.ec == std::errc() ? value : 0.0;
}

Json jsonNumber(double value)
{
    if (value == std::floor(value) && std::abs(value) < kExact && !(value == 0.0 && std::signbit(value)))
        return static_cast<std::int64_t>(value);
    return value;
}

} // namespace unprojector::scene_file
