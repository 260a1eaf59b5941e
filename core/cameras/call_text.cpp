#include "core/cameras/call_text.h"

#include "core/cameras/call_syntax.h"

#include <algorithm>
#include <utility>

namespace unprojector::cameras {
using namespace syntax;

namespace {

std::string objectOf(std::string_view names)
{
    std::string_view object = names.substr(0, names.size() - lastName(names).size());
    while (!object.empty() && !isLetter(object.back()) && !isDigit(object.back()))
        object.remove_suffix(1);
    return std::string(object);
}

/// The variable before a position: "camera" of "const camera = new ".
std::string variableBefore(std::string_view text, std::size_t at)
{
    std::string_view before = trimmed(text.substr(0, at));
    if (before.ends_with("new"))
        before = trimmed(before.substr(0, before.size() - 3));
    if (!before.ends_with('='))
        return {};
    before = trimmed(before.substr(0, before.size() - 1));
    std::size_t start = before.size();
    while (start > 0 && (isLetter(before[start - 1]) || isDigit(before[start - 1]) || before[start - 1] == '.'))
        --start;
    return std::string(before.substr(start));
}

/// The closing bracket of each bracket, or npos; also npos for brackets nested deeper than in real
/// programs.
std::vector<std::size_t> closingBrackets(std::string_view text)
{
    constexpr std::size_t kDeepest = 16;
    std::vector<std::size_t> closing(text.size(), text.npos), open;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '(' || c == '[' || c == '{') {
            open.push_back(at);
        } else if ((c == ')' || c == ']' || c == '}') && !open.empty()) {
            if (open.size() <= kDeepest)
                closing[open.back()] = at;
            open.pop_back();
        }
    }
    return closing;
}

} // namespace

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

std::vector<CallText> callTexts(std::string_view text)
{
    const std::vector<std::size_t> closing = closingBrackets(text);
    std::vector<CallText> calls;
    for (std::size_t at = 0; at < text.size();) {
        if (!isLetter(text[at])) {
            // Skips the letters of a number, 1e5f: they begin no name.
            at += isDigit(text[at]) ? behindNames(text, at) - at : 1;
            continue;
        }
        const std::size_t end = behindNames(text, at);
        const std::size_t open = behindBlanks(text, behindTemplate(text, end));
        const std::size_t close = open < text.size() && text[open] == '(' ? closing[open] : text.npos;
        if (close != text.npos) {
            CallText call;
            call.written = text.substr(at, end - at);
            call.object = objectOf(call.written);
            call.name = lastName(call.written);
            call.variable = variableBefore(text, at);
            call.arguments = separated(text.substr(open + 1, close - open - 1));
            call.at = at;
            call.end = close + 1;
            calls.push_back(std::move(call));
        }
        at = std::max(end, at + 1);
    }
    return calls;
}

std::vector<AssignmentText> assignmentTexts(std::string_view text)
{
    std::vector<AssignmentText> assignments;
    for (std::size_t at = 0; at < text.size();) {
        if (!isLetter(text[at])) {
            at += isDigit(text[at]) ? behindNames(text, at) - at : 1;
            continue;
        }
        const std::size_t end = std::max(behindNames(text, at), at + 1);
        const std::size_t sign = behindBlanks(text, end);
        const std::string_view rest = text.substr(std::min(sign, text.size()));
        if (rest.starts_with('=') && !rest.starts_with("==")) {
            const std::string_view value = rest.substr(1, std::min(rest.find_first_of(";\n"), rest.size()) - 1);
            const std::vector<std::string> parts = separated(value); // float n = 0.1f, f = 100.0f;
            if (!parts.empty())
                assignments.push_back({std::string(text.substr(at, end - at)), parts.front(), at,
                                       behindBlanks(text, sign + 1) + parts.front().size()});
        }
        at = end;
    }
    return assignments;
}

} // namespace unprojector::cameras
