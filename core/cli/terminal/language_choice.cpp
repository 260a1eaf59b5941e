#include "core/cli/terminal/language_choice.h"

#include "core/cli/terminal/console.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace unprojector::cli {
using base::Language;
namespace {

/// The word in small letters, with _ for -, as in "zh_hans_cn".
std::string plain(std::string_view word)
{
    std::string result(word);
    for (char &c : result)
        c = c == '-' ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return result;
}

/// "zh_CN" of "zh_CN.UTF-8@pinyin".
std::string_view withoutEncoding(std::string_view locale)
{
    return locale.substr(0, std::min(locale.find_first_of(".@"), locale.size()));
}

bool isUtf8(std::string_view locale)
{
    const std::size_t dot = locale.find('.');
    if (dot == locale.npos)
        return true;
    const std::string encoding = plain(locale.substr(dot + 1, locale.find('@') - dot - 1));
    return encoding == "utf_8" || encoding == "utf8";
}

bool isPlainC(std::string_view name)
{
    const std::string_view word = withoutEncoding(name);
    return word == "C" || word == "POSIX";
}

/// The language of a locale; empty if the command does not support it.
std::optional<Language> knownLanguage(std::string_view name)
{
    const std::string word = plain(withoutEncoding(name));
    if (isPlainC(name) || word == "en" || word.starts_with("en_"))
        return Language::English;
    if (word == "zh" || word.starts_with("zh_hans") || word == "zh_cn" || word == "zh_sg" || word == "zh_my")
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
    if (locale.empty() || isPlainC(locale) || !isUtf8(locale))
        return Language::English;
    std::string_view names = wishes.list.empty() ? locale : wishes.list;
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(':'), names.size());
        if (const auto known = knownLanguage(names.substr(0, end)))
            return *known;
        names.remove_prefix(std::min(end + 1, names.size()));
    }
    return Language::English;
}

} // namespace unprojector::cli
