#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::text {

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

/// The same, made unique among the taken ones: the second "face" is "face_2".
inline std::string newIdentifier(std::string_view name, std::vector<std::string> &taken)
{
    std::string result = identifier(name);
    for (int n = 2; std::find(taken.begin(), taken.end(), result) != taken.end(); ++n)
        result = identifier(name) + '_' + std::to_string(n);
    taken.push_back(result);
    return result;
}

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

} // namespace unprojector::text
