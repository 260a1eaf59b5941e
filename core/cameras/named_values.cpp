#include "core/cameras/named_values.h"

#include "core/base/expression.h"
#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"

#include <algorithm>
#include <cmath>

namespace unprojector::cameras {
using base::tr;
namespace {

/// The words of a name, each without the names of its objects.
std::vector<std::string> namesIn(std::string_view name)
{
    std::vector<std::string> words;
    for (std::size_t at = 0, end = 0; at < name.size(); at = end + 1) {
        end = std::min(name.find_first_of(" \t-*/+@|", at), name.size());
        if (std::string word = plain(lastPart(name.substr(at, end - at))); !word.empty())
            words.push_back(std::move(word));
    }
    return words;
}

/// Returns whether a text ends with a bracket that it opens.
bool isOpened(std::string_view text)
{
    const std::size_t last = text.find_last_not_of(" \t");
    return last != text.npos && (text[last] == '(' || text[last] == '[');
}

/// The numbers by rows of those that R's matrix(c(...)) has by columns, behind which its sides may stand.
std::vector<double> byRows(const std::vector<double> &columns)
{
    for (const std::size_t count : {16U, 12U, 9U}) {
        if (columns.size() < count || columns.size() > count + 2)
            continue;
        const std::size_t height = count == 16 ? 4 : 3, width = count / height;
        std::vector<double> rows;
        for (std::size_t i = 0; i < count; ++i)
            rows.push_back(columns[i % width * height + i / width]);
        return rows;
    }
    return columns;
}

/// Names of a value's own number: "k1: {value: -0.1}", "fx: float = 600".
constexpr std::string_view kOfValue = " value float double f32 f64 float32 float64 number int ";

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

base::Error NamedValue::computedError() const
{
    return {arithmetic.ends_with(',')
                ? tr("%1 stands among its numbers; write the number",
                     base::quoted(arithmetic.substr(0, arithmetic.size() - 1)))
                : tr("the text computes with it (%1), and only numbers are read; write the result", arithmetic),
            written,
            {},
            static_cast<int>(line)};
}

double NamedValue::number() const
{
    if (!decimal.empty())
        throw base::Error{tr("%1 may be one number with a decimal comma, or two numbers; write a point", decimal),
                          written,
                          {},
                          static_cast<int>(line)};
    if (arithmetic.empty())
        return numbers.front();
    constexpr std::size_t kMost = 40; // longer ones are cut
    std::string_view rest = std::string_view(arithmetic).substr(0, arithmetic.find(','));
    const bool isFloor = rest.starts_with("/ /"), isProduct = rest.starts_with('*') || rest.starts_with('/');
    rest.remove_prefix(isFloor ? 2 : 0);
    const auto computed = base::sourceNumber(base::shortestText(numbers.front()) + std::string(rest),
                                             [](std::string_view) { return std::optional<std::string_view>(); });
    if (!computed || !isProduct || arithmetic.size() >= kMost || (!computed->wholeQuotient.empty() && !isFloor))
        throw computedError();
    return isFloor ? std::floor(computed->value) : computed->value;
}

NamedValues::NamedValues(std::string_view text)
{
    std::string parent;
    std::vector<Group> groups = scan(text);
    m_values.reserve(groups.size());
    const auto finish = [this] {
        if (m_values.empty() || m_values.back().arithmetic != kByColumns)
            return;
        m_values.back().numbers = byRows(m_values.back().numbers);
        m_values.back().arithmetic.clear();
    };
    std::string_view word;
    for (Group &group : groups) {
        const bool isEmpty = !m_values.empty() && m_values.back().numbers.empty() && m_values.back().word.empty();
        // "k1: {value: -0.1}"
        const bool isValue =
            isEmpty && !m_values.back().written.empty() && base::isListed(kOfValue, base::lowerCase(group.name));
        if (group.kind == GroupKind::Name && isValue) {
            m_values.back().arithmetic = std::move(group.arithmetic);
            m_values.back().unit = std::move(group.unit);
        } else if (group.kind == GroupKind::Name) {
            finish();
            const std::string_view name = group.name == "ans" && !word.empty() ? word : group.name; // MATLAB's
            NamedValue value{namesIn(name),
                             std::string(name),
                             isEmpty ? m_values.back().words.back() : parent,
                             {},
                             {},
                             group.line,
                             group.name.empty() ? 0 : std::size_t(group.name.data() - text.data()),
                             std::move(group.arithmetic),
                             std::move(group.unit)};
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
        const ScannedNumber *before = nullptr;
        for (const ScannedNumber &number : group.numbers) {
            // A line without brackets below a list has no name.
            if (before && before->bracket > 0 && number.bracket == 0 && number.line > before->line)
                m_values.push_back({{{}}, {}, {}, {}, {}, number.line});
            if (!number.isOperand)
                m_values.back().numbers.push_back(number.value);
            before = &number;
        }
        // "cy=240 (640x480)"
        const std::size_t count = group.numbers.size();
        if (count > 1 && group.numbers[count - 1].isInWord && group.numbers[count - 1].at == group.numbers[count - 2].at
            && (count > 2 || group.name.empty()) && isOpened(text.substr(0, group.numbers[count - 1].at))) {
            std::vector<double> &numbers = m_values.back().numbers;
            NamedValue size{{"size"}, "size", {}, {}, {numbers.end() - 2, numbers.end()}, group.numbers.back().line};
            numbers.resize(numbers.size() - 2);
            m_values.push_back(std::move(size));
        }
        if (const auto &numbers = group.numbers; numbers.size() == 2 && numbers[0].bracket == 0) {
            const auto both = text.substr(numbers[0].at, numbers[1].at + numbers[1].length - numbers[0].at);
            if (both.find_first_not_of("+-.0123456789,") == both.npos)
                m_values.back().decimal = both;
        }
        word = group.kind == GroupKind::Word ? group.name : std::string_view();
        group.numbers = {}; // a large text takes less
    }
    finish();
}

const NamedValue *NamedValues::find(std::string_view name, std::size_t fewest) const
{
    const auto found = std::ranges::find_if(
        m_values, [&](const NamedValue &value) { return value.isNamed(name) && value.numbers.size() >= fewest; });
    return found == m_values.end() ? nullptr : &*found;
}

bool NamedValues::isTrue(std::string_view name) const
{
    const NamedValue *value = find(name);
    return value && (plain(value->word) == "true" || (!value->numbers.empty() && value->numbers.front() != 0.0));
}

std::vector<double> NamedValues::numbers(std::string_view name, std::size_t count,
                                         std::initializer_list<std::string_view> components) const
{
    if (const NamedValue *value = find(name, count)) {
        if (value->numbers.size() == 1 || (count == 1 && !value->decimal.empty()))
            return {value->number()};
        if (!value->arithmetic.empty())
            throw value->computedError();
        return value->numbers;
    }
    std::vector<double> found;
    for (const std::string_view component : components) {
        const auto one = std::ranges::find_if(m_values, [&](const NamedValue &value) {
            return value.parent.ends_with(name) && value.isNamed(component) && value.numbers.size() == 1;
        });
        if (one != m_values.end())
            found.push_back(one->numbers.front());
    }
    return found.size() == components.size() && found.size() >= count ? found : std::vector<double>();
}

} // namespace unprojector::cameras
