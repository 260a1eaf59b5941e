#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::text {

/// The ASCII letters, digits and underscores of a name, others as underscores: what a variable's name may end in.
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

/// The same, and another one than those that are taken: the second "face" is "face_2".
inline std::string newIdentifier(std::string_view name, std::vector<std::string> &taken)
{
    std::string result = identifier(name);
    for (int n = 2; std::find(taken.begin(), taken.end(), result) != taken.end(); ++n)
        result = identifier(name) + '_' + std::to_string(n);
    taken.push_back(result);
    return result;
}

/// A name as a comment of one line can hold it, in every language that has such: what ends a line there, and the backslash
/// that would continue it, are underscores.
inline std::string onOneLine(std::string name)
{
    std::replace_if(
        name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\\'; }, '_');
    for (const std::string_view separator : {"\xe2\x80\xa8", "\xe2\x80\xa9"}) { // U+2028, U+2029: JavaScript's
        for (std::size_t at = 0; (at = name.find(separator, at)) != std::string::npos;)
            name.replace(at, separator.size(), "_");
    }
    return name;
}

} // namespace unprojector::text
