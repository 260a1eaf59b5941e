#include "core/cameras/program_text.h"

#include "core/base/expression.h"
#include "core/base/letters.h"
#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::cameras {
using namespace base;

namespace {

/// A call whose arguments have no names in the text.
struct Signature {
    std::string_view names; ///< of the call, between blanks
    std::string_view parameters;
};
constexpr Signature kSignatures[]{
    {" set_intrinsics PinholeCameraIntrinsic CameraInfo ", "width, height, fx, fy, cx, cy"}, // Open3D, Drake
    {" IntrinsicsCamera ", "fx, fy, cx, cy"},                                                // pyrender
    {" OffscreenRenderer ", "width, height"},
    {" Cal3_S2 ", "fx, fy, skew, cx, cy"}, // GTSAM
};

constexpr std::string_view kFloor = "\x01\x01"; ///< in the place of Python's //
constexpr std::string_view kOpening = "([{", kClosing = ")]}";

bool isAmong(char c, std::string_view characters)
{
    return characters.find(c) != characters.npos;
}

/// The constants of a text.
class Constants {
public:
    /// @param bare  the text without comments
    explicit Constants(std::string_view bare)
    {
        for (const SourceCall &one : sourceCalls(bare)) {
            if (one.isAssignment && isStatement(bare, one.at))
                add(one.written, one.arguments[0]);
        }
        addOperators(bare);
        addLists(bare);
        std::erase_if(m_texts, [&](const auto &one) { return !numberOf(one.second); });
    }

    /// Adds #define W 640.
    void addDefined(std::string_view text)
    {
        constexpr std::string_view kDefine = "#define ";
        for (std::size_t at = text.find(kDefine); at != text.npos; at = text.find(kDefine, at + 1)) {
            const std::string_view line = text.substr(at + kDefine.size(), text.find('\n', at) - at - kDefine.size());
            const std::string_view name = namesAt(line, 0);
            const std::string_view value = trimmed(line.substr(name.size(), line.find("//") - name.size()));
            if (!name.empty() && !value.empty() && numberOf(value))
                add(name, value);
        }
    }

    bool isEmpty() const { return m_texts.empty(); }

    std::optional<std::string_view> textOf(std::string_view name) const
    {
        const auto found = m_texts.find(name);
        return found == m_texts.end() ? std::nullopt : std::optional(found->second);
    }

    std::optional<SourceNumber> numberOf(std::string_view text) const
    {
        return sourceNumber(text, [this](std::string_view name) { return textOf(name); });
    }

private:
    /// Returns whether a place is outside of parentheses and lists in its line.
    static bool isStatement(std::string_view text, std::size_t at)
    {
        const std::string_view before = text.substr(0, at);
        const std::string_view line = before.substr(before.find_last_of('\n') + 1);
        return std::ranges::count(line, '(') == std::ranges::count(line, ')')
               && std::ranges::count(line, '[') == std::ranges::count(line, ']');
    }

    /// Adds a value. A name with two values is no constant.
    void add(std::string_view name, std::string_view value)
    {
        const auto [found, isNew] = m_texts.emplace(name, value);
        if (!isNew && found->second != value)
            found->second = "?";
    }

    /// Drops the names that the text changes, as by f *= 0.5, or sets in a loop.
    void addOperators(std::string_view bare)
    {
        for (std::size_t at = bare.find('='); at != bare.npos; at = bare.find('=', at + 1)) {
            const auto end = at > 0 && isAmong(bare[at - 1], "+-*/") ? at - 1 : 0;
            const auto last = end > 0 ? bare.find_last_not_of(' ', end - 1) : bare.npos;
            if (last == bare.npos)
                continue;
            const auto first = bare.find_last_of(" \t\n;(){}", last) + 1;
            add(bare.substr(first, last + 1 - first), "?");
        }
        for (std::size_t at = bare.find("for "); at != bare.npos; at = bare.find("for ", at + 1))
            add(namesAt(bare, behindBlanks(bare, at + 4)), "?");
        for (const std::string_view step : {"++", "--"}) {
            for (std::size_t at = bare.find(step); at != bare.npos; at = bare.find(step, at + 2)) {
                const auto first = bare.find_last_of(" \t\n;(){}", at) + 1;
                if (first < at)
                    add(bare.substr(first, at - first), "?");
            }
        }
    }

    /// Adds W, H = 640, 480.
    void addLists(std::string_view bare)
    {
        for (std::size_t at = 0; at < bare.size(); at = std::min(bare.find('\n', at), bare.size() - 1) + 1) {
            const std::string_view line = trimmed(bare.substr(at, bare.find_first_of(";\n", at) - at));
            const std::size_t sign = line.find('=');
            const auto names = commaSeparated(line.substr(0, sign));
            if (sign == line.npos || names.size() < 2 || sign + 1 == line.size())
                continue;
            const auto values = commaSeparated(line.substr(sign + 1));
            for (std::size_t i = 0; i < names.size() && values.size() == names.size(); ++i) {
                if (namesAt(names[i], 0) == names[i]) {
                    m_texts.erase(names[i]); // the last name stands before the sign, and was taken alone
                    add(names[i], values[i]);
                }
            }
        }
    }

    std::map<std::string_view, std::string_view> m_texts;
};

class Writer {
public:
    /// @param dropsRest  the text may be of a language whose 1 / 2 is 0
    Writer(std::string_view bare, const Constants &constants, bool dropsRest)
        : m_bare(bare), m_constants(constants), m_dropsRest(dropsRest)
    {
    }

    /// @return the places that change, with their new texts, in the order of the text
    std::map<std::size_t, std::pair<std::size_t, std::string>> changes()
    {
        for (std::size_t at = 0; at < m_bare.size();) {
            if (const std::size_t quote = behindQuotes(at); quote > at)
                at = quote;
            else if (isAmong(m_bare[at], kOpening))
                at = readList(at);
            else
                ++at;
        }
        for (const SourceCall &one : sourceCalls(m_bare)) {
            if (one.isAssignment)
                readElement(std::size_t(one.arguments[0].data() - m_bare.data()), one.arguments[0]);
            else
                readArguments(one);
        }
        return std::move(m_changes);
    }

private:
    std::size_t behindQuotes(std::size_t at) const
    {
        if (!isAmong(m_bare[at], "\"'"))
            return at;
        const auto end = m_bare.find_first_of(std::string{m_bare[at], '\n'}, at + 1);
        return end == m_bare.npos || m_bare[end] == '\n' ? at : end + 1;
    }

    /// Reads the elements of a list, and of those in it.
    /// @return what is behind its first bracket
    std::size_t readList(std::size_t at)
    {
        const std::size_t close = closingBracket(m_bare, at);
        if (close == m_bare.npos || m_bare[at] == '{') {
            const bool isBlock = m_bare[at] == '{' && m_bare.substr(at, close - at).find(';') != m_bare.npos;
            if (close == m_bare.npos || isBlock)
                return at + 1;
        }
        std::size_t start = at + 1, depth = 0;
        for (std::size_t i = at + 1; i <= close; ++i) {
            const char c = m_bare[i];
            if (i == close || (depth == 0 && isAmong(c, ",;\n"))) {
                readElement(start, m_bare.substr(start, i - start));
                start = i + 1;
            } else if (isAmong(c, kOpening)) {
                ++depth;
            } else if (isAmong(c, kClosing)) {
                --depth;
            }
        }
        return at + 1;
    }

    void readElement(std::size_t at, std::string_view text)
    {
        // fov=60, fx: 500, (cv::Mat_<double>(3, 3) << f
        for (const std::string_view sign : {"<<", "=", ":"}) {
            const auto found = text.rfind(sign);
            const bool isPart = sign == ":" && found != text.npos && found > 0 && text[found - 1] == ':';
            if (found == text.npos || isPart)
                continue;
            at += found + sign.size();
            text.remove_prefix(found + sign.size());
            break;
        }
        if (replace(at, text))
            return;
        // MATLAB's [f 0 w/2]
        std::vector<std::pair<std::size_t, std::string_view>> words;
        TextScanner scanner(text);
        for (auto word = scanner.nextWord(); !word.empty(); word = scanner.nextWord())
            words.emplace_back(at + std::size_t(word.data() - text.data()), word);
        if (std::ranges::all_of(words, [&](const auto &word) { return bool(m_constants.numberOf(word.second)); })) {
            for (const auto &[place, word] : words)
                replace(place, word);
        }
    }

    /// Replaces an expression with constants by its value. Returns whether it is one.
    bool replace(std::size_t at, std::string_view text)
    {
        const auto first = text.find_first_not_of(" \t\r\n");
        if (first == text.npos)
            return false;
        at += first;
        text = trimmed(text);
        if (const auto floor = text.find(kFloor); floor != text.npos) {
            const auto whole = m_constants.numberOf(text.substr(0, floor)),
                       part = m_constants.numberOf(text.substr(floor + kFloor.size()));
            if (whole && part && part->value != 0.0)
                m_changes[at] = {text.size(), shortestText(std::floor(whole->value / part->value))};
            return whole && part;
        }
        bool hasConstant = false;
        const auto number = sourceNumber(text, [&](std::string_view name) {
            const auto value = m_constants.textOf(name);
            hasConstant = hasConstant || value;
            return value;
        });
        if (!number || !hasConstant)
            return false;
        std::string value = shortestText(number->value);
        if (!number->wholeQuotient.empty() && m_dropsRest) { // the reader tells what a language makes of it
            value.clear();
            for (std::size_t i = 0; i < text.size();) {
                const std::string_view name = isLetter(text[i]) ? namesAt(text, i) : std::string_view();
                const auto constant = m_constants.textOf(name);
                value += constant ? std::string(*constant) : name.empty() ? std::string(1, text[i]) : std::string(name);
                i += std::max<std::size_t>(name.size(), 1);
            }
        }
        m_changes[at] = {text.size(), value};
        return true;
    }

    void readArguments(const SourceCall &call)
    {
        for (const Signature &one : kSignatures) {
            const auto parameters = commaSeparated(one.parameters);
            const bool areNumbers =
                isListed(one.names, call.name) && call.arguments.size() == parameters.size()
                && std::ranges::all_of(call.arguments, [&](auto text) { return bool(m_constants.numberOf(text)); });
            for (std::size_t i = 0; areNumbers && i < parameters.size(); ++i) {
                const std::string_view argument = call.arguments[i];
                auto &[length, text] = m_changes[std::size_t(argument.data() - m_bare.data())];
                if (length == 0)
                    text = argument; // else its value
                length = argument.size();
                text.insert(0, std::string(parameters[i]) + '=');
            }
        }
        // camera->SetPosition(1, 2, 3), as Position=(1, 2, 3)
        constexpr std::string_view kSet = "Set";
        const std::size_t end = call.at + call.written.size();
        if (call.name.starts_with(kSet) && call.name.size() > kSet.size() && m_bare[end] == '('
            && std::ranges::all_of(call.arguments, [&](auto text) { return bool(m_constants.numberOf(text)); })) {
            m_changes[end - call.name.size()] = {kSet.size(), ""};
            m_changes[end] = {0, "="};
        }
    }

    std::string_view m_bare;
    const Constants &m_constants;
    bool m_dropsRest;
    std::map<std::size_t, std::pair<std::size_t, std::string>> m_changes;
};

} // namespace

namespace {

/// The text without comments, with kFloor for the // of "W // 2".
std::string bareOf(std::string text)
{
    for (std::size_t at = text.find("//"); at != text.npos; at = text.find("//", at + 2)) {
        const auto last = at == 0 ? text.npos : text.find_last_not_of(' ', at - 1);
        const auto next = text.find_first_not_of(' ', at + 2), end = text.find_first_not_of("0123456789 ", at + 2);
        const bool isFloor = last != text.npos && (isLetter(text[last]) || isDigit(text[last]) || text[last] == ')')
                             && next != text.npos && isDigit(text[next]) && end != text.npos
                             && isAmong(text[end], ",])");
        if (isFloor)
            text.replace(at, kFloor.size(), kFloor);
    }
    return withoutComments(text);
}

} // namespace

std::string withValues(std::string text)
{
    constexpr std::size_t kLongest = 100'000; // too long for a program that sets a camera
    if (text.size() > kLongest)
        return text;
    const std::string bare = bareOf(text);
    Constants constants(bare);
    constants.addDefined(text);
    const auto changes = Writer(bare, constants, text.find(';') != text.npos).changes();
    std::size_t at = 0;
    std::string changed;
    for (const auto &[place, change] : changes) {
        if (place < at)
            continue; // in an expression that has a value
        changed += text.substr(at, place - at) + change.second;
        at = place + change.first;
    }
    return changed + text.substr(at);
}

} // namespace unprojector::cameras
