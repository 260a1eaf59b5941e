#include "core/cameras/named_values.h"

#include <algorithm>

namespace unprojector::cameras {
namespace {

/// The words of a name, each without the names of its objects.
std::vector<std::string> wordsOf(std::string_view name)
{
    std::vector<std::string> words;
    for (std::size_t at = 0, end = 0; at < name.size(); at = end + 1) {
        end = std::min(name.find_first_of(" -*/+@|", at), name.size());
        if (std::string word = plain(lastPart(name.substr(at, end - at))); !word.empty())
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
        const bool isEmpty = !m_values.empty() && m_values.back().numbers.empty() && m_values.back().word.empty();
        if (group.kind == GroupKind::Name) {
            NamedValue value{wordsOf(group.name),
                             std::string(group.name),
                             isEmpty ? m_values.back().words.back() : parent,
                             {},
                             {},
                             group.line,
                             group.name.empty() ? 0 : std::size_t(group.name.data() - text.data()),
                             std::move(group.arithmetic)};
            const std::size_t count = value.words.size();
            if (count > 1 && value.words.back().size() == 1) { // "Location X=1 Y=2 Z=3"
                value.parent = value.words[count - 2];
                value.words = {value.words.back()};
                value.written.erase(0, value.written.find_last_of(" \t") + 1);
            }
            if (count == 0)
                value.words.emplace_back();
            parent = value.parent;
            m_values.push_back(std::move(value));
        } else if (group.kind == GroupKind::Word && isEmpty) {
            m_values.back().word = group.name;
        }
        for (const ScannedNumber &number : group.numbers) {
            if (!number.isOperand)
                m_values.back().numbers.push_back(number.value);
        }
    }
}

const NamedValue *NamedValues::find(Names names, std::size_t fewest) const
{
    for (const std::string_view name : names) {
        for (const NamedValue &value : m_values) {
            if (value.isNamed(name) && value.numbers.size() >= fewest)
                return &value;
        }
    }
    return nullptr;
}

std::optional<double> NamedValues::number(Names names) const
{
    const NamedValue *value = find(names, 1);
    return value ? std::optional(value->numbers.front()) : std::nullopt;
}

bool NamedValues::isTrue(std::string_view name) const
{
    const NamedValue *value = find({name});
    return value && (plain(value->word) == "true" || (!value->numbers.empty() && value->numbers.front() != 0.0));
}

std::vector<double> NamedValues::numbers(Names names, std::size_t count, Names components) const
{
    for (const std::string_view name : names) {
        if (const NamedValue *value = find({name}, count))
            return value->numbers;
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
