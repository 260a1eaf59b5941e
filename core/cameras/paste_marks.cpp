#include "core/cameras/paste_marks.h"

#include "core/cameras/call_syntax.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace unprojector::cameras {
using syntax::isDigit;
using syntax::isLetter;

namespace {

class Text {
public:
    explicit Text(std::string_view text) : m_text(text) {}

    std::string cleaned()
    {
        blankTimes();
        blankSizes();
        blankLabels();
        blankDebugger();
        blankAddresses();
        blankColumnLabels();
        setPoints();
        setExponents();
        return std::move(m_text);
    }

private:
    char at(std::size_t i) const { return i < m_text.size() ? m_text[i] : '\0'; }
    std::size_t behindDigits(std::size_t i) const
    {
        while (isDigit(at(i)))
            ++i;
        return i;
    }
    std::size_t behindBlanks(std::size_t i) const
    {
        while (at(i) == ' ' || at(i) == '\t')
            ++i;
        return i;
    }
    bool has(std::string_view part) const { return m_text.find(part) != m_text.npos; }
    bool isAt(std::size_t i, std::string_view part) const
    {
        return std::string_view(m_text).substr(i).starts_with(part);
    }
    void blank(std::size_t begin, std::size_t end)
    {
        std::fill(m_text.begin() + std::ptrdiff_t(begin), m_text.begin() + std::ptrdiff_t(end), ' ');
    }

    /// [2024-05-01 12:00:00.123]
    void blankTimes()
    {
        for (std::size_t i = m_text.find('-'); i != m_text.npos; i = m_text.find('-', i + 1)) {
            const bool isDate = i >= 4 && behindDigits(i - 4) == i && behindDigits(i + 1) == i + 3 && at(i + 3) == '-'
                                && behindDigits(i + 4) == i + 6;
            if (!isDate)
                continue;
            std::size_t end = i + 6;
            if (at(end) == 'T' || at(end) == ' ')
                ++end;
            while (isDigit(at(end)) || at(end) == ':' || at(end) == '.' || at(end) == ',' || at(end) == 'Z')
                ++end;
            blank(i - 4, end);
        }
        // 12:00:00.123, and main.cpp:123:
        for (std::size_t i = m_text.find(':'); i != m_text.npos; i = m_text.find(':', i + 1)) {
            const bool isHour = i >= 2 && behindDigits(i - 2) == i && behindDigits(i + 1) == i + 3 && at(i + 3) == ':'
                                && behindDigits(i + 4) == i + 6;
            const std::size_t lineEnd = behindDigits(i + 1);
            if (isHour) {
                const bool hasFraction = at(i + 6) == '.' || at(i + 6) == ',';
                blank(i - 2, hasFraction ? behindDigits(i + 7) : i + 6);
            } else if (i > 0 && isLetter(m_text[i - 1]) && lineEnd > i + 1 && at(lineEnd) == ':') {
                blank(i, lineEnd);
            }
        }
    }

    /// Array(16), ArrayBuffer(64), (16) [ and 4×4 Matrix{Float64}.
    void blankSizes()
    {
        for (std::size_t i = m_text.find('('); i != m_text.npos; i = m_text.find('(', i + 1)) {
            const std::size_t end = behindDigits(i + 1);
            if (end == i + 1 || at(end) != ')')
                continue;
            const std::string_view before = std::string_view(m_text).substr(0, i);
            const bool isOfName = before.ends_with("Array") || before.ends_with("Buffer");
            const bool isInFront = (before.empty() || !isLetter(before.back())) && at(behindBlanks(end + 1)) == '[';
            if (isOfName || isInFront)
                blank(i, end + 1);
        }
        constexpr std::string_view kCross = "\xc3\x97";
        for (std::size_t i = m_text.find(kCross); i != m_text.npos; i = m_text.find(kCross, i + 1)) {
            std::size_t begin = i;
            while (begin > 0 && isDigit(m_text[begin - 1]))
                --begin;
            const std::size_t end = behindDigits(i + kCross.size()), word = behindBlanks(end);
            std::size_t wordEnd = word;
            while (isLetter(at(wordEnd)))
                ++wordEnd;
            const std::string_view type = std::string_view(m_text).substr(word, wordEnd - word);
            const bool isType = type.ends_with("Matrix") || type.ends_with("Array") || type.ends_with("matrix");
            const bool isSmall = i == begin + 1 && end == i + kCross.size() + 1 && at(begin) <= '4';
            if (isType || isSmall)
                blank(begin, end);
            else
                blank(i, i + kCross.size()); // 800×600
        }
        for (std::size_t i = m_text.find(" x "); i != m_text.npos; i = m_text.find(" x ", i + 1)) {
            const bool isAlone = i > 0 && (i < 2 || !(isDigit(m_text[i - 2]) || m_text[i - 2] == '.'));
            const auto isSide = [this](std::size_t k) { return at(k) == '3' || at(k) == '4'; };
            if (isAlone && isSide(i - 1) && isSide(i + 3) && !isDigit(at(i + 4)) && at(i + 4) != '.') // 4 x 4
                blank(i - 1, i + 4);
        }
        const std::size_t columns = m_text.find("Columns 1 through 4");
        if (columns != m_text.npos)
            blank(columns, columns + std::string_view("Columns 1 through 4").size());
    }

    /// Returns whether the brackets with one number, or two, are a size or an index: Go's
    /// [16]float32, lldb's (float [16]) and [0] = 1, PHP's [0] =>, ublas' [4,4](, IPython's
    /// In [1]:.
    bool isSizeOrIndex(std::size_t begin, std::size_t end, bool isPair) const
    {
        const std::string_view before = std::string_view(m_text).substr(0, begin),
                               rest = std::string_view(m_text).substr(std::min(end, m_text.size()));
        const bool isApart = before.empty() || std::string_view(" \t\n({,").find(before.back()) != before.npos;
        if (isPair)
            return isApart && rest.starts_with('(');
        const bool isOfType = !rest.empty() && isLetter(rest.front());
        return (isApart && (isOfType || rest.starts_with(')') || rest.starts_with(" = ") || rest.starts_with(" => ")))
               || (before.ends_with("In ") && rest.starts_with(':'));
    }

    /// R's [1,] and [,1], sizes and indices of other languages, and Rust's [f32; 16].
    void blankLabels()
    {
        for (std::size_t i = m_text.find('['); i != m_text.npos; i = m_text.find('[', i + 1)) {
            const bool isColumn = at(i + 1) == ',';
            const std::size_t begin = i + (isColumn ? 2 : 1), end = behindDigits(begin);
            if (isAt(i, "[f32; ") || isAt(i, "[f64; ")) {
                const std::size_t close = behindDigits(i + 6);
                blank(i, close + (at(close) == ']' ? 1 : 0));
            }
            if (end == begin)
                continue;
            const std::size_t second = at(end) == ',' ? behindDigits(behindBlanks(end + 1)) : end;
            if (!isColumn && at(second) == ']' && isSizeOrIndex(i, second + 1, second > end))
                blank(i, second + 1);
            else if (isColumn && at(end) == ']')
                blank(i, end + 1);
            else if (!isColumn && at(end) == ',' && at(end + 1) == ']')
                blank(i, end + 2);
        }
    }

    /// gdb's and lldb's {x = 1, r = 1, s = 1}, $1 = and [0] = {.
    void blankDebugger()
    {
        const bool hasTriples = has("x = ") && has("r = ") && has("s = ");
        for (std::size_t i = 0; i < m_text.size(); ++i) {
            const std::size_t letter = i + 2, digits = i + 1;
            const bool isSecond = hasTriples && at(i) == ',' && at(i + 1) == ' '
                                  && std::string_view("rgbastpq").find(at(letter)) != std::string_view::npos
                                  && isAt(letter + 1, " = ");
            if (isSecond) {
                const std::size_t end = m_text.find_first_of(",})\n", letter);
                blank(i + 1, std::min(end, m_text.size()));
            } else if (at(i) == '$' && behindDigits(digits) > digits && isAt(behindDigits(digits), " =")) {
                blank(i, behindDigits(digits) + 2);
            }
        }
    }

    /// vtkMatrix4x4 (0x55d1c0a3b2f0) and m = 0x000000d1.
    void blankAddresses()
    {
        constexpr std::size_t kFewest = 6; // a shorter one may be a number
        for (std::size_t i = m_text.find("0x"); i != m_text.npos; i = m_text.find("0x", i + 1)) {
            std::size_t end = i + 2;
            while (std::isxdigit(static_cast<unsigned char>(at(end))) != 0)
                ++end;
            const char before = i > 0 ? m_text[i - 1] : '\0';
            if (end - i >= kFewest + 2 && (before == '(' || before == '@' || before == ' ') && !isLetter(at(end)))
                blank(i, end);
        }
    }

    struct Line {
        std::size_t begin, end;
        std::vector<std::size_t> words; ///< where each begins
    };

    /// Blanks, and the lines of a table, in ASCII or UTF-8.
    bool isBetweenWords(std::size_t i) const
    {
        return std::isspace(static_cast<unsigned char>(m_text[i])) != 0 || m_text[i] == '|'
               || static_cast<unsigned char>(m_text[i]) >= 0x80;
    }

    Line lineFrom(std::size_t begin) const
    {
        Line line{begin, std::min(m_text.find('\n', begin), m_text.size()), {}};
        for (std::size_t i = begin; i < line.end; ++i) {
            if (!isBetweenWords(i) && (i == begin || isBetweenWords(i - 1)))
                line.words.push_back(i);
        }
        return line;
    }

    /// Returns whether a word of a line is this index.
    bool isIndex(std::size_t word, std::size_t index) const
    {
        return at(word) == static_cast<char>('0' + index) && (word + 1 >= m_text.size() || isBetweenWords(word + 1));
    }

    /// Labels of pandas and of console.table: a line 0 1 2 3 above four lines that begin with 0 to
    /// 3 and have four numbers.
    void blankColumnLabels()
    {
        for (std::size_t at = 0; at < m_text.size();) {
            Line head = lineFrom(at);
            at = head.end + 1;
            if (!head.words.empty() && isAt(head.words.front(), "(index)"))
                head.words.erase(head.words.begin());
            bool isTable = head.words.size() == 4;
            for (std::size_t i = 0; isTable && i < 4; ++i)
                isTable = isIndex(head.words[i], i);
            std::vector<Line> rows;
            for (std::size_t i = 0; isTable && i < 4; ++i) {
                std::size_t next = std::min(rows.empty() ? at : rows.back().end + 1, m_text.size());
                if (rows.empty() && lineFrom(next).words.empty()) // the line of a table
                    next = std::min(lineFrom(next).end + 1, m_text.size());
                rows.push_back(lineFrom(next));
                isTable = rows.back().words.size() == 5 && isIndex(rows.back().words[0], i);
            }
            if (!isTable)
                continue;
            blank(head.begin, head.end);
            for (const Line &row : rows)
                blank(row.words[0], row.words[0] + 1);
        }
    }

    /// Decimal commas become points where every comma stands between two digits, no number has a
    /// point, and no number has two commas.
    void setPoints()
    {
        std::vector<std::size_t> commas;
        std::size_t lastComma = m_text.npos;
        for (std::size_t i = 0; i < m_text.size(); ++i) {
            const bool isBetweenDigits = i > 0 && isDigit(m_text[i - 1]) && isDigit(at(i + 1));
            if (m_text[i] == '.' && isBetweenDigits)
                return;
            if (m_text[i] != ',')
                continue;
            const bool isSeparator =
                i + 1 >= m_text.size() || std::isspace(static_cast<unsigned char>(m_text[i + 1])) != 0;
            if (isSeparator)
                continue;
            const bool isSecond = lastComma != m_text.npos && behindDigits(lastComma + 1) == i;
            if (!isBetweenDigits || isSecond)
                return;
            lastComma = i;
            commas.push_back(i);
        }
        constexpr std::size_t kFewest = 6; // fractions in a matrix
        if (commas.size() < kFewest)
            return;
        for (const std::size_t i : commas)
            m_text[i] = '.';
    }

    /// 1.5D-01 and Mathematica's 1.5*^-1.
    void setExponents()
    {
        for (std::size_t i = 1; i + 1 < m_text.size(); ++i) {
            const bool isBehindNumber =
                isDigit(m_text[i - 1]) || (m_text[i - 1] == '.' && i > 1 && isDigit(m_text[i - 2]));
            if (!isBehindNumber)
                continue;
            const bool isSigned = at(i + 1) == '-' || at(i + 1) == '+';
            if ((m_text[i] == 'D' || m_text[i] == 'd') && isSigned && isDigit(at(i + 2)))
                m_text[i] = 'e';
            else if (isAt(i, "*^-") && isDigit(at(i + 3)))
                m_text.replace(i, 3, "e-0");
            else if (isAt(i, "*^") && isDigit(at(i + 2)))
                m_text.replace(i, 2, "e0");
        }
    }

    std::string m_text;
};

} // namespace

std::string withoutPrintersMarks(std::string_view text)
{
    return Text(text).cleaned();
}

} // namespace unprojector::cameras
