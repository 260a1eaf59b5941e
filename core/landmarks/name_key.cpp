#include "core/landmarks/name_key.h"

#include <algorithm>
#include <utility>

namespace unprojector::landmarks {
namespace {

/// The small letter of a capital one, in the alphabets whose letters have two bytes in UTF-8.
char32_t smallOf(char32_t c)
{
    const auto isIn = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
    constexpr char32_t kTimes = 0xD7, kDotted = 0x130, kY = 0x178;
    if ((isIn(0xC0, 0xDE) && c != kTimes) || isIn(0x391, 0x3AB) || isIn(0x410, 0x42F))
        return c + 0x20;
    if (isIn(0x400, 0x40F))
        return c + 0x50;
    if (isIn(0x388, 0x38A))
        return c + 0x25;
    if (c == kY)
        return 0xFF;
    const bool isEvenCapital = (isIn(0x100, 0x137) && (c | 1) != (kDotted | 1)) || isIn(0x14A, 0x177)
                               || isIn(0x460, 0x481) || isIn(0x48A, 0x4BF) || isIn(0x4D0, 0x52F);
    const bool isOddCapital = isIn(0x139, 0x148) || isIn(0x179, 0x17E);
    if (isEvenCapital)
        return c | 1;
    return isOddCapital && c % 2 == 1 ? c + 1 : c;
}

std::string inLowerCase(std::string_view name)
{
    std::string lower(name);
    for (std::size_t i = 0; i < lower.size(); ++i) {
        const auto byte = static_cast<unsigned char>(lower[i]);
        if (byte >= 'A' && byte <= 'Z')
            lower[i] = static_cast<char>(byte - 'A' + 'a');
        if ((byte & 0xE0U) != 0xC0U || i + 1 == lower.size())
            continue;
        const auto next = static_cast<unsigned char>(lower[i + 1]);
        const char32_t small = smallOf(((byte & 0x1FU) << 6U) | (next & 0x3FU));
        lower[i] = static_cast<char>(0xC0U | (small >> 6U));
        lower[++i] = static_cast<char>(0x80U | (small & 0x3FU));
    }
    return lower;
}

} // namespace

std::string nameKey(std::string_view name)
{
    constexpr std::string_view kWrittenOtherwise = " _#\"'\\\x7f";
    std::string key;
    bool isApart = false;
    for (const char c : inLowerCase(name)) {
        if (static_cast<unsigned char>(c) < ' ' || kWrittenOtherwise.find(c) != kWrittenOtherwise.npos) {
            isApart = !key.empty();
            continue;
        }
        if (std::exchange(isApart, false))
            key += '_';
        key += c;
    }
    return key;
}

bool isSameName(std::string_view a, std::string_view b)
{
    if (a == b)
        return true;
    const std::string key = nameKey(a);
    return !key.empty() && key == nameKey(b);
}

std::optional<std::size_t> indexOfName(std::span<const Landmark> landmarks, std::string_view name)
{
    auto found = std::find_if(landmarks.begin(), landmarks.end(),
                              [name](const Landmark &landmark) { return landmark.name == name; });
    if (const std::string key = nameKey(name); found == landmarks.end() && !key.empty())
        found = std::find_if(landmarks.begin(), landmarks.end(),
                             [&key](const Landmark &landmark) { return nameKey(landmark.name) == key; });
    return found != landmarks.end() ? std::optional(static_cast<std::size_t>(found - landmarks.begin())) : std::nullopt;
}

} // namespace unprojector::landmarks
