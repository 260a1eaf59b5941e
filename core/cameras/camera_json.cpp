#include "core/cameras/camera_json.h"

#include "core/base/json.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/reader_parts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::cameras {
using base::Json;
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr std::size_t kMostNumbers = std::size_t{1} << 20;

/// The value of a finite number.
std::optional<double> finiteNumber(const Json &json)
{
    if (!base::isJsonNumber(json))
        return std::nullopt;
    const double value = base::valueOfJsonNumber(json);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

const Json &nothing()
{
    static const Json null;
    return null;
}

bool addNumbers(const Json &value, std::vector<double> &numbers)
{
    if (const auto number = finiteNumber(value); number && numbers.size() < kMostNumbers) {
        numbers.push_back(*number);
        return true;
    }
    if (!value.is_array())
        return false;
    for (const Json &element : value) {
        if (!addNumbers(element, numbers))
            return false;
    }
    return true;
}

} // namespace

bool isJson(std::string_view text)
{
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && (text[begin] == '{' || text[begin] == '[');
}

Json parsedJson(const NamedText &text)
{
    if (text.text.size() > kMostBytes)
        throw base::Error{.text = base::tr("longer than %1 MiB; give the file of one camera", kMostBytes >> 20),
                          .file = text.name};
    auto parsed = base::parseJson(text.text);
    if (!parsed)
        throw base::Error{.text = parsed.error().text, .file = text.name, .line = parsed.error().line};
    return std::move(parsed).value();
}

std::size_t lineOfKey(std::string_view text, std::string_view key, std::size_t count)
{
    const std::string quoted = '"' + std::string(key) + '"';
    std::size_t line = 1, counted = 0;
    for (std::size_t at = text.find(quoted); at != std::string_view::npos; at = text.find(quoted, at + 1)) {
        const std::size_t next = text.find_first_not_of(" \t\r\n", at + quoted.size());
        if (next == std::string_view::npos || text[next] != ':' || counted++ < count)
            continue;
        for (const char c : text.substr(0, at))
            line += c == '\n' ? 1 : 0;
        return line;
    }
    return 0;
}

const Json *memberOf(const Json &object, std::string_view key)
{
    if (!object.is_object())
        return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

std::vector<double> numbersOf(const Json &object, std::string_view key)
{
    const Json *member = memberOf(object, key);
    std::vector<double> numbers;
    return member && addNumbers(*member, numbers) ? numbers : std::vector<double>();
}

Json documentWith(const NamedText &text, JsonKeys keys)
{
    const auto has = [&](const char *key) { return text.text.find('"' + std::string(key) + '"') != text.text.npos; };
    return isJson(text.text) && std::all_of(keys.begin(), keys.end(), has) ? parsedJson(text) : Json();
}

const Json &inside(const Json &object, JsonKeys path)
{
    const Json *at = &object;
    for (auto key = path.begin(); key != path.end() && at; ++key)
        at = memberOf(*at, *key);
    return at ? *at : nothing();
}

std::string wordOf(const Json &object, std::string_view key)
{
    const Json *member = memberOf(object, key);
    return !member ? std::string() : member->is_string() ? member->get<std::string>() : base::compactJson(*member);
}

std::vector<const Json *> elementsOf(const Json &value)
{
    std::vector<const Json *> elements;
    for (const Json &element : value)
        elements.push_back(&element);
    return value.is_array() ? elements : std::vector{&value};
}

const Json &entryOf(const Json &list, std::string_view key, const std::string &word)
{
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const Json &entry) { return wordOf(entry, key) == word; });
    return found == list.end() ? nothing() : *found;
}

std::vector<double> spelledNumbers(const Json &object, std::string_view key)
{
    const Json *member = memberOf(object, key);
    const auto isText = [](const Json &element) { return element.is_string(); };
    // The elements of a text are the text itself.
    if (!member || !std::all_of(member->begin(), member->end(), isText))
        return numbersOf(object, key);
    std::vector<double> numbers;
    for (const Json &element : *member) {
        const auto number = base::doubleFromWord(element.get<std::string>());
        if (!number || !std::isfinite(*number))
            return {};
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<double> spelledNumber(const Json &object, std::string_view key)
{
    const std::vector<double> numbers = spelledNumbers(object, key);
    return numbers.size() == 1 ? std::optional(numbers[0]) : std::nullopt;
}

std::vector<double> neededNumbers(const Reading &reading, const Json &object, std::string_view key, std::size_t count)
{
    std::vector<double> numbers = spelledNumbers(object, key);
    if (numbers.size() != count)
        reading.fail(base::tr("%1 needs %2 numbers; it has %3", key, count, numbers.size()),
                     lineOfKey(reading.text.text, key, reading.camera.image));
    return numbers;
}

double neededNumber(const Reading &reading, const Json &object, std::string_view key)
{
    return neededNumbers(reading, object, key, 1)[0];
}

glm::dvec3 neededVector(const Reading &reading, const Json &object, std::string_view key)
{
    const std::vector<double> v = neededNumbers(reading, object, key, 3);
    return {v[0], v[1], v[2]};
}

std::string nameOf(const Json &object, std::string_view key, std::size_t index)
{
    const Json *name = memberOf(object, key);
    return name && name->is_string() ? name->get<std::string>() : std::to_string(index);
}

std::optional<double> numberOf(const Json &object, std::string_view key)
{
    const Json *member = memberOf(object, key);
    return member == nullptr ? std::nullopt : finiteNumber(*member);
}

} // namespace unprojector::cameras
