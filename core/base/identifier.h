#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

namespace unprojector::base {

/// Converts a name to an identifier suffix: ASCII letters, digits and underscores stay; others
/// become underscores.
inline std::string identifier(std::string_view name)
{
    std::string result;
    for (const char c : name) {
        const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (isPlain)
            result += c;
        else if (result.empty() || result.back() != '_')
            result += '_';
    }
    return result;
}

/// Identifiers that differ from each other. A scene can have 100,000 objects, all of one name: each
/// takes the same short time.
class DistinctIdentifiers {
public:
    /// The identifier of a name; the second "face" is "face_2".
    std::string next(std::string_view name)
    {
        std::string result = identifier(name);
        const auto [known, isNew] = m_given.try_emplace(result, 1);
        if (isNew)
            return result;
        const std::string start = result + '_';
        std::size_t &last = known->second; // stays where it is when the map grows
        do
            result = start + std::to_string(++last);
        while (!m_given.try_emplace(result, 1).second);
        return result;
    }

private:
    std::unordered_map<std::string, std::size_t> m_given; ///< each with the last number that was tried behind it
};

/// The byte count of the control character at a position of UTF-8 text, else 0. It counts
/// characters that show nothing, end a line or change the direction of the following text. These
/// are: the controls of ASCII and of C1, U+2028, U+2029; marks, embeddings and isolates of
/// bidirectional text; zero-width characters; tags. The joiners U+200C and U+200D are none, since
/// names use them in spelling.
inline std::size_t controlAt(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : static_cast<unsigned char>(0);
    };
    const unsigned char a = byte(0), b = byte(1), c = byte(2);
    if (a < 0x20 || a == 0x7f)
        return 1;
    if ((a == 0xc2 && b >= 0x80 && b <= 0x9f) || (a == 0xd8 && b == 0x9c)) // U+061C
        return 2;
    const bool isInGeneral =
        a == 0xe2 && b == 0x80 && (c == 0x8b || c == 0x8e || c == 0x8f || (c >= 0xa8 && c <= 0xae)); // U+200B to U+202E
    const bool isInvisible = a == 0xe2 && b == 0x81 && c >= 0xa0 && c <= 0xaf;                       // U+2060 to U+206F
    if (isInGeneral || isInvisible || (a == 0xef && b == 0xbb && c == 0xbf))
        return 3;
    // U+E0000 to U+E007F; the variants of ideographs behind them belong to names.
    return a == 0xf3 && b == 0xa0 && (c == 0x80 || c == 0x81) ? 4 : 0;
}

/// A name that is safe in a one-line comment of any language and readable in any editor: controls
/// become underscores, and so does the backslash, which would continue the line.
inline std::string onOneLine(std::string_view name)
{
    std::string line;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t control = controlAt(name, at);
        line += control > 0 || name[at] == '\\' ? '_' : name[at];
        at += std::max<std::size_t>(control, 1);
    }
    return line;
}

} // namespace unprojector::base
