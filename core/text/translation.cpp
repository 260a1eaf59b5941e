#include "core/text/translation.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <functional>
#include <map>

namespace unprojector::text {

// Made of resources/translations/unproject_zh_CN.json when the program is built.
extern const unsigned char kChineseCatalogue[];
extern const std::size_t kChineseCatalogueSize;

namespace {

using Catalogue = std::map<std::string, std::string, std::less<>>;

Language spoken = Language::English;

const Catalogue &chinese()
{
    static const Catalogue catalogue = [] {
        Catalogue texts;
        const auto json =
            nlohmann::json::parse(kChineseCatalogue, kChineseCatalogue + kChineseCatalogueSize, nullptr, false);
        for (const auto &[english, other] : json.items())
            texts.emplace(english, other.get<std::string>());
        return texts;
    }();
    return catalogue;
}

} // namespace

void setLanguage(Language language)
{
    spoken = language;
}

Language language()
{
    return spoken;
}

std::string translated(std::string_view english)
{
    if (spoken == Language::Chinese) {
        if (const auto found = chinese().find(english); found != chinese().end())
            return found->second;
    }
    return std::string(english);
}

std::string filled(std::string_view pattern, std::initializer_list<std::string> values)
{
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const std::size_t place =
            pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' && pattern[i + 1] <= '9'
                ? std::size_t(pattern[i + 1] - '0')
                : 0;
        if (place == 0 || place > values.size()) {
            text += pattern[i];
            continue;
        }
        text += values.begin()[place - 1];
        ++i;
    }
    return text;
}

} // namespace unprojector::text
