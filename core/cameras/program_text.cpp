#include "core/cameras/program_text.h"

#include "core/base/expression.h"
#include "core/base/letters.h"
#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/cameras/scan.h"

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

/// The end of the block of a place: of its braces, or of the lines indented as its own.
std::size_t blockEnd(std::string_view text, std::size_t at)
{
    std::size_t depth = 0, end = at;
    for (; end < text.size(); ++end) {
        if (text[end] == '{')
            ++depth;
        else if (text[end] == '}' && depth-- == 0)
            break;
    }
    const auto indentAt = [&](std::size_t line) { return text.find_first_not_of(" \t", line) - line; };
    const std::size_t begin = text.substr(0, at).find_last_of('\n') + 1, indent = indentAt(begin);
    for (std::size_t line = text.find('\n', at); indent > 0 && line < end; line = text.find('\n', line + 1)) {
        const std::size_t first = text.find_first_not_of(" \t", line + 1);
        if (first != text.npos && text[first] != '\n' && indentAt(line + 1) < indent)
            end = line;
    }
    return end;
}

/// The constants of a text: names that it sets once, to a number, before it uses them in the same block.
class Constants {
public:
    /// @param bare  the text without comments
    /// @param dropsRest  the text may be of a language whose 1 / 2 is 0
    Constants(std::string_view bare, bool dropsRest) : m_dropsRest(dropsRest)
    {
        for (const SourceCall &one : sourceCalls(bare)) {
            if (one.isAssignment && isStatement(bare, one.at))
                add(one.written, valueOf(bare, one), one.at, blockEnd(bare, one.at));
        }
        addLists(bare);
        std::erase_if(m_all, [&](const auto &one) { return !numberOf(one.second.text); });
    }

    /// Adds #define W 640.
    void addDefined(std::string_view text)
    {
        constexpr std::string_view kDefine = "#define ";
        if (text.find("#undef ") != text.npos || text.find("#if") != text.npos) {
            m_all.clear();
            return;
        }
        for (std::size_t at = text.find(kDefine); at != text.npos; at = text.find(kDefine, at + 1)) {
            const std::string_view line = text.substr(at + kDefine.size(), text.find('\n', at) - at - kDefine.size());
            const std::string_view name = namesAt(line, 0);
            const std::string_view value = trimmed(line.substr(name.size(), line.find("//") - name.size()));
            const bool isOne = value.find_first_of("+-*/ ", 1) == value.npos; // others count as their text
            if (!name.empty() && !value.empty())
                add(name, isOne && numberOf(value) ? value : "?", 0, text.npos);
        }
    }

    void drop(std::string_view name) { m_all.erase(name); }
    bool isEmpty() const { return m_all.empty(); }

    /// The constant that a name is at a place; null: it is none there.
    std::optional<std::string_view> textOf(std::string_view name, std::size_t at) const
    {
        const auto found = m_all.find(name);
        const bool isIt = found != m_all.end() && at >= found->second.begin && at < found->second.end;
        return isIt ? std::optional(found->second.text) : std::nullopt;
    }
    bool has(std::string_view name) const { return m_all.contains(name); }
    /// Where a constant is set.
    bool isSetAt(std::string_view name, std::size_t at) const { return m_all.find(name)->second.begin == at; }

    /// The number of an expression. In a language that drops the rest of whole numbers, a quotient with a rest and
    /// without a point is none.
    /// @param at  the place of the expression; empty: any
    std::optional<SourceNumber> numberOf(std::string_view text, const std::optional<std::size_t> &at = {}) const
    {
        bool hasQuotient = text.find('/') != text.npos, hasPoint = text.find('.') != text.npos;
        auto number = sourceNumber(text, [&](std::string_view name) -> std::optional<std::string_view> {
            const auto found = m_all.find(name);
            if (found == m_all.end() || (at && !textOf(name, *at)))
                return std::nullopt;
            hasQuotient = hasQuotient || found->second.text.find('/') != std::string_view::npos;
            hasPoint = hasPoint || found->second.text.find('.') != std::string_view::npos;
            return found->second.text;
        });
        const bool isCut =
            number && m_dropsRest && hasQuotient && !hasPoint && number->value != std::trunc(number->value);
        return isCut ? std::nullopt : number;
    }

private:
    struct Value {
        std::string_view text;
        std::size_t begin = 0, end = 0; ///< of the text in which it counts
    };

    /// Returns whether a place is outside of parentheses and lists in its line.
    static bool isStatement(std::string_view text, std::size_t at)
    {
        const std::string_view before = text.substr(0, at);
        const std::string_view line = before.substr(before.find_last_of('\n') + 1);
        return std::ranges::count(line, '(') == std::ranges::count(line, ')')
               && std::ranges::count(line, '[') == std::ranges::count(line, ']');
    }

    /// The value of an assignment; "?" if more belongs to it: f = 500, 600, or a line that begins with an operator.
    static std::string_view valueOf(std::string_view bare, const SourceCall &one)
    {
        const auto next = bare.find_first_not_of(" \t\r\n", one.end);
        const bool isInLine = bare.find('\n', one.end) > next;
        if (next == bare.npos || (isInLine && isAmong(bare[next], ";})")))
            return one.arguments[0];
        if (isInLine && bare[next] == ',') { // int W = 640, H = 480
            const std::size_t name = behindBlanks(bare, next + 1);
            const std::size_t sign = behindBlanks(bare, name + namesAt(bare, name).size());
            return sign > name && sign < bare.size() && bare[sign] == '=' ? one.arguments[0] : "?";
        }
        return isInLine || isAmong(bare[next], "+-*/%") ? "?" : one.arguments[0];
    }

    /// Adds a value. A name with two values is no constant.
    void add(std::string_view name, std::string_view value, std::size_t at, std::size_t end)
    {
        const auto [found, isNew] = m_all.emplace(name, Value{value, at, end});
        if (!isNew)
            found->second.text = "?";
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
            for (std::size_t i = 0; i < names.size(); ++i) {
                if (namesAt(names[i], 0) != names[i])
                    continue;
                const auto begin = std::size_t(names[i].data() - bare.data());
                if (i + 1 == names.size())
                    m_all.erase(names[i]); // it stands before the sign, and was taken alone
                add(names[i], values.size() == names.size() ? values[i] : "?", begin, blockEnd(bare, begin));
            }
        }
    }

    std::map<std::string_view, Value> m_all;
    bool m_dropsRest;
};

class Writer {
public:
    Writer(std::string_view bare, const Constants &constants) : m_bare(bare), m_constants(constants) {}

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
        const std::size_t next = behindBlanks(m_bare, close + 1);
        const bool isSet = next + 1 < m_bare.size() && m_bare[next] == '=' && m_bare[next + 1] != '='; // (f, g) = …
        if (isSet || m_bare.substr(0, at).ends_with("swap"))
            return close + 1;
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
            if (whole && part && part->value != 0.0 && hasConstant(at, text))
                m_changes[at] = {text.size(), shortestText(std::floor(whole->value / part->value))};
            return whole && part;
        }
        if (!hasConstant(at, text))
            return false;
        const auto number = m_constants.numberOf(text, at);
        if (!number)
            return false;
        m_changes[at] = {text.size(), shortestText(number->value)};
        return true;
    }

    bool hasConstant(std::size_t at, std::string_view text) const
    {
        for (std::size_t i = 0; i < text.size();) {
            const std::string_view name = isLetter(text[i]) ? namesAt(text, i) : std::string_view();
            if (m_constants.textOf(name, at))
                return true;
            i += std::max<std::size_t>(name.size(), 1);
        }
        return false;
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
        if (!call.name.starts_with(kSet) || call.name.size() == kSet.size() || m_bare[end] != '(')
            return;
        const std::string object = lowerCase(call.object);
        const bool isCameras =
            object.find("cam") != object.npos || (call.name == "SetSize" && object.find("win") != object.npos);
        // A second one is of another place or time.
        const std::string written = std::string(call.written) + '(';
        const bool isOne = m_bare.find(written) == m_bare.rfind(written);
        if (isCameras && isOne
            && std::ranges::all_of(call.arguments, [&](auto text) { return bool(m_constants.numberOf(text)); })) {
            m_changes[end - call.name.size()] = {kSet.size(), ""};
            m_changes[end] = {0, "="};
        }
    }

    std::string_view m_bare;
    const Constants &m_constants;
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
    const std::string bare = bareOf(withoutRemarks(text));
    Constants constants(bare, text.find(';') != text.npos);
    constants.addDefined(text);
    auto changes = Writer(bare, constants).changes();
    // A name in any other place may change it: f++, &f, for f in …
    for (bool isDropped = true; isDropped && !constants.isEmpty();) {
        isDropped = false;
        for (std::size_t at = 0; at < bare.size();) {
            const auto next = changes.upper_bound(at);
            const auto change = next == changes.begin() ? changes.end() : std::prev(next);
            const bool isChanged = change != changes.end() && at < change->first + change->second.first;
            const std::string_view name = isLetter(bare[at]) ? namesAt(bare, at) : std::string_view();
            if (!isChanged && constants.has(name) && !constants.isSetAt(name, at)) {
                constants.drop(name);
                isDropped = true;
            }
            at += std::max<std::size_t>(isDigit(bare[at]) ? namesAt(bare, at).size() : name.size(), 1);
        }
        if (isDropped)
            changes = Writer(bare, constants).changes();
    }
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
