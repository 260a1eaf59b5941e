#include "core/base/columns.h"

#include <algorithm>
#include <iterator>

namespace unprojector::base {
namespace {

struct Character {
    std::string_view bytes;
    char32_t code = 0;

    bool isWide() const
    {
        struct Range {
            char32_t first, last;
        };
        constexpr Range kWide[] = {{0x1100, 0x115f}, {0x2e80, 0x303e}, {0x3041, 0xa4cf},
                                   {0xac00, 0xd7a3}, {0xf900, 0xfaff}, {0xfe30, 0xfe6f},
                                   {0xff00, 0xff60}, {0xffe0, 0xffe6}, {0x20000, 0x3fffd}};
        return std::any_of(std::begin(kWide), std::end(kWide),
                           [this](const Range &range) { return code >= range.first && code <= range.last; });
    }
    std::size_t columns() const { return isWide() ? 2 : 1; }
};

/// The character at a position; invalid UTF-8 counts as single bytes.
Character characterAt(std::string_view text, std::size_t start)
{
    const auto first = static_cast<unsigned char>(text[start]);
    const std::size_t length = first < 0xc0 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    Character character{text.substr(start, length), length == 1 ? first : first & (0xffu >> (length + 1))};
    for (const char byte : character.bytes.substr(1))
        character.code = character.code << 6 | (static_cast<unsigned char>(byte) & 0x3f);
    return character;
}

} // namespace

std::size_t columnsOf(std::string_view text)
{
    std::size_t columns = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = characterAt(text, at);
        columns += character.columns();
        at += character.bytes.size();
    }
    return columns;
}

std::string_view firstColumns(std::string_view text, std::size_t columns)
{
    std::size_t at = 0;
    for (std::size_t taken = 0; at < text.size();) {
        const Character character = characterAt(text, at);
        taken += character.columns();
        if (taken > columns)
            break;
        at += character.bytes.size();
    }
    return text.substr(0, at);
}

std::string padded(std::string text, std::size_t columns)
{
    const std::size_t taken = columnsOf(text);
    return taken < columns ? text.append(columns - taken, ' ') : text;
}

std::string paddedLeft(const std::string &text, std::size_t columns)
{
    const std::size_t taken = columnsOf(text);
    return taken < columns ? std::string(columns - taken, ' ') + text : text;
}

} // namespace unprojector::base
