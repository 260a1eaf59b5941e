#include "core/base/utf8.h"

namespace unprojector::base {

std::size_t firstNotUtf8(std::string_view text)
{
    const auto byte = [&text](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
    };
    const auto isBetween = [](unsigned char value, unsigned lowest, unsigned highest) {
        return value >= lowest && value <= highest;
    };
    for (std::size_t i = 0; i < text.size();) {
        const unsigned char first = byte(i);
        if (first < 0x80) {
            ++i;
            continue;
        }
        std::size_t length = 4;
        if (isBetween(first, 0xc2, 0xdf))
            length = 2;
        else if (isBetween(first, 0xe0, 0xef))
            length = 3;
        else if (!isBetween(first, 0xf0, 0xf4))
            return i;
        // The second byte excludes overlong forms, surrogates and values that are too large.
        const unsigned lowest = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
        const unsigned highest = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
        for (std::size_t k = 1; k < length; ++k) {
            if (!isBetween(byte(i + k), k == 1 ? lowest : 0x80, k == 1 ? highest : 0xbf))
                return i;
        }
        i += length;
    }
    return text.npos;
}

std::string_view firstCharacters(std::string_view text, std::size_t count)
{
    const auto continues = [text](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U; };
    std::size_t end = 0;
    for (; count > 0 && end < text.size(); --count) {
        const std::size_t begin = end++;
        while (end < text.size() && end < begin + 4 && continues(end))
            ++end;
    }
    return text.substr(0, end);
}

std::string utf8FromUtf16(std::span<const std::uint8_t> bytes, std::endian order)
{
    const std::size_t high = order == std::endian::big ? 0 : 1;
    const auto unit = [&](std::size_t i) {
        return static_cast<std::uint32_t>(bytes[2 * i + high] << 8 | bytes[2 * i + 1 - high]);
    };
    const auto isHighSurrogate = [](std::uint32_t value) { return value >= 0xd800 && value < 0xdc00; };
    const auto isLowSurrogate = [](std::uint32_t value) { return value >= 0xdc00 && value < 0xe000; };
    constexpr std::uint32_t kReplacement = 0xfffd;
    std::string text;
    text.reserve(bytes.size() / 2);
    const auto append = [&text](std::uint32_t code) {
        const auto last = [code](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3f)); };
        if (code < 0x80) {
            text += static_cast<char>(code);
        } else if (code < 0x800) {
            text += {static_cast<char>(0xc0 | code >> 6), last(0)};
        } else if (code < 0x10000) {
            text += {static_cast<char>(0xe0 | code >> 12), last(6), last(0)};
        } else {
            text += {static_cast<char>(0xf0 | code >> 18), last(12), last(6), last(0)};
        }
    };
    const std::size_t count = bytes.size() / 2;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t first = unit(i);
        if (isHighSurrogate(first) && i + 1 < count && isLowSurrogate(unit(i + 1)))
            append(0x10000 + ((first - 0xd800) << 10) + (unit(++i) - 0xdc00));
        else
            append(isHighSurrogate(first) || isLowSurrogate(first) ? kReplacement : first);
    }
    if (bytes.size() % 2 != 0)
        append(kReplacement);
    return text;
}

std::string utf8FromFile(std::string text)
{
    const bool isLittle = text.starts_with("\xff\xfe");
    if (!isLittle && !text.starts_with("\xfe\xff"))
        return text;
    const auto *bytes = reinterpret_cast<const std::uint8_t *>(text.data());
    return utf8FromUtf16({bytes + 2, text.size() - 2}, isLittle ? std::endian::little : std::endian::big);
}

} // namespace unprojector::base
