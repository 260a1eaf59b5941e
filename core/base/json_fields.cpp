#include "core/base/json_fields.h"

#include "core/base/number_text.h"
#include "core/base/path_text.h"
#include "core/base/printable.h"

#include <algorithm>
#include <cmath>

namespace unprojector::base {
namespace {

/// Appends a member without searching for the key: a search takes time linear in the members.
void append(Json &object, std::string_view key, Json value)
{
    if (object.is_null())
        object = Json::object();
    static_cast<Json::object_t::Container &>(object.get_ref<Json::object_t &>()).emplace_back(key, std::move(value));
}

/// Appends the members of an object that are not known.
void appendOthers(Json &object, const Json &from, const std::vector<std::string_view> &known)
{
    if (!from.is_object())
        return;
    for (const auto &[key, value] : from.get_ref<const Json::object_t &>()) {
        if (std::find(known.begin(), known.end(), key) == known.end())
            append(object, key, value);
    }
}

void know(std::vector<std::string_view> &known, std::string_view key)
{
    if (known.empty())
        known.reserve(16);
    if (known.empty() || known.back() != key)
        known.push_back(key);
}

const Json *memberOf(const Json &object, std::string_view key)
{
    for (const auto &[name, member] : object.get_ref<const Json::object_t &>()) {
        if (name == key)
            return &member;
    }
    return nullptr;
}

std::string choicesText(std::span<const char *const> choices)
{
    std::string list;
    for (std::size_t i = 0; i < choices.size(); ++i)
        list = i == 0                    ? choices[i]
               : i + 1 == choices.size() ? tr("%1 or %2", list, choices[i])
                                         : list + ", " + choices[i];
    return list;
}

} // namespace

JsonNode::JsonNode(const JsonNode &object, std::string_view key) : m_parent(&object), m_step{key}
{
    object.requireObject();
    m_json = memberOf(*object.m_json, key);
}

void JsonNode::fail(std::string text) const
{
    JsonPath path;
    const JsonNode *root = this;
    for (; root->m_parent; root = root->m_parent)
        path.insert(path.begin(), root->m_step);
    Error error{std::move(text)};
    if (!exists()) // the object has a line
        setPlace(error, root->m_text, {path.begin(), path.end() - 1});
    setPlace(error, root->m_text, path);
    throw error;
}

void JsonNode::require(bool isIt, const char *expected, std::size_t count) const
{
    if (!exists())
        fail(tr("is missing"));
    if (!isIt)
        fail(tr("expected %1, found %2", tr(expected, count), shown()));
}

void JsonNode::requireObject() const
{
    require(exists() && m_json->is_object(), marked("an object in { }"));
}

/// A value for a message.
std::string JsonNode::shown() const
{
    constexpr std::size_t kMost = 60;
    return m_json->is_object()  ? tr("an object in { }")
           : m_json->is_array() ? tr("a list in [ ]")
                                : printableBeginning(compactJson(*m_json), kMost);
}

std::size_t JsonNode::size(std::size_t most) const
{
    require(exists() && m_json->is_array(), marked("a list in [ ]"));
    if (m_json->size() > most)
        fail(tr("has %1 elements; there may be at most %2", m_json->size(), most));
    return m_json->size();
}

void JsonNode::requireSize(std::size_t size, const char *expected) const
{
    require(exists() && m_json->is_array(), expected, size);
    if (m_json->size() != size)
        fail(tr("has %1 elements; it must have %2", m_json->size(), size));
}

double JsonNode::number() const
{
    require(exists() && isJsonNumber(*m_json), marked("a number"));
    return valueOfJsonNumber(*m_json);
}

double JsonNode::number(double lowest, double highest) const
{
    const double value = number();
    if (!(value >= lowest && value <= highest))
        fail(tr("%1 must lie between %2 and %3", shortestText(value), shortestText(lowest), shortestText(highest)));
    return value;
}

double JsonNode::whole(double lowest, double highest) const
{
    const double value = number(lowest, highest);
    if (value != std::floor(value))
        fail(tr("%1 must be a whole number", shortestText(value)));
    return value;
}

std::string JsonNode::text() const
{
    require(exists() && m_json->is_string(), marked("a text in quotes"));
    return m_json->get<std::string>();
}

std::size_t JsonNode::oneOf(std::span<const char *const> words) const
{
    const auto found = std::find(words.begin(), words.end(), text());
    if (found == words.end())
        failChoice(words);
    return static_cast<std::size_t>(found - words.begin());
}

void JsonNode::failChoice(std::span<const char *const> choices) const
{
    constexpr std::size_t kMost = 60;
    fail(tr("%1 must be %2", printableBeginning(compactJson(*m_json), kMost), choicesText(choices)));
}

bool JsonNode::has(std::string_view key, bool)
{
    know(m_known, key);
    return JsonNode(*this, key).exists();
}

std::size_t JsonNode::oneKeyOf(std::span<const char *const> keys, std::size_t)
{
    std::size_t found = 0;
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (has(keys[i])) {
            found = i;
            ++count;
        }
    }
    if (count != 1)
        fail(tr("must have exactly one of %1", choicesText(keys)));
    return found;
}

void JsonNode::written(std::string_view key, const char *)
{
    know(m_known, key);
}

Json JsonNode::take()
{
    if (!m_known.empty())
        appendOthers(m_unknown, *m_json, m_known);
    m_known.clear();
    return std::exchange(m_unknown, nullptr);
}

void JsonNode::add(std::string_view key, Json &&unknown, bool)
{
    know(m_known, key);
    if (!unknown.is_null())
        append(m_unknown, key, std::move(unknown));
}

void JsonNode::scalar(bool &value) const
{
    require(exists() && m_json->is_boolean(), marked("true or false"));
    value = m_json->get<bool>();
}

void JsonNode::scalar(std::filesystem::path &value) const
{
    const std::string name = text();
    if (name.empty() || name.find('\0') != std::string::npos)
        fail(tr("this is not a name of a file"));
    value = pathFromUtf8(name);
}

JsonOutput::JsonOutput(const JsonOutput &object, std::string_view key)
    : m_unknown(object.m_unknown && object.m_unknown->is_object() ? memberOf(*object.m_unknown, key) : nullptr)
{
}

bool JsonOutput::has(std::string_view key, bool isWritten)
{
    if (m_json.is_null())
        m_json = Json::object();
    know(m_known, key);
    return isWritten;
}

std::size_t JsonOutput::oneKeyOf(std::span<const char *const> keys, std::size_t written)
{
    m_known.insert(m_known.end(), keys.begin(), keys.end());
    return written;
}

void JsonOutput::scalar(const std::filesystem::path &value)
{
    m_json = utf8FromPath(value);
}

void JsonOutput::add(std::string_view key, Json &&value, bool mayBeMissing)
{
    if (has(key, !mayBeMissing || !value.empty()))
        append(m_json, key, std::move(value));
}

Json JsonOutput::take()
{
    if (m_json.is_object() && m_unknown)
        appendOthers(m_json, *m_unknown, m_known);
    return std::move(m_json);
}

} // namespace unprojector::base
