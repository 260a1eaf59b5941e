#include "core/cameras/printed_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>

namespace unprojector::cameras {
namespace {

bool isOfName(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Overwrites a part of a text with blanks; line ends stay.
void clear(std::string &text, std::size_t begin, std::size_t end)
{
    for (std::size_t i = begin; i < std::min(end, text.size()); ++i)
        text[i] = text[i] == '\n' ? '\n' : ' ';
}

/// Replaces a part of a text; the part has no line end.
void replace(std::string &text, std::size_t begin, std::size_t end, std::string_view by)
{
    text.replace(begin, end - begin, by);
}

bool isXml(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return begin != text.npos && text[begin] == '<' && begin + 1 < text.size()
           && (text[begin + 1] == '?' || text[begin + 1] == '!' || isOfName(text[begin + 1]))
           && text.find("</") != text.npos;
}

/// Turns tags into names: those that begin an element, without their attributes.
std::string withoutTags(std::string_view text)
{
    std::string names;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] != '<') {
            names += text[at++];
            continue;
        }
        const bool isComment = text.substr(at).starts_with("<!--");
        const std::string_view last = isComment ? "-->" : ">";
        const std::size_t close = text.find(last, at);
        const std::size_t end = close == text.npos ? text.size() : close + last.size();
        const std::string_view tag = text.substr(at + 1, end - at - 1);
        const auto length = std::find_if_not(tag.begin(), tag.end(), isOfName) - tag.begin();
        names += ' ';
        if (length > 0)
            names += std::string(tag.substr(0, std::size_t(length))) + ": ";
        names.append(std::size_t(std::count(tag.begin(), tag.end(), '\n')), '\n');
        at = end;
    }
    return names;
}

/// Clears "Mat_<double>(3, 3) <<".
void clearFillers(std::string &text)
{
    constexpr std::string_view kName = "Mat_<";
    for (std::size_t at = text.find(kName); at != text.npos; at = text.find(kName, at + 1)) {
        const std::size_t end = text.find("<<", at + kName.size());
        if (end == text.npos || text.find(';', at) < end)
            continue;
        const bool hasNamespace = at >= 4 && text.compare(at - 4, 4, "cv::") == 0;
        clear(text, hasNamespace ? at - 4 : at, end + 2);
    }
}

/// Writes "Vec3d t(" as "Vec3d t=": a name behind a type of vectors or matrices.
void nameConstructed(std::string &text)
{
    for (std::size_t open = text.find('('); open != text.npos; open = text.find('(', open + 1)) {
        std::size_t begin = open;
        while (begin > 0 && isOfName(text[begin - 1]))
            --begin;
        std::size_t end = begin;
        while (end > 0 && text[end - 1] == ' ')
            --end;
        std::size_t type = end;
        while (type > 0 && isOfName(text[type - 1]))
            --type;
        const std::string_view name = std::string_view(text).substr(type, end - type);
        const auto begins = [&](const char *with) { return name.starts_with(with); };
        if (begin < open && end < begin && (begins("Mat") || begins("Vec") || begins("Point3")))
            text[open] = '=';
    }
}

/// Writes the comment "# K: pixels from eye" above a line of numbers as "K:".
void nameCommented(std::string &text)
{
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = std::string_view(text).substr(begin, end - begin);
        const std::size_t colon = line.find(':');
        const bool isNamed = line.starts_with("# ") && colon != line.npos && colon > 2
                             && std::all_of(line.begin() + 2, line.begin() + std::ptrdiff_t(colon), isOfName);
        const char next = end + 1 < text.size() ? text[end + 1] : ' ';
        if (isNamed && (std::isdigit(static_cast<unsigned char>(next)) != 0 || next == '-')) {
            text[begin] = ' ';
            clear(text, begin + colon + 1, end);
        }
        begin = end + 1;
    }
}

/// Writes out the numbers of calls such as eye(3).
void writeOutCalls(std::string &text)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kCalls{
        {{"eye(3)", "[1, 0, 0, 0, 1, 0, 0, 0, 1]"},
         {"identity(3)", "[1, 0, 0, 0, 1, 0, 0, 0, 1]"},
         {"eye(4)", "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]"},
         {"zeros(3)", "[0, 0, 0]"},
         {"zeros((3, 1))", "[0, 0, 0]"},
         {"zeros((3,1))", "[0, 0, 0]"},
         {"zeros((1, 3))", "[0, 0, 0]"},
         {"zeros((1,3))", "[0, 0, 0]"},
         {"zeros(4)", "[0, 0, 0, 0]"},
         {"zeros((4, 1))", "[0, 0, 0, 0]"},
         {"zeros((4,1))", "[0, 0, 0, 0]"},
         {"zeros(5)", "[0, 0, 0, 0, 0]"},
         {"zeros((5, 1))", "[0, 0, 0, 0, 0]"},
         {"zeros((5,1))", "[0, 0, 0, 0, 0]"}}};
    for (const auto &[call, numbers] : kCalls) {
        for (std::size_t at = text.find(call); at != text.npos; at = text.find(call, at + numbers.size())) {
            std::size_t begin = at; // "np.eye(3)", "numpy.zeros(3)"
            while (begin > 0 && (isOfName(text[begin - 1]) || text[begin - 1] == '.'))
                --begin;
            replace(text, begin, at + call.size(), numbers);
            at = begin;
        }
    }
}

} // namespace

std::string withNames(std::string_view text)
{
    std::string names = isXml(text) ? withoutTags(text) : std::string(text);
    nameCommented(names);
    clearFillers(names);
    nameConstructed(names);
    writeOutCalls(names);
    return names;
}

} // namespace unprojector::cameras
