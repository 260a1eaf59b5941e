#include "core/base/translation.h"

#include "core/base/resource.h"

#include <nlohmann/json.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

namespace unprojector::base {

namespace {

using Catalogue = std::map<std::string, std::string, std::less<>>;

std::atomic<Language> spoken = Language::English;
thread_local bool isInEnglish = false;

const Catalogue &chinese()
{
    static const Catalogue catalogue = [] {
        Catalogue texts;
        const auto json = nlohmann::json::parse(resource("translations/unproject_zh_CN.json"), nullptr, false);
        for (const auto &[english, other] : json.items())
            texts.emplace(english, other.get<std::string>());
        return texts;
    }();
    return catalogue;
}

/// Returns whether UTF-8 text begins with a Hanzi: the first bytes of U+4000 to U+9FFF.
bool beginsWithHanzi(std::string_view text)
{
    constexpr unsigned char kFirst = 0xE4, kLast = 0xE9;
    return !text.empty() && std::uint8_t(text[0]) >= kFirst && std::uint8_t(text[0]) <= kLast;
}

bool endsWithHanzi(std::string_view text)
{
    constexpr std::size_t kHanziSize = 3;
    return text.size() >= kHanziSize && beginsWithHanzi(text.substr(text.size() - kHanziSize));
}

} // namespace

void setLanguage(Language language)
{
    spoken.store(language, std::memory_order_relaxed);
}

Language language()
{
    return isInEnglish ? Language::English : spoken.load(std::memory_order_relaxed);
}

InEnglish::InEnglish() : m_before(std::exchange(isInEnglish, true)) {}

InEnglish::~InEnglish()
{
    isInEnglish = m_before;
}

std::string translated(std::string_view english)
{
    if (language() == Language::Chinese) {
        if (const auto found = chinese().find(english); found != chinese().end())
            return found->second;
    }
    return std::string(english.substr(0, english.find('|')));
}

std::string filled(std::string_view pattern, const std::vector<std::string> &values)
{
    std::string text;
    std::vector<std::size_t> blanks; // the pattern's, not a value's
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const std::size_t place =
            pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' && pattern[i + 1] <= '9'
                ? std::size_t(pattern[i + 1] - '0')
                : 0;
        if (place == 0 || place > values.size()) {
            if (pattern[i] == ' ')
                blanks.push_back(text.size());
            text += pattern[i];
            continue;
        }
        text += values[place - 1];
        ++i;
    }
    // Chinese puts a blank between Hanzi and a number or a Latin word, but none between Hanzi. A
    // translation cannot know the kind of a value.
    for (auto blank = blanks.rbegin(); blank != blanks.rend(); ++blank) {
        const std::string_view all = text;
        if (endsWithHanzi(all.substr(0, *blank)) && beginsWithHanzi(all.substr(*blank + 1)))
            text.erase(*blank, 1);
    }
    return text;
}

} // namespace unprojector::base
