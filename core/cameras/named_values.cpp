#include "core/cameras/named_values.h"

#include <algorithm>

namespace unprojector::cameras {
namespace {

/// The words of a name, each without the names of its objects.
std::vector<std::string> wordsOf(std::string_view name)
{
    std::vector<std::string> words;
    const auto isOfWord = [](char c) {
        return !plain({&c, 1}).empty() || c == '_' || c == '.' || c == ':' || c == '>';
    };
    for (auto at = name.begin(); at != name.end();) {
        const auto begin = std::find_if(at, name.end(), isOfWord);
        at = std::find_if_not(begin, name.end(), isOfWord);
        if (std::string word = plain(lastPart({begin, at})); !word.empty())
            words.push_back(std::move(word));
    }
    return words;
}

} // namespace

bool NamedValue::isNamed(std::string_view name) const
{
    for (auto last = words.rbegin(); last != words.rend() && !name.empty() && name.ends_with(*last); ++last) {
        name.remove_suffix(last->size());
        if (name.empty())
            return true;
    }
    return false;
}

NamedValues::NamedValues(std::string_view text)
{
    std::string parent;
    for (Group &group : scan(text)) {
        if (group.kind == GroupKind::Name) {
            const bool isHeading = !m_values.empty() && m_values.back().numbers.empty() && m_values.back().word.empty();
            if (isHeading)
                parent = m_values.back().words.back();
            NamedValue value;
            value.written = group.name;
            value.words = wordsOf(group.name);
            if (value.words.size() > 1 && value.words.back().size() == 1) { // "Location X=1 Y=2 Z=3"
                parent = value.words[value.words.size() - 2];
                value.words = {value.words.back()};
                value.written = value.written.substr(value.written.find_last_of(" \t") + 1);
            }
            if (value.words.empty())
                value.words.emplace_back();
            value.parent = parent;
            value.line = group.line;
            value.at = group.name.empty() ? 0 : std::size_t(group.name.data() - text.data());
            value.arithmetic = std::move(group.arithmetic);
            m_values.push_back(std::move(value));
        } else if (group.kind == GroupKind::Word && m_values.back().numbers.empty() && m_values.back().word.empty()) {
            m_values.back().word = group.name;
        }
        for (const ScannedNumber &number : group.numbers)
            m_values.back().numbers.push_back(number.value);
    }
}

const NamedValue *NamedValues::find(std::initializer_list<std::string_view> names) const
{
    for (const std::string_view name : names) {
        const auto found = std::find_if(m_values.begin(), m_values.end(),
                                        [name](const NamedValue &value) { return value.isNamed(name); });
        if (found != m_values.end())
            return &*found;
    }
    return nullptr;
}

std::optional<double> NamedValues::number(std::initializer_list<std::string_view> names) const
{
    for (const std::string_view name : names) {
        for (const NamedValue &value : m_values) {
            if (value.isNamed(name) && !value.numbers.empty())
                return value.numbers.front();
        }
    }
    return std::nullopt;
}

bool NamedValues::isTrue(std::string_view name) const
{
    const NamedValue *value = find({name});
    return value
           && (value->word == "True" || value->word == "true"
               || (!value->numbers.empty() && value->numbers.front() != 0.0));
}

std::vector<double> NamedValues::numbers(std::initializer_list<std::string_view> names, std::size_t count,
                                         std::initializer_list<std::string_view> components) const
{
    for (const std::string_view name : names) {
        for (const NamedValue &value : m_values) {
            if (value.isNamed(name) && value.numbers.size() >= count)
                return value.numbers;
        }
        std::vector<double> found;
        for (const std::string_view component : components) {
            const auto one = std::find_if(m_values.begin(), m_values.end(), [&](const NamedValue &value) {
                return value.parent.ends_with(name) && value.isNamed(component) && value.numbers.size() == 1;
            });
            if (one != m_values.end())
                found.push_back(one->numbers.front());
        }
        if (!found.empty() && found.size() == components.size() && found.size() >= count)
            return found;
    }
    return {};
}

} // namespace unprojector::cameras
