#include "core/doctor/mistake_texts.h"

#include "core/doctor/remedies.h"
#include "core/text/translation.h"

namespace unprojector::doctor {
using text::tr;

std::vector<std::string> partsOf(std::string_view id)
{
    if (id.empty() || id == "right" || id == "unknown")
        return {};
    const std::size_t plus = id.find('+');
    if (plus == id.npos)
        return {std::string(id)};
    return {std::string(id.substr(0, plus)), std::string(id.substr(plus + 1))};
}

std::string mistakeName(std::string_view id)
{
    std::string names;
    for (const std::string &part : partsOf(id))
        names += (names.empty() ? "" : " + ") + tr(remedyOf(part).name);
    return names;
}

std::string mistakeSentence(std::string_view id)
{
    std::string sentences;
    for (const std::string &part : partsOf(id)) {
        const std::string next = tr(remedyOf(part).sentence);
        sentences = sentences.empty() ? next : tr("%1 %2|sentences", sentences, next);
    }
    return sentences;
}

std::string waysText(const std::vector<Way> &ways)
{
    std::string text;
    for (const Way &way : ways) {
        const std::string next = way.words == nullptr ? way.value : tr(way.words, way.value);
        text = text.empty() ? next : tr("%1; %2|ways", text, next);
    }
    return text;
}

} // namespace unprojector::doctor
