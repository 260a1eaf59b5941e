#include "core/cameras/call_syntax.h"

#include <algorithm>

namespace unprojector::cameras::syntax {

std::size_t behindBlanks(std::string_view text, std::size_t at)
{
    return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
}

std::size_t behindNames(std::string_view text, std::size_t at)
{
    for (;;) {
        while (at < text.size() && (isLetter(text[at]) || isDigit(text[at])))
            ++at;
        const std::string_view rest = text.substr(at);
        const std::size_t joint = rest.starts_with("::") || rest.starts_with("->") ? 2 : rest.starts_with('.') ? 1 : 0;
        if (joint == 0 || at + joint >= text.size() || !isLetter(text[at + joint]))
            return at;
        at += joint;
    }
}

std::size_t behindTemplate(std::string_view text, std::size_t at)
{
    if (at >= text.size() || text[at] != '<')
        return at;
    std::size_t end = at + 1;
    while (end < text.size() && (isLetter(text[end]) || isDigit(text[end]) || text[end] == ':' || text[end] == ' '))
        ++end;
    return end < text.size() && text[end] == '>' ? end + 1 : at;
}

std::size_t closing(std::string_view text, std::size_t at)
{
    std::size_t depth = 0;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '(' || c == '[' || c == '{')
            ++depth;
        else if ((c == ')' || c == ']' || c == '}') && --depth == 0)
            return at;
    }
    return text.npos;
}

std::vector<std::string> separated(std::string_view text)
{
    std::vector<std::string> parts;
    std::size_t depth = 0, start = 0;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const char c = i < text.size() ? text[i] : ',';
        if (c == '(' || c == '[' || c == '{')
            ++depth;
        else if ((c == ')' || c == ']' || c == '}') && depth > 0)
            --depth;
        if (c == ',' && (depth == 0 || i == text.size())) {
            parts.emplace_back(trimmed(text.substr(start, i - start)));
            start = i + 1;
        }
    }
    if (!parts.empty() && parts.back().empty()) // a trailing comma is allowed
        parts.pop_back();
    return parts;
}

std::string lastName(std::string_view names)
{
    std::size_t at = names.size();
    while (at > 0 && (isLetter(names[at - 1]) || isDigit(names[at - 1])))
        --at;
    return std::string(names.substr(at));
}

std::string plain(std::string_view name)
{
    std::string result = base::lowerCase(name);
    std::erase(result, '_');
    return result;
}

} // namespace unprojector::cameras::syntax
