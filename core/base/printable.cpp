#include "core/base/printable.h"

#include "core/base/identifier.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace unprojector::base {
namespace {

std::string hexadecimal(std::uint32_t value, int digits)
{
    std::string text;
    for (int i = digits - 1; i >= 0; --i)
        text += "0123456789abcdef"[(value >> (4 * i)) % 16];
    return text;
}

/// The escape of a character: "\x1b", "\u202e", "\U000e0001".
/// @param character  one character of UTF-8
std::string writtenOut(std::string_view character)
{
    const auto byte = [&character](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(character[i])}; };
    if (character.size() == 1)
        return "\\x" + hexadecimal(byte(0), 2);
    std::uint32_t code = byte(0) & (0xffU >> (character.size() + 1));
    for (std::size_t i = 1; i < character.size(); ++i)
        code = code << 6 | (byte(i) & 0x3fU);
    return code < 0x10000 ? "\\u" + hexadecimal(code, 4) : "\\U" + hexadecimal(code, 8);
}

/// The byte count of a non-ASCII blank at a position, else 0.
std::size_t blankAt(std::string_view text, std::size_t at)
{
    constexpr std::string_view kBlanks[] = {"\xc2\xa0", "\xe1\x9a\x80", "\xe2\x80\xaf", "\xe2\x81\x9f", "\xe3\x80\x80"};
    const std::string_view rest = text.substr(at);
    for (const std::string_view blank : kBlanks) {
        if (rest.starts_with(blank))
            return blank.size();
    }
    const bool isSpace =
        rest.size() >= 3 && rest.starts_with("\xe2\x80") && static_cast<unsigned char>(rest[2]) <= 0x8a;
    return isSpace ? 3 : 0; // U+2000 to U+200A
}

enum class Kept { Tabs, LineEnds, AsciiBlanks };

std::string printable(std::string_view text, Kept kept)
{
    std::string result;
    result.reserve(text.size());
    std::size_t bad = firstNotUtf8(text);
    for (std::size_t at = 0; at < text.size();) {
        if (at == bad) {
            result += writtenOut(text.substr(at, 1));
            ++at;
            const std::size_t next = firstNotUtf8(text.substr(at));
            bad = next == text.npos ? next : at + next;
            continue;
        }
        std::size_t control = std::min(controlAt(text, at), bad - at);
        if (kept == Kept::AsciiBlanks && control == 0)
            control = blankAt(text, at);
        const bool isKept = text[at] == '\t' || (text[at] == '\n' && kept == Kept::LineEnds);
        if (control > 0 && !isKept)
            result += writtenOut(text.substr(at, control));
        else
            result += text[at];
        at += std::max<std::size_t>(control, 1);
    }
    return result;
}

} // namespace

std::string printableLine(std::string_view line)
{
    return printable(line, Kept::Tabs);
}

std::string printableBeginning(std::string_view text, std::size_t most)
{
    const std::string_view beginning = firstCharacters(text, most);
    return printable(beginning, Kept::AsciiBlanks) + (beginning.size() < text.size() ? "\xe2\x80\xa6" : "");
}

std::string printableLines(std::string_view text)
{
    return printable(text, Kept::LineEnds);
}

} // namespace unprojector::base
