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

base::Expected<Json, base::Error> parse(const NamedText &text)
{
    if (text.text.size() > kMostBytes)
        throw base::Error{.text = base::tr("longer than %1 MiB; give the file of one camera", kMostBytes >> 20),
                          .file = text.name};
    return base::parseJson(text.text);
}

/// Returns whether a text of JSON that ends before an index is a key.
bool isKey(std::string_view text, std::size_t end)
{
    const std::size_t next = text.find_first_not_of(" \t\r\n", end);
    return next != std::string_view::npos && text[next] == ':';
}

std::size_t lineAt(std::string_view text, std::size_t at)
{
    return 1 + std::size_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
}

} // namespace

bool isJson(std::string_view text)
{
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && (text[begin] == '{' || text[begin] == '[');
}

namespace {

bool isJsonWith(std::string_view text, JsonKeys keys)
{
    const auto has = [&](const char *key) { return text.find('"' + std::string(key) + '"') != text.npos; };
    return isJson(text) && std::all_of(keys.begin(), keys.end(), has);
}

} // namespace

Json parsedJson(const NamedText &text)
{
    auto parsed = parse(text);
    if (!parsed)
        throw base::Error{.text = parsed.error().text, .file = text.name, .line = parsed.error().line};
    return std::move(parsed).value();
}

std::size_t lineOfKey(std::string_view text, std::string_view key, std::size_t count)
{
    const std::string quoted = '"' + std::string(key) + '"';
    std::size_t counted = 0;
    for (std::size_t at = text.find(quoted); at != std::string_view::npos; at = text.find(quoted, at + 1)) {
        if (isKey(text, at + quoted.size()) && counted++ == count)
            return lineAt(text, at);
    }
    return 0;
}

std::size_t lineOfMember(std::string_view text, const Json &object, std::string_view key)
{
    struct Open {
        std::size_t at, keyAt; ///< of its bracket, and of the key, else of the bracket
        bool isLike = false;   ///< its first key is the object's
    };
    if (!object.is_object() || object.empty())
        return lineOfKey(text, key);
    std::vector<Open> open;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '{' || text[at] == '[') {
            open.push_back({at, at});
        } else if ((text[at] == '}' || text[at] == ']') && !open.empty()) {
            const Open &ended = open.back();
            const auto found = base::parseJson(ended.isLike ? text.substr(ended.at, at + 1 - ended.at) : "0");
            if (found && *found == object)
                return lineAt(text, ended.keyAt);
            open.pop_back();
        } else if (text[at] == '"') {
            const std::size_t begin = at + 1;
            for (++at; at < text.size() && text[at] != '"'; ++at)
                at += text[at] == '\\' ? 1U : 0U;
            const std::string_view name = text.substr(begin, at - begin);
            if (open.empty() || !isKey(text, at + 1))
                continue;
            if (text.find_first_not_of(" \t\r\n", open.back().at + 1) == begin - 1)
                open.back().isLike = name == object.begin().key();
            if (name == key)
                open.back().keyAt = begin;
        }
    }
    return lineOfKey(text, key);
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
    return isJsonWith(text.text, keys) ? parsedJson(text) : Json();
}

Json strictDocumentWith(const NamedText &text, JsonKeys keys)
{
    if (!isJsonWith(text.text, keys))
        return {};
    auto parsed = parse(text);
    return parsed ? std::move(parsed).value() : Json();
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
                     lineOfMember(reading.text.text, object, key));
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
