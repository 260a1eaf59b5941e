#include "core/base/json_number.h"

#include "core/base/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <vector>

namespace unprojector::base {
using Json = nlohmann::ordered_json;
namespace {

constexpr double kExact = 9007199254740992.0; // 2^53: all smaller whole numbers are doubles

std::string_view keptDigits(const Json &json)
{
    const Json::binary_t &bytes = json.get_binary();
    return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
}

/// The same digits as in all other texts: the library's differ in the last one if two are equally
/// near.
std::string floatText(double value)
{
    if (!std::isfinite(value)) // JSON has no such number
        return "null";
    std::string digits = shortestText(value);
    if (digits.find_first_of(".e") != std::string::npos)
        return digits;
    if (std::abs(value) < kExact)
        return digits + ".0";
    std::array<char, 32> power; // written in full, most of its digits would be meaningless
    const auto end = std::to_chars(power.data(), power.data() + power.size(), value, std::chars_format::scientific);
    return {power.data(), end.ptr};
}

} // namespace

Json readJsonNumber(double value, const std::string &written)
{
    constexpr std::ptrdiff_t kDigitsOfDoubles = 15; // any number with this many survives
    const std::string_view mantissa(written.data(), std::min(written.find_first_of("eE"), written.size()));
    const auto digits = std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (digits <= kDigitsOfDoubles || floatText(value) == written)
        return value;
    return Json::binary(std::vector<std::uint8_t>(written.begin(), written.end()));
}

bool isJsonNumber(const Json &json)
{
    return json.is_number() || json.is_binary();
}

double valueOfJsonNumber(const Json &json)
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

std::string jsonNumberText(const Json &json)
{
    if (json.is_binary())
        return std::string(keptDigits(json));
    return json.is_number_float() ? floatText(json.get<double>()) : json.dump();
}

} // namespace unprojector::base
