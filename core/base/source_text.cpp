#include "core/base/source_text.h"

#include "core/base/letters.h"
#include "core/base/text_scanner.h"

#include <algorithm>
#include <utility>

namespace unprojector::base {

namespace {

bool isOfName(char c)
{
    return isLetter(c) || isDigit(c);
}

bool isOpening(char c)
{
    return c == '(' || c == '[' || c == '{';
}

bool isClosing(char c)
{
    return c == ')' || c == ']' || c == '}';
}

/// The text before the first comma outside brackets, semicolon or line end.
std::string_view firstValue(std::string_view text)
{
    std::size_t depth = 0, i = 0;
    for (; i < text.size() && text[i] != ';' && text[i] != '\n' && (text[i] != ',' || depth > 0); ++i) {
        if (isOpening(text[i]))
            ++depth;
        else if (isClosing(text[i]) && depth > 0)
            --depth;
    }
    return text.substr(0, i);
}

} // namespace

std::size_t behindBlanks(std::string_view text, std::size_t at)
{
    return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
}

std::string_view namesAt(std::string_view text, std::size_t at)
{
    for (std::size_t end = at;;) {
        while (end < text.size() && isOfName(text[end]))
            ++end;
        const std::string_view rest = text.substr(end);
        const std::size_t joint = rest.starts_with("::") || rest.starts_with("->") ? 2 : rest.starts_with('.') ? 1 : 0;
        if (joint == 0 || joint >= rest.size() || !isLetter(rest[joint]))
            return text.substr(at, end - at);
        end += joint;
    }
}

std::size_t behindTemplate(std::string_view text, std::size_t at)
{
    const std::size_t end =
        text.substr(at).starts_with('<') ? text.find_first_of("<>()[]{}=+-*/&|,;.'\"\n", at + 1) : text.npos;
    return end != text.npos && text[end] == '>' ? end + 1 : at;
}

std::string_view lastName(std::string_view names)
{
    return names.substr(std::min(names.find_last_of(".:>") + 1, names.size()));
}

std::string_view namesBefore(std::string_view names)
{
    names.remove_suffix(lastName(names).size());
    return names.substr(0, names.find_last_not_of(".:->") + 1);
}

std::string plainName(std::string_view names)
{
    std::string result = lowerCase(lastName(names));
    std::erase(result, '_');
    return result;
}

bool isListed(std::string_view list, std::string_view word)
{
    for (std::size_t at = list.find(word); !word.empty() && at != list.npos; at = list.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' '))
            return true;
    }
    return false;
}

std::size_t closingBracket(std::string_view text, std::size_t at)
{
    constexpr std::size_t kDeepest = 16;
    for (std::size_t depth = 0; at < text.size(); ++at) {
        if (isOpening(text[at]) ? ++depth > kDeepest : depth == 0)
            break;
        if (isClosing(text[at]) && --depth == 0)
            return at;
    }
    return text.npos;
}

std::vector<std::string_view> commaSeparated(std::string_view text)
{
    std::vector<std::string_view> parts;
    std::size_t depth = 0, start = 0;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const char c = i < text.size() ? text[i] : ',';
        if (isOpening(c))
            ++depth;
        else if (isClosing(c) && depth > 0)
            --depth;
        if (c == ',' && (depth == 0 || i == text.size())) {
            parts.push_back(trimmed(text.substr(start, i - start)));
            start = i + 1;
        }
    }
    if (parts.back().empty()) // a trailing comma is allowed
        parts.pop_back();
    return parts;
}

std::string withoutComments(std::string_view text)
{
    std::string result(text);
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        std::size_t length = 0;
        if (rest.starts_with("/*"))
            length = std::min(rest.find("*/", 2), rest.size() - 2) + 2;
        else if (rest.starts_with("//") || rest.starts_with('#'))
            length = std::min(rest.find('\n'), rest.size());
        for (std::size_t i = at; i < at + length; ++i) {
            if (result[i] != '\n')
                result[i] = ' ';
        }
        at += std::max<std::size_t>(length, 1);
    }
    return result;
}

std::vector<SourceCall> sourceCalls(std::string_view text)
{
    std::vector<SourceCall> calls;
    std::string_view variable;             // of the last assignment
    std::size_t valueAt = 0, valueEnd = 0; // valueEnd: of the longest one so far
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view names = namesAt(text, at);
        SourceCall call{names, namesBefore(names), lastName(names), {}, {}, at};
        if (!isLetter(text[at])) {
            // Skips the letters of a number, 1e5f: they begin no name.
            at += isDigit(text[at]) ? names.size() : 1;
            continue;
        }
        at += names.size();
        const std::size_t open = behindBlanks(text, behindTemplate(text, at)), sign = behindBlanks(text, at);
        const std::string_view behind = text.substr(sign);
        if (text.substr(open).starts_with('(')) {
            const std::size_t close = closingBracket(text, open);
            if (close == text.npos)
                continue;
            if (const std::string_view between = trimmed(text.substr(valueAt, call.at - valueAt));
                between.empty() || between == "new")
                call.variable = variable;
            call.arguments = commaSeparated(text.substr(open + 1, close - open - 1));
            call.end = close + 1;
        } else if (behind.starts_with('=') && !behind.starts_with("==")) {
            variable = names;
            valueAt = sign + 1;
            // A value in another one is short. Else each of "a = a = a = …" would be searched to the end.
            constexpr std::size_t kLongestInner = 400;
            const bool isInner = call.at < valueEnd;
            const std::string_view found = firstValue(behind.substr(1, isInner ? kLongestInner : behind.npos));
            const std::string_view value = trimmed(found);
            valueEnd = std::max(valueEnd, valueAt + found.size());
            if (value.empty() || (isInner && found.size() == kLongestInner))
                continue;
            call.arguments = {value};
            call.end = behindBlanks(text, valueAt) + value.size();
            call.isAssignment = true;
        } else {
            continue;
        }
        calls.push_back(std::move(call));
    }
    return calls;
}

} // namespace unprojector::base
