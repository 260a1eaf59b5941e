#include "core/doctor/mistakes.h"

#include "core/base/resource.h"
#include "core/doctor/written_value.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <cctype>

namespace unprojector::doctor {
namespace {

std::vector<CodeChange> linesIn(const nlohmann::json &mistake, const char *key)
{
    std::vector<CodeChange> code;
    if (const auto lines = mistake.find(key); lines != mistake.end()) {
        for (const nlohmann::json &line : *lines)
            code.push_back(
                {line.at(0).get<std::string>(), line.at(1).get<std::string>(), line.at(2).get<std::string>()});
    }
    return code;
}

/// @return null if there is no value of this name
const SolvedValue *named(std::span<const SolvedValue> values, std::string_view name)
{
    const auto found =
        std::find_if(values.begin(), values.end(), [name](const SolvedValue &value) { return value.name == name; });
    return found == values.end() ? nullptr : &*found;
}

/// The value in a line. A scale that is not solved is 1, and a translation 0; other names stay.
/// @param name  without "other": Far
std::string textOf(std::string name, std::span<const SolvedValue> values)
{
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    const SolvedValue *value = named(values, name);
    if (!value)
        return name == "scale" ? "1" : name == "translation" ? "0, 0, 0" : name;
    std::string text = value->word;
    for (const double number : value->numbers)
        text += (text.empty() ? "" : ", ") + valueText(number);
    return text;
}

/// A line with the values in place of their names.
std::string lineWithValues(std::string_view line, std::span<const SolvedValue> values)
{
    constexpr std::string_view kOther = "other",
                               kOfNames = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789";
    std::string filled;
    while (!line.empty()) {
        const std::size_t length = std::min(line.find_first_not_of(kOfNames), line.size());
        const std::string_view word = line.substr(0, std::max<std::size_t>(length, 1));
        const bool isValue = length > kOther.size() && word.starts_with(kOther)
                             && std::isupper(static_cast<unsigned char>(word[kOther.size()]));
        filled += isValue ? textOf(std::string(word.substr(kOther.size())), values) : std::string(word);
        line.remove_prefix(word.size());
    }
    return filled;
}

} // namespace

const std::vector<Mistake> &mistakes()
{
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> read;
        for (const nlohmann::json &one : nlohmann::json::parse(base::resource("doctor/mistakes.json")))
            read.push_back({one.value("id", ""), one.value("name", ""), one.value("sentence", ""),
                            one.value("reports", 0), one.value("isOnlySolved", false), linesIn(one, "code"),
                            one.value("with", std::vector<std::string>()), linesIn(one, "codeWith")});
        return read;
    }();
    return all;
}

const Mistake &mistakeOf(std::string_view id)
{
    const auto found =
        std::find_if(mistakes().begin(), mistakes().end(), [id](const Mistake &mistake) { return mistake.id == id; });
    assert(found != mistakes().end());
    return *found;
}

std::vector<CodeChange> codeOf(std::string_view id, std::span<const SolvedValue> values)
{
    const Mistake *mistake = &mistakeOf(id);
    const auto chooses = [&](const SolvedValue &value) {
        return std::any_of(mistake->with.begin(), mistake->with.end(),
                           [&](const std::string &with) { return value.name == with || value.word == with; });
    };
    // A ratio has the lines of its fixed form.
    if (const SolvedValue *fixedForm = named(values, "as"))
        mistake = &mistakeOf(fixedForm->word);
    std::vector<CodeChange> code =
        std::any_of(values.begin(), values.end(), chooses) ? mistake->codeWith : mistake->code;
    for (CodeChange &change : code) {
        change.wrong = lineWithValues(change.wrong, values);
        change.right = lineWithValues(change.right, values);
    }
    return code;
}

} // namespace unprojector::doctor
