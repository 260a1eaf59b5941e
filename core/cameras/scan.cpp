#include "core/cameras/scan.h"

#include "core/base/expression.h"
#include "core/base/letters.h"
#include "core/base/text_scanner.h"
#include "core/geometry/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace unprojector::cameras {
using base::isDigit;
using base::isLetter;

namespace {

constexpr std::string_view kMinusSign = "\xe2\x88\x92"; // U+2212, of typeset numbers
constexpr std::string_view kDigits = "0123456789";
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// What printing adds to numbers. In a pattern, # is digits, ~ a digit, % a side of a matrix, & letters
/// and digits, ^ six hexadecimal digits or more, @ a letter, _ blanks, * the rest of a time, ! the
/// rest of a component. What follows ` is not a part of the mark.
struct Mark {
    std::string_view pattern;
    std::string_view behind = {}; ///< what must stand before it: this, a letter (@), or one of the characters after [
};

constexpr std::string_view kApart = "[ \t\n({,";
constexpr std::array kMarks{
    Mark{"~~~~-~~-~~*"},
    Mark{"~~:~~:~~,#"},
    Mark{"~~:~~:~~*"},
    Mark{":#`:", "@"}, // main.cpp:123:
    Mark{"(#)", "Array"},
    Mark{"(#)", "Buffer"},
    Mark{"(#)_`[", "[ \t\n=:({,"},
    Mark{"%\xc3\x97%"}, // 4×4
    Mark{"% x %"},
    Mark{"%x%"},
    Mark{"Matrix 4x4"},
    Mark{"Columns # through #"},
    Mark{"Mat&<&>(#,_#)_<<"},
    Mark{"cv::Mat&<&>(#,_#)_<<"},
    Mark{"[,#]"}, // R
    Mark{"[#,]"},
    Mark{"[#,_#]`(", kApart}, // ublas
    Mark{"[#]`@", kApart},    // Go
    Mark{"[#]`)", kApart},    // lldb
    Mark{"[#]` =", kApart},   // PHP
    Mark{"[#]`:", "In "},     // IPython
    Mark{"[f32; #]"},
    Mark{"[f64; #]"},
    Mark{", r = !, s = !"}, // GLM in a debugger
    Mark{", g = !, t = !"},
    Mark{", b = !, p = !"},
    Mark{", a = !, q = !"},
    Mark{"$# ="},
    Mark{"0x^", "[(@ "},
};

bool isAlnum(char c)
{
    return isLetter(c) || isDigit(c);
}

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

bool isAmong(char c, std::string_view some)
{
    return some.find(c) != some.npos;
}

/// Returns whether every comma that no blank follows stands between two digits, no number has a
/// point or two commas, and there are as many as fractions in a matrix.
bool hasDecimalCommas(std::string_view text)
{
    constexpr std::size_t kFewest = 6;
    std::size_t count = 0, last = 0;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        const bool isBetween = isDigit(text[i - 1]) && isDigit(text[i + 1]);
        if (text[i] == '.' && isBetween)
            return false;
        if (text[i] != ',' || isBlank(text[i + 1]) || text[i + 1] == '\n')
            continue;
        if (!isBetween || (last > 0 && text.find_first_not_of(kDigits, last + 1) == i))
            return false;
        last = i;
        ++count;
    }
    return count >= kFewest;
}

bool isXml(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return begin != text.npos && text[begin] == '<' && begin + 1 < text.size()
           && (isAlnum(text[begin + 1]) || isAmong(text[begin + 1], "?!")) && text.find("</") != text.npos;
}

/// Parses a number, with the f of a C float or the D of a signed Fortran exponent.
std::optional<double> numberOf(std::string word)
{
    if (const std::size_t d = word.find_first_of("dD");
        d != word.npos && d > 0 && d + 2 < word.size() && isAmong(word[d + 1], "+-"))
        word[d] = 'e';
    if (word.size() > 1 && isAmong(word.back(), "fF") && word.find_first_of(kDigits) != word.npos)
        word.pop_back();
    return base::numberIn<double>(std::string_view(word).substr(word.size() > 1 && word.front() == '+' ? 1 : 0));
}

/// Returns whether a word stands for a number that cannot be read: the output of other languages
/// and broken programs, or an overflow, as in 1.#QNAN, 0x10, 1d0, 1e400. If it were skipped,
/// another number would take its position.
bool isMeantAsNumber(std::string_view word)
{
    word.remove_prefix(isAmong(word.front(), "+-") ? 1 : 0);
    return word.find('#') != word.npos || word.starts_with("0x") || word.starts_with("0X")
           || word.find_first_not_of("0123456789.eEdD+-") == word.npos;
}

class Scanner {
public:
    explicit Scanner(std::string_view text)
        : m_text(text), m_isXml(isXml(text)), m_hasDecimalCommas(hasDecimalCommas(text))
    {
    }

    std::vector<Group> scan()
    {
        m_groups.emplace_back();
        findLabels();
        while (m_at < m_text.size())
            readOne();
        endName(GroupKind::Word);
        return std::move(m_groups);
    }

private:
    char at(std::size_t i) const { return i < m_text.size() ? m_text[i] : '\0'; }
    char before() const { return m_at > 0 ? m_text[m_at - 1] : '\n'; }
    bool isHere(std::string_view part) const { return m_text.substr(m_at).starts_with(part); }
    bool isInComment() const { return m_commentEnd > 0; }
    std::size_t lineEnd() const { return std::min(m_text.find('\n', m_at), m_text.size()); }

    template <class Is>
    std::size_t behind(std::size_t i, const Is &is) const
    {
        while (i < m_text.size() && is(m_text[i]))
            ++i;
        return i;
    }

    void readOne()
    {
        const char c = m_text[m_at];
        if (isInComment() && m_at >= m_commentEnd) {
            endName(GroupKind::Comment);
            m_commentEnd = 0;
        }
        if (c == '\n')
            return endLine();
        if (isBlank(c) || std::erase(m_labels, m_at) > 0) {
            ++m_at;
            return;
        }
        if (!isInComment() && (readMark() || readTag() || readComment() || readQuoted()))
            return;
        if (isNumberHere())
            readNumber();
        else if (isLetter(c))
            readWord();
        else
            readSign(c);
        m_isLineBlank = false;
    }

    /// The length of the pattern's mark here, or 0.
    std::size_t lengthOf(const Mark &mark) const
    {
        const std::string_view before = mark.behind;
        std::size_t end = m_at;
        std::optional<std::size_t> markEnd;
        for (const char code : mark.pattern) {
            const std::size_t begin = end;
            const char c = at(end);
            switch (code) {
            case '`': markEnd = end; continue;
            case '_': end = behind(end, isBlank); continue;
            case '&': end = behind(end, isAlnum); continue;
            case '*': end = behind(end, [](char one) { return isAmong(one, "0123456789:.TZ"); }); continue;
            case '!': end = std::min(m_text.find_first_of(",})\n", end), m_text.size()); continue;
            case '#': end = behind(end, isDigit); break;
            case '~': end += std::size_t(isDigit(c)); break;
            case '@': end += std::size_t(isLetter(c)); break;
            case '%': end += std::size_t(isAmong(c, "1234") && !isDigit(at(end + 1)) && at(end + 1) != '.'); break;
            case '^':
                end = behind(end, [](char one) { return isAmong(one, "0123456789abcdefABCDEF"); });
                end = end < begin + 6 ? begin : end;
                break;
            default: end += std::size_t(c == code);
            }
            if (end == begin)
                return 0;
        }
        const char last = this->before();
        const bool isIt = before.empty()          ? true
                          : before == "@"         ? isLetter(last)
                          : before.front() == '[' ? isAmong(last, before.substr(1))
                                                  : m_text.substr(0, m_at).ends_with(before);
        return isIt ? markEnd.value_or(end) - m_at : 0;
    }

    bool readMark()
    {
        for (const Mark &mark : kMarks) {
            const std::size_t length = lengthOf(mark);
            if (length == 0)
                continue;
            if (isLetter(m_text[m_at]))
                m_groups.push_back({m_text.substr(m_at, length), GroupKind::Type, false, m_line});
            m_at += length;
            m_isLineBlank = false;
            return true;
        }
        return false;
    }

    /// Reads XML's <fx> as a name, and skips its other tags.
    bool readTag()
    {
        if (!m_isXml || m_text[m_at] != '<')
            return false;
        endName(GroupKind::Word);
        const std::string_view last = isHere("<!--") ? "-->" : ">";
        const std::size_t close = m_text.find(last, m_at), end = behind(m_at + 1, isAlnum);
        if (end > m_at + 1)
            add(GroupKind::Name, m_text.substr(m_at + 1, end - m_at - 1));
        const std::size_t next = close == m_text.npos ? m_text.size() : close + last.size();
        m_line +=
            std::size_t(std::count(m_text.begin() + std::ptrdiff_t(m_at), m_text.begin() + std::ptrdiff_t(next), '\n'));
        m_at = next;
        return true;
    }

    bool readComment()
    {
        const bool isBlock = isHere("/*");
        const char c = m_text[m_at];
        const bool isLine = c == '#' || isHere("//") || (c == '%' && m_isLineBlank);
        if (!(isBlock || isLine) || !isAmong(before(), " \t\n;{[(") || (c == '#' && isDigit(at(m_at + 1))))
            return false;
        const std::size_t end = lineEnd(), close = isBlock ? m_text.find("*/", m_at + 2) : m_text.npos;
        endLineName(end);
        // `unproject matrices` names numbers so: "# K: pixels from eye"
        const std::size_t name = m_at + 2, nameEnd = behind(name, isAlnum);
        const bool isNamed =
            c == '#' && at(name - 1) == ' ' && nameEnd > name && at(nameEnd) == ':' && m_isLineBlank && m_open.empty();
        if (isNamed && (isDigit(at(end + 1)) || at(end + 1) == '-')) {
            add(GroupKind::Name, m_text.substr(name, nameEnd - name));
            m_at = nameEnd;
        }
        m_commentEnd = close == m_text.npos ? end : close + 2;
        ++m_at;
        return true;
    }

    /// Reads a quoted name or value. Returns whether the quote ends in its line.
    bool readQuoted()
    {
        const char c = m_text[m_at];
        if (m_at < m_quoteEnd || (c != '"' && (c != '\'' || isAlnum(before()) || isAmong(before(), "])"))))
            return false;
        const std::size_t end = m_text.find_first_of(std::array{c, '\n', '\0'}.data(), m_at + 1);
        if (end == m_text.npos || m_text[end] == '\n')
            return false;
        const std::string_view quoted = m_text.substr(m_at + 1, end - m_at - 1);
        const std::size_t next = behind(end + 1, isBlank);
        const bool isKey = isAmong(at(next), ":=");
        constexpr std::size_t kList = 8;
        std::size_t numbers = 0;
        for (std::size_t i = m_at + 1; i < end; ++i)
            numbers += std::size_t(isDigit(m_text[i]) && isAmong(m_text[i - 1], " ,;([=-"));
        const bool isNumber = quoted.find_first_of(kDigits) != quoted.npos
                              && quoted.find_first_not_of("0123456789+-.eE,;()[] \t") == quoted.npos;
        m_isLineBlank = false;
        if (isKey && isNumber && quoted.size() <= 2 && quoted.find_first_not_of(kDigits) == quoted.npos) {
            m_subscripts = {base::numberIn<int>(quoted).value_or(0)};
        } else if (isKey) {
            endName(GroupKind::Word);
            add(GroupKind::Name, quoted);
            m_groups.back().isQuoted = true;
        } else if (isNumber || numbers >= kList) {
            endName(GroupKind::Name);
            if (isNumber)
                add(GroupKind::Word, quoted);
            m_quoteEnd = end + 1;
            ++m_at;
            return true;
        } else {
            endName(GroupKind::Name);
            add(GroupKind::Word, quoted);
        }
        m_isBehindEquals = isKey;
        m_at = isKey ? next + 1 : end + 1;
        return true;
    }

    void endLine()
    {
        endLineName(m_at);
        ++m_line;
        ++m_at;
        m_isLineBlank = true;
        m_isBehindEquals = false;
        findLabels();
    }

    /// Ends a name with its line. If it is alone there, it may name the numbers below.
    void endLineName(std::size_t end)
    {
        const std::size_t next =
            m_name.empty() || !m_isNameFirst ? m_text.npos : m_text.find_first_not_of(" \t\r\n", end);
        endName(isDigit(at(next)) || isAmong(at(next), "-+.[(<") ? GroupKind::Name : GroupKind::Word);
    }

    /// The first words of the line that begins at `i`, which moves to the next line. Blanks and the
    /// lines of a table, in ASCII or UTF-8, are between words.
    std::vector<std::string_view> wordsOfLine(std::size_t &i) const
    {
        constexpr std::size_t kMost = 6;
        const auto isBetween = [](char c) { return isBlank(c) || c == '|' || static_cast<unsigned char>(c) >= 0x80; };
        const std::size_t end = std::min(m_text.find('\n', i), m_text.size());
        std::vector<std::string_view> words;
        for (i = behind(i, isBetween); i < end && words.size() < kMost; i = behind(i, isBetween)) {
            const std::size_t begin = i;
            i = behind(i, [&](char c) { return c != '\n' && !isBetween(c); });
            words.push_back(m_text.substr(begin, i - begin));
        }
        i = end + 1;
        return words;
    }

    /// Finds the labels of pandas and of console.table: a line 0 1 2 3 above four lines that begin
    /// with 0 to 3 and have four numbers.
    void findLabels()
    {
        constexpr std::string_view kLabels = "0123";
        std::size_t i = m_at;
        std::vector<std::string_view> head = wordsOfLine(i), row;
        if (!head.empty() && head.front() == "(index)")
            head.erase(head.begin());
        if (head.size() != kLabels.size()
            || !std::equal(head.begin(), head.end(), kLabels.begin(),
                           [](std::string_view word, char label) { return word == std::string_view(&label, 1); }))
            return;
        const std::size_t headEnd = i - 1;
        std::vector<std::size_t> labels;
        while (labels.size() < kLabels.size()) {
            if (i >= m_text.size())
                return;
            row = wordsOfLine(i);
            if (row.empty() && labels.empty())
                continue;
            if (row.size() != kLabels.size() + 1 || row.front() != kLabels.substr(labels.size(), 1))
                return;
            labels.push_back(std::size_t(row.front().data() - m_text.data()));
        }
        m_labels = labels;
        m_at = headEnd;
    }

    bool isNumberHere() const
    {
        const bool isMinus = isHere(kMinusSign), isSigned = isMinus || isAmong(m_text[m_at], "+-");
        const std::size_t i = m_at + (isMinus ? kMinusSign.size() : isSigned ? 1 : 0);
        const std::string_view word = m_text.substr(i, 3);
        return isDigit(at(i)) || (at(i) == '.' && isDigit(at(i + 1)))
               || (isSigned && (plain(word) == "inf" || plain(word) == "nan"));
    }

    /// Reads a word that begins like a number.
    void readNumber()
    {
        const std::size_t start = m_at;
        std::string word;
        for (;;) {
            const char c = at(m_at);
            const bool isMinus = isHere(kMinusSign), isPoint = c == ',' && m_hasDecimalCommas && isDigit(at(m_at + 1));
            if (!isMinus && !isPoint && !isAlnum(c) && !isAmong(c, ".+-#"))
                break;
            word += isMinus ? '-' : isPoint ? '.' : c;
            m_at += isMinus ? kMinusSign.size() : 1;
        }
        if (isInComment())
            return;
        for (const std::string_view power : {"*^", "\\cdot 10^{"}) { // Mathematica, LaTeX
            const std::size_t i = behind(m_at, isBlank);
            if (!m_text.substr(i).starts_with(power))
                continue;
            m_at = behind(i + power.size(), [](char c) { return isDigit(c) || c == '-'; });
            word += 'e' + std::string(m_text.substr(i + power.size(), m_at - i - power.size()));
        }
        const std::optional<double> value = numberOf(word);
        const bool isIndex = word.size() <= 2 && word.find_first_not_of(kDigits) == word.npos;
        const std::size_t star = behind(m_at, isBlank), cross = word.find('x');
        if (value && isIndex && at(m_at) == ':') {
            m_subscripts = {int(*value)}; // 3: 0.5
        } else if (value && at(star) == '*' && isAmong(at(behind(star + 1, isBlank)), std::string_view("\n[\0", 3))) {
            m_factor = *value;
            m_at = star + 1;
        } else if (value || isMeantAsNumber(word)) {
            addNumber(value.value_or(kNan), start);
        } else if (const auto width = numberOf(word.substr(0, cross)),
                   height = numberOf(word.substr(std::min(cross + 1, word.size())));
                   width && height) {
            addNumber(*width, start, NumberKind::Side);
            addNumber(*height, start, NumberKind::Side);
        } else if (const std::size_t unit = word.find_last_of("0123456789.") + 1;
                   word.size() - unit <= 3 && numberOf(word.substr(0, unit))) {
            addNumber(*numberOf(word.substr(0, unit)), start, NumberKind::Unit);
        } else {
            addWord(start, m_at);
        }
    }

    void addNumber(double value, std::size_t start, NumberKind kind = NumberKind::Plain)
    {
        endName(GroupKind::Name);
        m_groups.back().numbers.push_back({m_factor * (m_areDegrees ? geometry::radiansFromDegrees(value) : value),
                                           kind, m_isBehindSemicolon, start, m_at - start, m_line,
                                           m_open.empty() ? 0 : m_open.back(), std::move(m_subscripts)});
        m_subscripts.clear();
        m_hasNumbers = true;
        m_areDegrees = m_isBehindSemicolon = m_isBehindEquals = false;
        m_operandLine = m_line;
    }

    void readWord()
    {
        const std::size_t start = m_at;
        while (isAlnum(at(m_at)) || at(m_at) == '.' || isHere("->") || isHere("::")
               || (at(m_at) == '-' && isAlnum(at(m_at + 1))))
            m_at += std::size_t(1) + (isHere("->") || isHere("::"));
        const std::size_t end = m_text.find_last_not_of('.', m_at - 1) + 1;
        const std::string word = plain(lastPart(m_text.substr(start, end - start)));
        if (isInComment())
            return addWord(start, end);
        const bool isInfinite = word == "inf" || word == "infinity";
        if (isInfinite || word == "nan")
            return addNumber(isInfinite ? std::numeric_limits<double>::infinity() : kNan, start);
        if ((word == "pi" && readPi(start)) || readFilled(word, start))
            return;
        if (word == "x" && m_name.empty() && m_operandLine == m_line && isDigit(at(behind(m_at, isBlank))))
            return; // 800 x 600
        const std::string_view last = m_name.substr(m_name.find_last_of(" \t") + 1);
        const std::string type = plain(lastPart(last));
        addWord(start, end);
        readSubscripts(word);
        if (at(m_at) != '(')
            return;
        if (type.starts_with("mat") || type.starts_with("vec") || type.starts_with("point3")) // Vec3d t(0, 0, 5)
            return endName(GroupKind::Name);
        endName(GroupKind::Type);
        if ((word == "inv" || word == "inverse" || word == "transpose") && (!m_hasNumbers || m_operandLine == m_line))
            setArithmetic(word);
        m_areDegrees = word == "radians" || word == "deg2rad" || word == "degtorad";
    }

    /// Reads the value of "np.pi / 3". Returns whether it is one.
    bool readPi(std::size_t start)
    {
        constexpr std::size_t kMost = 80;
        std::string_view text = m_text.substr(start, kMost);
        text = text.substr(0, text.find_first_of(",;)\n"));
        const auto value = base::evaluate(text, [](std::string_view name) {
            return lastPart(name) == "pi" ? std::optional(geometry::kPi) : std::nullopt;
        });
        if (!value)
            return false;
        m_at = start + text.size();
        addNumber(*value, start);
        return true;
    }

    /// Reads the numbers of NumPy's eye(3) and zeros((3, 1)). Returns whether it is one.
    bool readFilled(const std::string &word, std::size_t start)
    {
        const bool isIdentity = word == "eye" || word == "identity";
        const std::size_t length = isIdentity || word == "zeros" ? lengthOf({"(~)"}) + lengthOf({"((~,_~))"}) : 0;
        std::size_t count = length > 0 ? 1 : 0, side = 0;
        for (const char c : m_text.substr(m_at, length)) {
            side = isDigit(c) ? std::size_t(c - '0') : side;
            count *= isDigit(c) ? side : 1;
        }
        m_at += length;
        for (std::size_t i = 0; i < (isIdentity ? side * side : count); ++i)
            addNumber(isIdentity && i % (side + 1) == 0 ? 1.0 : 0.0, start);
        return length > 0;
    }

    /// Reads the one or two integers of m[3], m[1][2], m(0, 1) and m01, and skips other subscripts,
    /// data['xpos'].
    void readSubscripts(const std::string &word)
    {
        m_subscripts.clear();
        if (const std::size_t n = word.size(); n >= 3 && isDigit(word[n - 1]) && isDigit(word[n - 2])
                                               && (word[n - 3] == 'm' || (word[n - 3] == 'e' && n == 3))) // e00: Unity
            m_subscripts = {word[n - 2] - '0', word[n - 1] - '0'};
        bool isSecond = false;
        for (;; isSecond = true) {
            std::size_t length = 0;
            for (const char *pattern : {"[_#_]", "[_#_,_#_]", "(_#_,_#_)"})
                length = std::max(length, lengthOf({pattern}));
            if (length == 0)
                break;
            std::vector<int> found;
            for (std::size_t i = m_at; i < m_at + length; i = behind(i + 1, isDigit)) {
                if (isDigit(at(i + 1)))
                    found.push_back(
                        base::numberIn<int>(m_text.substr(i + 1, behind(i + 1, isDigit) - i - 1)).value_or(0));
            }
            if (isSecond && found.size() == 1 && m_subscripts.size() == 1) // as GLM counts: the position in memory
                found = {4 * m_subscripts[0] + found[0]};
            m_subscripts = found;
            m_at += length;
        }
        const std::size_t close = at(m_at) == '[' ? m_text.find_first_of("],. \n", m_at) : m_text.npos;
        if (at(close) == ']')
            m_at = close + 1;
    }

    void readSign(char c)
    {
        if (!isInComment() && readArithmetic(c))
            return;
        ++m_at;
        if (isAmong(c, ",;)]}"))
            endName(GroupKind::Word);
        else if (isAmong(c, "([{<:") || (c == '=' && at(m_at) != '='))
            endName(GroupKind::Name);
        if (isInComment())
            return;
        m_isBehindEquals = isAmong(c, "=:");
        m_isBehindSemicolon = m_isBehindSemicolon || c == ';';
        if (isAmong(c, "([{")) {
            m_open.push_back(++m_brackets);
            m_subscripts.clear();
        } else if (isAmong(c, ")]}")) {
            if (!m_open.empty())
                m_open.pop_back();
            m_operandLine = c == '}' ? m_operandLine : m_line;
        } else if (c == '#') { // #1
            m_at = behind(m_at, isDigit);
        } else if (c == '-' || (isAmong(c, kMinusSign) && m_text.substr(m_at - 1).starts_with(kMinusSign))) {
            // Skipping a sign would negate the number. A bullet or dash is no sign.
            const std::size_t last = m_at > 1 ? m_text.find_last_not_of(" \t", m_at - 2) : m_text.npos;
            m_at += c == '-' ? 0 : kMinusSign.size() - 1;
            const bool isApart = !isAlnum(at(m_at)) && !isAmong(at(m_at), ".+-#") && last != m_text.npos;
            if (isApart && (isDigit(m_text[last]) || isAmong(m_text[last], "[({,;.")))
                addNumber(kNan, m_at - (c == '-' ? 1 : kMinusSign.size()), NumberKind::Sign);
        }
    }

    /// Notes an operator that changes the numbers of a value. Returns whether there is one.
    bool readArithmetic(char c)
    {
        if (!isAmong(c, "*/@+-'."))
            return false;
        constexpr std::size_t kMost = 40;
        std::string_view rest = m_text.substr(m_at + 1, kMost);
        rest = base::trimmed(rest.substr(0, rest.find_first_of("\r\n;#")));
        const bool isBehindOperand = m_hasNumbers && m_operandLine == m_line && m_name.empty(),
                   isProduct = isAmong(c, "*/@");
        const bool isSum =
            isAmong(c, "+-") && at(m_at + 1) == ' ' && !rest.empty() && (isDigit(rest.front()) || rest.front() == '[');
        const bool isTransposed = isAmong(before(), "])") && (c == '\'' || isHere(".T"));
        // "scale * np.array(…)", "-np.array(…)"
        const bool isFirst =
            !m_hasNumbers && m_isBehindEquals && (m_name.empty() ? c == '-' && isLetter(at(m_at + 1)) : isProduct);
        if (isFirst)
            setArithmetic(m_name.empty() ? "-" : std::string(m_name) + ' ' + c);
        else if (isBehindOperand && isTransposed)
            setArithmetic(".T");
        else if (isBehindOperand && (isProduct || isSum))
            setArithmetic(c + (' ' + std::string(rest)));
        if (!isFirst && !(isBehindOperand && (isTransposed || isProduct)))
            return false;
        m_at += std::size_t(1) + (c == '.');
        return true;
    }

    void setArithmetic(std::string text)
    {
        std::string &arithmetic = m_groups[m_value].arithmetic;
        if (arithmetic.empty())
            arithmetic = std::move(text);
    }

    void addWord(std::size_t begin, std::size_t end)
    {
        if (m_name.empty()) {
            begin_ = begin;
            m_isNameFirst = m_isLineBlank;
        }
        m_name = m_text.substr(begin_, end - begin_);
    }

    /// Ends the adjacent words here, if there are any.
    void endName(GroupKind kind)
    {
        if (!m_name.empty())
            add(isInComment() ? GroupKind::Comment : kind, m_name);
        m_name = {};
    }

    void add(GroupKind kind, std::string_view name)
    {
        m_groups.push_back({name, kind, false, m_line});
        if (kind != GroupKind::Name)
            return;
        m_value = m_groups.size() - 1;
        m_factor = 1.0;
        m_hasNumbers = false;
    }

    std::string_view m_text;
    bool m_isXml, m_hasDecimalCommas;
    std::size_t m_at = 0, m_line = 1;
    std::size_t m_commentEnd = 0, m_quoteEnd = 0; ///< of the comment, and of the quoted numbers, that are read
    std::vector<std::size_t> m_labels;            ///< of a table's rows: their places
    std::vector<std::size_t> m_open;              ///< the enclosing brackets
    std::size_t m_brackets = 0;
    std::string_view m_name; ///< the adjacent words that ended here last, if nothing followed them yet
    std::size_t begin_ = 0;
    bool m_isNameFirst = false, m_isLineBlank = true;
    bool m_areDegrees = false, m_isBehindSemicolon = false; ///< of the next number
    std::vector<int> m_subscripts;                          ///< of the next number
    double m_factor = 1.0;                                  ///< of the numbers up to the next name
    std::size_t m_operandLine = 0;                          ///< the line of the last number or closing bracket
    bool m_isBehindEquals = false; ///< only words stand between the last equals sign or colon and here
    std::size_t m_value = 0;       ///< the last group of the kind Name
    bool m_hasNumbers = false;     ///< behind that name
    std::vector<Group> m_groups;
};

} // namespace

std::vector<Group> scan(std::string_view text)
{
    return Scanner(text).scan();
}

std::string plain(std::string_view name)
{
    std::string result;
    for (const char c : base::lowerCase(name)) {
        if (isAlnum(c) && c != '_')
            result += c;
    }
    return result;
}

std::string_view lastPart(std::string_view path)
{
    return path.substr(path.find_last_of(".>:") + 1);
}

} // namespace unprojector::cameras
