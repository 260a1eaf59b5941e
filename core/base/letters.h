#pragma once

namespace unprojector::base {

constexpr bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Returns whether a character is a letter of ASCII; an underscore counts as one.
constexpr bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

} // namespace unprojector::base
