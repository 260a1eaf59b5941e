#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// What the core says to people, in their language. The English text in the source is the key;
// resources/translations/unproject_zh_CN.json has the Chinese one.

namespace unprojector::text {

enum class Language { English, Chinese };

/// What tr() speaks in every thread: English unless a program says otherwise when it starts.
void setLanguage(Language language);
/// What tr() speaks in this thread.
Language language();

/// While it lives, tr() speaks English in this thread: for what programs read.
class InEnglish {
public:
    InEnglish();
    ~InEnglish();
    InEnglish(const InEnglish &) = delete;
    InEnglish &operator=(const InEnglish &) = delete;

private:
    bool m_before;
};

/// A text as it is, that tr() gets later, out of a table.
constexpr const char *marked(const char *english)
{
    return english;
}

/// A text in the language that is set; the English one, without its context, where it has no other.
std::string translated(std::string_view english);

/// A pattern with values in the places of %1 to %9, whatever stands in the values. A blank of the pattern goes where it would
/// stand between two Hanzi.
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

/// @param english  a literal, so that the texts of the source and of the translation can be compared; with %1 to %9 where
///                 there are values. A word alone is not the same in every place: where it stands is said behind a bar,
///                 which is not said to people: "right|verdict"
template <class... Values>
std::string tr(std::string_view english, const Values &...values)
{
    if constexpr (sizeof...(values) == 0)
        return translated(english);
    else
        return filled(translated(english), {valueText(values)...});
}

} // namespace unprojector::text
