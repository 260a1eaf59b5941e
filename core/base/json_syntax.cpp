#include "core/base/json_syntax.h"

#include "core/base/translation.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <iterator>

namespace unprojector::base {
namespace {

struct Kind {
    std::string_view sign; ///< a part of the library's message
    const char *english;
};

constexpr const char *kNotUtf8 = marked("a byte here is not UTF-8; save the file as UTF-8");

/// The first matching sign in a message counts.
constexpr Kind kKinds[] = {
    {"ill-formed UTF-8", kNotUtf8},
    {"invalid BOM", kNotUtf8},
    {"number overflow", marked("%1 is too large for a number")},
    {"missing closing quote", marked("a text in quotes does not end; close it with \"")},
    {"control character", marked("a text in quotes holds a line break, a tab or another control character; write \\n, "
                                 "\\t or \\u and its number")},
    {"forbidden character", marked("a text in quotes holds a backslash that JSON does not know; write \\\\ for a "
                                   "backslash")},
    {"4 hex digits", marked("\\u lacks its 4 hexadecimal digits")},
    {"surrogate", marked("half of a \\u surrogate pair is missing; write both halves or the character itself")},
    {"unexpected end of input", marked("the file ends too early; a bracket or a value is missing")},
    {"invalid number", marked("%1 is not a number; write one such as 1, -0.5 or 2e3")},
    {"expected end of input", marked("%1 follows the end")},
    {"while parsing object key", marked("%1 found where a key in double quotes is expected")},
    {"while parsing object separator", marked("%1 found where \":\" is expected")},
    {"while parsing object", marked("%1 found where \",\" or \"}\" is expected")},
    {"while parsing array", marked("%1 found where \",\" or \"]\" is expected")},
    {"while parsing value", marked("%1 found where a value is expected")},
    {"", marked("this is not JSON")},
};

constexpr std::string_view kSigns = ",:{}[]\"";
constexpr std::string_view kBetweenWords = " \t\r\n,:{}[]\"";

/// The library's message without the text that it read last, which may contain anything.
std::string withoutLastRead(std::string_view message)
{
    constexpr std::string_view kLastRead = "; last read: '";
    const std::size_t from = message.find(kLastRead), to = message.rfind("'; expected ");
    std::string without(message.substr(0, from));
    if (from != message.npos && to != message.npos && to > from)
        without += message.substr(to);
    return without;
}

/// The token at a position: a text with its quotes, a sign, a word or a number.
std::string_view tokenAt(std::string_view text, std::size_t at)
{
    text.remove_prefix(std::min(at, text.size()));
    if (text.empty())
        return text;
    if (text.front() == '"') {
        std::size_t end = 1;
        while (end < text.size() && text[end] != '"')
            end += text[end] == '\\' ? 2U : 1U;
        return text.substr(0, end + 1);
    }
    if (kSigns.find(text.front()) != kSigns.npos)
        return text.substr(0, 1);
    return text.substr(0, text.find_first_of(kBetweenWords));
}

/// The start of the word around a position.
std::size_t wordBegin(std::string_view text, std::size_t at)
{
    const auto isInWord = [text](std::size_t place) {
        return place < text.size() && kBetweenWords.find(text[place]) == kBetweenWords.npos;
    };
    while (at > 0 && isInWord(at) && isInWord(at - 1))
        --at;
    return at;
}

/// The beginning of a token for a message; empty if it is not UTF-8.
std::string quotable(std::string_view token)
{
    constexpr std::size_t kMost = 24;
    const std::string_view begin = token.substr(0, kMost);
    std::string quoted(begin.substr(0, firstNotUtf8(begin)));
    std::replace_if(
        quoted.begin(), quoted.end(),
        [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            return byte < 0x20 || byte == 0x7f;
        },
        '?');
    return quoted.empty() || token.size() <= kMost ? quoted : quoted + "\xE2\x80\xA6";
}

} // namespace

JsonMistake jsonMistake(std::string_view text, std::size_t position, std::string_view lastToken,
                        std::string_view parserMessage)
{
    const std::string message = withoutLastRead(parserMessage);
    const auto has = [&message](std::string_view sign) { return message.find(sign) != message.npos; };
    // The library reads numbers and texts as tokens; it appends signs and words to its last token.
    const std::size_t begin = position > lastToken.size() ? position - lastToken.size() : 0;
    const std::size_t last = std::min(position > 0 ? position - 1 : 0, text.size());
    JsonMistake mistake;
    if (has("invalid string"))
        mistake.at = last;
    else if (has("invalid number") || has("number overflow") || tokenAt(text, begin) == lastToken)
        mistake.at = begin;
    else
        mistake.at = wordBegin(text, last);

    const auto *kind =
        std::find_if(std::begin(kKinds), std::end(kKinds), [&has](const Kind &k) { return has(k.sign); });
    const std::string_view written = tokenAt(text, mistake.at);
    const std::string token = quotable(written);
    const bool isBinary = token.empty() && !written.empty();
    mistake.text = isBinary ? tr(kNotUtf8) : tr(kind->english, token);
    return mistake;
}

} // namespace unprojector::base
