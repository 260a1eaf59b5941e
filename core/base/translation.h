#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// The user's language for core's messages. The English text in the source is the key;
// resources/translations/unproject_zh_CN.json has the Chinese one.

namespace unprojector::base {

enum class Language { English, Chinese };

/// Sets the language of tr() for all threads; the default is English.
void setLanguage(Language language);
/// The language of tr() in this thread.
Language language();

/// Sets tr() to English in this thread during its lifetime: for output that programs read.
class InEnglish {
public:
    InEnglish();
    ~InEnglish();
    InEnglish(const InEnglish &) = delete;
    InEnglish &operator=(const InEnglish &) = delete;

private:
    bool m_before;
};

/// Marks a text for translation without translating it; tr() receives it later from a table.
constexpr const char *marked(const char *english)
{
    return english;
}

/// The text in the current language; the English one, without its context, if there is no
/// translation.
std::string translated(std::string_view english);

/// Fills values into %1 to %9 of a pattern; values are not searched for placeholders. Removes
/// blanks of the pattern that end up between two Hanzi.
std::string filled(std::string_view pattern, const std::vector<std::string> &values);

inline std::string valueText(std::string_view value)
{
    return std::string(value);
}

template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
std::string valueText(Integer value)
{
    return std::to_string(value);
}

/// @param english  a literal, so that a script can compare the texts of source and translation; %1
///         to %9 stand for the values. A single word may need different translations: its context
///         follows after a bar, which is not shown: "right|verdict"
template <class... Values>
std::string tr(std::string_view english, const Values &...values)
{
    if constexpr (sizeof...(values) == 0)
        return translated(english);
    else
        return filled(translated(english), {valueText(values)...});
}

} // namespace unprojector::base
