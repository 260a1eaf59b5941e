#include "core/cli/terminal/language_choice.h"

#include "core/base/text_scanner.h"
#include "core/cli/terminal/console.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string_view>

namespace unprojector::cli {
using base::Language;
namespace {

/// "zh_cn" of "zh-CN.UTF-8@pinyin".
std::string nameIn(std::string_view locale)
{
    std::string name = base::lowerCase(locale.substr(0, locale.find_first_of(".@")));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

bool isUtf8(std::string_view locale)
{
    const std::size_t dot = locale.find('.');
    const std::string encoding = dot == locale.npos ? "utf8" : nameIn(locale.substr(dot + 1));
    return encoding == "utf_8" || encoding == "utf8";
}

/// The language of a locale; empty if the command does not support it.
std::optional<Language> knownLanguage(const std::string &name)
{
    if (name == "c" || name == "posix" || name == "en" || name.starts_with("en_"))
        return Language::English;
    if (name == "zh" || name.starts_with("zh_hans") || name == "zh_cn" || name == "zh_sg" || name == "zh_my")
        return Language::Chinese;
    return std::nullopt;
}

std::string variable(const char *name)
{
    const char *value = std::getenv(name);
    return value == nullptr ? std::string() : value;
}

} // namespace

LanguageWishes languageWishes()
{
    return {variable("LC_ALL"), variable("LC_MESSAGES"), variable("LANG"), variable("LANGUAGE"), systemLanguages()};
}

Language chosenLanguage(const LanguageWishes &wishes)
{
    std::string locale;
    for (const std::string *wish : {&wishes.system, &wishes.lang, &wishes.messages, &wishes.all})
        locale = wish->empty() ? locale : *wish;
    if (locale.empty() || nameIn(locale) == "c" || nameIn(locale) == "posix" || !isUtf8(locale))
        return Language::English;
    std::istringstream names(wishes.list.empty() ? locale : wishes.list);
    for (std::string name; std::getline(names, name, ':');) {
        if (const auto known = knownLanguage(nameIn(name)))
            return *known;
    }
    return Language::English;
}

} // namespace unprojector::cli
