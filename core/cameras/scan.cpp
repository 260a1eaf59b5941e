#include "core/cameras/scan.h"

#include "core/base/error.h"
#include "core/base/expression.h"
#include "core/base/letters.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/geometry/numbers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace unprojector::cameras {
using base::isDigit;
using base::isLetter;

namespace {

using enum GroupKind;

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
constexpr std::string_view kOfNumber = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_.+-#";
constexpr std::string_view kOfName = kOfNumber.substr(0, kOfNumber.size() - 3);

constexpr std::size_t kAny = std::string_view::npos;
/// What a letter of a pattern stands for: these characters, or all others, and how many of them.
struct Code {
    std::string_view characters;
    std::size_t fewest = 1, most = kAny;
    bool areOthers = false;
};
constexpr std::string_view kBetweenCells = " \t\r\n|─│┌┬┐├┼┤└┴┘", kCodeNames = "9~%@&H+T_LX!|W";
constexpr Code kCodes[]{
    {kDigits},                               // 9
    {kDigits, 1, 1},                         // ~
    {"1234", 1, 1},                          // %: a side of a matrix
    {kLetters, 1, 1},                        // @
    {kOfName.substr(0, kOfName.size() - 1)}, // &
    {"0123456789abcdefABCDEF", 6},           // H: an address
    {"+-.0123456789"},                       // +
    {"0123456789:.TZ", 0},                   // T: the rest of a time
    {" \t\r", 0},                            // _
    {"\n", 0, kAny, true},                   // L: the rest of a line
    {"[],. \n", 1, kAny, true},              // X: a subscript
    {",})\n", 0, kAny, true},                // !: the value of a component
    {kBetweenCells},                         // |
    {kBetweenCells, 1, kAny, true},          // W: a cell of a table
};
/// The place of each character in kCodeNames; of others, their count.
constexpr auto kCodeOf = [] {
    std::array<std::uint8_t, 256> places{};
    places.fill(std::uint8_t(kCodeNames.size()));
    for (std::size_t i = 0; i < kCodeNames.size(); ++i)
        places[std::uint8_t(kCodeNames[i])] = std::uint8_t(i);
    return places;
}();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kApart = " \t\n({,[=:;@"; ///< characters before a Q

/// What printing adds to numbers. A Q stands behind blanks or brackets, a ? is the end of a word,
/// what follows a ` is no part of the mark, and a ' is the place of a label.
constexpr std::string_view kMarks[]{
    "~~~~-~~-~~T",
    "~~:~~:~~,9",
    "~~:~~:~~T",
    "Q(9)_`[",
    "%\xc3\x97%", // 4×4
    "% x %?",
    "%x%?",
    "Matrix 4x4",
    "Columns 9 through 9",
    "Matrix{&}:", // Julia
    "9-element Vector{&}:",
    "Array(9)",
    "Float32Array(9)",
    "Float64Array(9)",
    "ArrayBuffer(9)",
    "Mat&<&>(9,_9)_<<", // OpenCV
    "cv::Mat&<&>(9,_9)_<<",
    "[,9]", // R
    "[9,]",
    "Q[9,_9]`(", // ublas
    "Q[9]`@",    // Go
    "Q[9]`)",    // lldb
    "Q[9]` =",   // PHP
    "Q[9]`:",    // IPython
    "[f32; 9]",  // Rust
    "[f64; 9]",
    ", r = !, s = !", // GLM in a debugger
    ", g = !, t = !",
    ", b = !, p = !",
    ", a = !, q = !",
    "$9 =",
    "Q0xH?",
    "Q0|1|2|3`|'0|W|W|W|W|'1|W|W|W|W|'2|W|W|W|W|'3|W|W|W|W",        // pandas
    "(index)|0|1|2|3`|'0|W|W|W|W|'1|W|W|W|W|'2|W|W|W|W|'3|W|W|W|W", // console.table
};

/// Signs in numbers, and the same as C++ writes them: of typeset text, Mathematica and Fortran.
constexpr std::string_view kSigns[][2]{{"\xe2\x88\x92", "  -"},
                                       {"\xe2\x80\x90", "  -"},
                                       {"\xe2\x80\x91", "  -"},
                                       {"\xe2\x80\x93", "  -"},
                                       {"\xe2\x80\x92", "  -"},
                                       {"\xe2\x80\x94", "  -"},
                                       {"\xef\xb9\xa3", "  -"},
                                       {"\xef\xbc\x8d", "  -"},
                                       {"*^-", "e-0"},
                                       {"*^", "e0"},
                                       {"D-", "e-"},
                                       {"D+", "e+"},
                                       {"d-", "e-"},
                                       {"d+", "e+"},
                                       {",", "."}};

bool isAmong(char c, std::string_view some)
{
    return some.find(c) != some.npos;
}

/// Returns whether every comma that no blank follows stands between two digits, no number has a
/// point or two commas, and there are as many as fractions in a matrix.
bool hasDecimalCommas(std::string_view text)
{
    constexpr std::size_t kFewest = 6;
    std::size_t count = 0, last = text.size();
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        const bool isBetween = isDigit(text[i - 1]) && isDigit(text[i + 1]);
        if (text[i] == '.' && isBetween)
            return false;
        if (text[i] != ',' || isAmong(text[i + 1], " \t\r\n"))
            continue;
        if (!isBetween || text.find_first_not_of(kDigits, last + 1) == i)
            return false;
        last = i;
        ++count;
    }
    return count >= kFewest;
}

/// A text of the same length with numbers as C++ writes them.
std::string withPlainNumbers(std::string_view given)
{
    std::string text = withoutRemarks(given);
    constexpr std::string_view kBlanks[]{"\xc2\xa0", "\xe2\x80\x8b",
                                         std::string_view("\0", 1)}; // no-break, of no width, none
    for (const std::string_view blank : kBlanks) {
        for (auto i = text.find(blank); i != text.npos; i = text.find(blank, i + 1))
            text.replace(i, blank.size(), blank.size(), ' ');
    }
    const bool hasCommas = hasDecimalCommas(text);
    for (const auto &[sign, plainSign] : kSigns) {
        for (auto i = text.find(sign); i != text.npos; i = text.find(sign, i + 1)) {
            const bool isInNumber = i > 0 && isAmong(text[i - 1], "0123456789.")
                                    && (sign != "," || (hasCommas && isDigit(given[i + 1 < text.size() ? i + 1 : i])));
            const std::size_t next = i + sign.size();
            const bool isSign = plainSign.starts_with(' ')
                                && (sign == kSigns[0][0] || (next < text.size() && isAmong(text[next], "0123456789.")));
            if (isInNumber || isSign)
                text.replace(i, sign.size(), plainSign);
        }
    }
    return text;
}

/// Parses a number, with or without the f of a C float.
std::optional<double> numberOf(std::string_view word)
{
    const std::string_view suffixes = word.find('.') != word.npos ? "fFdDlL" : "fFuUlL"; // of C, Java and C#
    while (word.size() > 1 && isAmong(word.back(), suffixes) && word.find_first_of(kDigits) != word.npos)
        word.remove_suffix(1);
    return base::numberIn<double>(word.substr(word.size() > 1 && word.front() == '+'));
}

/// Returns whether a word is a decimal number but for a letter: "0.1q32", "0.b452".
bool hasWrongLetter(std::string_view word)
{
    word.remove_prefix(std::size_t(isAmong(word.front(), "+-")));
    const std::size_t point = word.find('.');
    return point != word.npos && point > 0 && word.find_first_not_of(kDigits) == point
           && word.find_first_of(kDigits, point) != word.npos;
}

/// Returns whether a word stands for a number that cannot be read: the output of other languages
/// and broken programs, or an overflow, as in 1.#QNAN, 0x10, 1d0, 1e400. If it were skipped,
/// another number would take its position.
bool isMeantAsNumber(std::string_view word)
{
    word.remove_prefix(std::size_t(isAmong(word.front(), "+-")));
    return isAmong('#', word) || word.starts_with("0x") || word.starts_with("0X")
           || word.find_first_not_of("0123456789.eEdD+-") == word.npos;
}

/// Units of lengths, angles and pixels.
constexpr std::string_view kUnits = " mm cm m km inch inches ft um deg degree degrees rad radian radians ",
                           kPixels = " px pixel pixels ";
/// Functions that change numbers.
constexpr std::string_view kFunctions = " sqrt tan atan exp log log2 log10 sin cos asin acos atan2 arctan arctan2 pow "
                                        "hypot cbrt abs round floor ceil min max square power degrees rad2deg ";

/// Functions of one number that give the number.
constexpr std::string_view kCasts = " double int decimal tensor array number scalar real value f32 f64 some ok just "
                                    "radians deg2rad degtorad mm m px ";

constexpr std::size_t kMostGroups = 500000; ///< of a text: they take 100 MB

class Scanner {
public:
    explicit Scanner(std::string_view text) : m_given(text), m_plain(withPlainNumbers(text)) {}

    std::vector<Group> scan()
    {
        const auto begin = m_text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
        m_isXml = at(begin) == '<' && m_text.find("</") != m_text.npos;
        m_groups.emplace_back();
        while (m_at < m_text.size())
            readOne();
        endName(Word);
        shareAll();
        return std::move(m_groups);
    }

private:
    /// Gives each of several names its number: "fx, fy = 600, 610".
    void shareAll()
    {
        for (std::size_t last = 1; last < m_groups.size(); ++last) {
            constexpr std::size_t kMost = 16; // names before one sign
            const std::size_t count = m_groups[last].numbers.size(), first = last + 1 - count;
            if (m_groups[last].kind == Other || count < 2 || count > std::min(last, kMost)
                || !m_groups[last].arithmetic.empty())
                continue;
            const std::vector<ScannedNumber> numbers = m_groups[last].numbers;
            const auto begin = std::size_t(m_groups[first].name.data() - m_given.data());
            const auto names = m_text.substr(begin, numbers.front().at - begin),
                       values = m_text.substr(numbers.front().at, numbers.back().at - numbers.front().at);
            const auto commas = std::ptrdiff_t(count) - 1;
            const auto line = names.find_last_not_of(" \t");
            const bool isHeader = line != names.npos && names[line] == '\n' && std::ranges::count(names, '\n') == 1;
            const auto previous = begin > 0 ? m_text.find_last_not_of(" \t([", begin - 1) : m_text.npos;
            const auto words = m_text.substr(0, previous + 1);
            const bool isDeclared = words.ends_with("const") || words.ends_with("let") || words.ends_with("auto");
            if (std::ranges::count(names, ',') != commas || std::ranges::count(values, ',') != commas
                || (isHeader ? isAmong('=', names) : !isAmong('=', names) || isAmong('\n', names))
                || (previous != m_text.npos && !isAmong(at(previous), "\n;") && !isDeclared)
                || std::any_of(m_groups.begin() + std::ptrdiff_t(first), m_groups.begin() + std::ptrdiff_t(last),
                               [](const Group &one) { return !one.numbers.empty(); })
                || std::ranges::any_of(
                    names, [](char one) { return !isAmong(one, kOfName) && !isAmong(one, " \t\r\n,()[]:="); }))
                continue;
            for (std::size_t i = 0; i < count; ++i) {
                m_groups[first + i].kind = Name;
                m_groups[first + i].numbers = {numbers[i]};
            }
        }
    }

    char at(std::size_t i) const { return i < m_text.size() ? m_text[i] : '\0'; }
    char before() const { return before(m_at); }
    char before(std::size_t i) const { return i > 0 ? m_text[i - 1] : '\n'; }
    bool isHere(std::string_view part) const { return m_text.substr(m_at).starts_with(part); }
    std::size_t behind(std::size_t i, std::string_view characters) const
    {
        return std::min(m_text.find_first_not_of(characters, i), m_text.size());
    }

    /// The length of a pattern's text here, or 0.
    std::size_t lengthOf(std::string_view pattern)
    {
        std::size_t end = m_at, length = 0;
        m_found.clear();
        for (const char one : pattern) {
            if (const std::size_t code = kCodeOf[std::uint8_t(one)]; code < kCodeNames.size()) {
                const auto &[characters, fewest, most, areOthers] = kCodes[code];
                const std::string_view rest = m_text.substr(std::min(end, m_text.size()), most);
                const auto stop = areOthers ? rest.find_first_of(characters) : rest.find_first_not_of(characters);
                const auto count = std::min(stop, rest.size());
                if (count < fewest)
                    return 0;
                end += count;
            } else if (one == '`') {
                length = end - m_at;
            } else if (one == '\'') {
                m_found.push_back(end);
            } else if (one == 'Q'   ? !isAmong(before(), kApart)
                       : one == '?' ? isAmong(at(end), kOfName)
                                    : at(end++) != one) {
                return 0;
            }
        }
        return length > 0 ? length : end - m_at;
    }

    /// The integer at a place that a pattern found; -1 if it is too large.
    int foundAt(std::size_t i) const
    {
        return base::numberIn<int>(m_text.substr(m_found[i], behind(m_found[i], kDigits) - m_found[i])).value_or(-1);
    }

    bool isNumberAt(std::size_t i) const
    {
        i += std::size_t(isAmong(at(i), "+-"));
        return isDigit(at(i + std::size_t(at(i) == '.')));
    }

    /// Returns whether "-inf", "+nan" or ".inf" is at a place.
    bool isSignedInfAt(std::size_t i) const
    {
        if (!isAmong(at(i), "+-."))
            return false;
        i += 1 + std::size_t(at(i) != '.' && at(i + 1) == '.');
        const auto word = m_text.substr(std::min(i, m_text.size()), 3);
        return word == "inf" || word == "nan";
    }

    void readOne()
    {
        const char c = m_text[m_at];
        if (m_at >= m_commentEnd && m_commentEnd > 0) {
            endName(Other);
            m_commentEnd = 0;
        }
        const bool isNumber = isNumberAt(m_at) || isSignedInfAt(m_at);
        if (m_commentEnd == 0 && isAmong(c, "+-") && isAmong(at(m_at + 1), "+-") && isNumberAt(m_at + 1)) { // -+0.1
            const std::size_t start = m_at;
            m_at = behind(m_at, kOfNumber);
            addNumber(kNan, start);
            return;
        }
        if (c == '\n') {
            endLine(m_at++);
            ++m_line;
            m_isLineBlank = true;
            m_isBehindEquals = m_isOperand = false;
            return;
        }
        if (isAmong(c, " \t\r") || std::erase(m_labels, m_at) > 0) {
            ++m_at;
            return;
        }
        for (const std::string_view prompt : {">>> ", "> ", "julia> ", "$"}) {
            if (m_isLineBlank && m_commentEnd == 0 && isHere(prompt) && (prompt != "$" || isLetter(at(m_at + 1)))) {
                m_at += prompt.size();
                return;
            }
        }
        if (m_commentEnd == 0 && (readUncertainty() || readMark() || readComment() || readQuoted()))
            return;
        if (isNumber)
            readNumber();
        else if (isLetter(c))
            readWord();
        else
            readSign(c);
        m_isLineBlank = false;
    }

    /// Reads an uncertainty: the number behind +/- is no value. Returns whether it is one.
    bool readUncertainty()
    {
        const std::size_t length = isHere("+/-") ? 3 : isHere("\xC2\xB1") ? 2 : 0;
        if (length == 0 || m_count == 0 || m_operandLine != m_line)
            return false;
        m_at += length;
        m_isOperand = true;
        return true;
    }

    bool readMark()
    {
        if (!isAmong(m_text[m_at], "0123456789([,$MCcAFV")) // the first characters of all
            return false;
        if (const auto length = m_isLineBlank && m_open.empty() ? lengthOf("[9]`_+") : 0; length > 0) { // R
            m_at += length;
            m_isLineBlank = false;
            return true;
        }
        for (const std::string_view mark : kMarks) {
            const char first = mark.front();
            const bool isOther =
                first != m_text[m_at] && first != 'Q' && kCodeOf[std::uint8_t(first)] == kCodeNames.size();
            const auto length = isOther ? 0 : lengthOf(mark);
            if (length == 0)
                continue;
            if (!m_found.empty())
                m_labels = m_found;
            if (isLetter(m_text[m_at]))
                add(Other, m_at, m_at + length);
            m_at += length;
            m_isLineBlank = false;
            return true;
        }
        return false;
    }

    /// Returns whether a blank and the end of a statement of MATLAB stand before this place in the line.
    bool isBehindStatement() const
    {
        const auto last = m_text.find_last_not_of(" \t", m_at - 1);
        return m_at > 0 && isAmong(before(), " \t") && last != m_text.npos && isAmong(m_text[last], ";])");
    }

    /// Begins a comment, or an XML tag: its name is read, the rest of it is a comment.
    bool readComment()
    {
        if (!isAmong(m_text[m_at], "</(#%")) // the first characters of all
            return false;
        const bool isTag = m_isXml && m_text[m_at] == '<',
                   isMathematica = isHere("(* ") && m_text.find("*)", m_at) != m_text.npos,
                   isBlock = (isHere("/*") && m_text.find("*/", m_at) != m_text.npos) || isMathematica;
        const bool isQuotient = m_count > 0 && m_operandLine == m_line
                                && isAmong(at(m_text.find_last_not_of(" \t", m_at - 1)), "0123456789.)]")
                                && lengthOf("//_9") > 0
                                && isAmong(at(behind(m_at + 2, "0123456789. \t\r")), ",;)\n"); // of Python: 640 // 2
        const bool isLine = (lengthOf("Q#") > 0 && !isDigit(at(m_at + 1))) || (lengthOf("Q//") > 0 && !isQuotient)
                            || (isHere("%") && (m_isLineBlank || isBehindStatement()));
        if (!isTag && !isBlock && !isLine)
            return false;
        const std::string_view last = isMathematica    ? "*)"
                                      : isBlock        ? "*/"
                                      : !isTag         ? "\n"
                                      : isHere("<!--") ? "-->"
                                                       : ">";
        const auto end = std::min(m_text.find(last, m_at), m_text.size());
        if (isLine)
            endLine(end);
        endName(Word);
        // `unproject matrices` names numbers so: "# K: pixels from eye"
        if ((isTag && lengthOf("<'&'") > 0) || (m_isLineBlank && m_open.empty() && lengthOf("# '&':`L\n+") > 0))
            add(Name, m_found[0], m_found[1]);
        m_commentEnd = end + (isLine ? 0 : last.size());
        ++m_at;
        return true;
    }

    /// Reads a quoted name or value. Returns whether the quote ends in its line.
    bool readQuoted()
    {
        const char c = m_text[m_at];
        if (m_at < m_quoteEnd || (c != '"' && (c != '\'' || isAmong(before(), kOfName) || isAmong(before(), "])"))))
            return false;
        const auto end = m_text.find_first_of(c == '"' ? "\"\n" : "'\n", m_at + 1);
        if (at(end) != c)
            return false;
        const auto quoted = m_text.substr(m_at + 1, end - m_at - 1);
        const auto next = behind(end + 1, " \t\r");
        const bool isKey = isAmong(at(next), ":=");
        const auto index = base::numberIn<int>(quoted);
        endName(isKey ? Word : Name);
        if (isKey && index)
            setSubscripts({*index}); // "3": 0.5
        else
            add(isKey ? Name : Word, m_at + 1, end);
        if (!isKey
            && (isAmong(at(m_at + 1), "0123456789-[(") || quoted.find("0 0") < end || quoted.find("0, 0") < end)) {
            m_quoteEnd = end + 1;
            ++m_at;
        } else {
            m_at = isKey ? next + 1 : end + 1;
        }
        m_isLineBlank = false;
        m_isBehindEquals = isKey;
        return true;
    }

    /// Ends a name with its line. If it is alone there, it may name the numbers below.
    void endLine(std::size_t end)
    {
        const char next = m_name.empty() || !m_isNameFirst ? '\n' : at(m_text.find_first_not_of(" \t\r\n", end));
        endName(isAmong(next, "0123456789-+.[(<") ? Name : Word);
    }

    /// Reads a word that begins like a number.
    void readNumber()
    {
        const std::size_t start = m_at;
        m_at = behind(start + 1, kOfNumber);
        std::string word(m_text.substr(start, m_at - start));
        if (const auto length = lengthOf("_\\cdot 10^{'+'}"); length > 0) { // LaTeX
            word += 'e' + m_plain.substr(m_found[0], m_found[1] - m_found[0]);
            m_at += length;
        }
        const auto unit = word.find_last_of("0123456789.") + 1;
        if (unit < word.size() && word.find('.') < unit
            && isAmong(at(behind(m_at, " \t")), "=:")) { // fx=504.5fy = 504.6
            word.resize(unit);
            m_at = start + unit;
        }
        const auto cross = std::min(word.find('x'), word.size() - 1);
        const auto value = numberOf(word), width = numberOf(word.substr(0, cross)),
                   height = numberOf(word.substr(cross + 1)), whole = numberOf(word.substr(0, unit));
        if (m_commentEnd > 0)
            return;
        if (value && word.size() <= 2 && isDigit(word.front()) && at(m_at) == ':')
            m_subscripts = {int(*value)}; // 3: 0.5
        else if (value && (lengthOf("_*_\n") > 0 || lengthOf("_*_[") > 0))
            m_factor = *value;
        else if (value || isMeantAsNumber(word))
            addNumber(value.value_or(kNan), start);
        else if (width && height) {
            addNumber(*width, start, true);
            addNumber(*height, start, true);
        } else if (whole && (word.size() - unit <= 3 || base::isListed(kUnits, word.substr(unit)))) {
            addNumber(*whole, start, true);
            if (!setUnit(word.substr(unit)))
                m_groups[m_value].unit += (m_groups[m_value].unit.empty() ? "" : " ") + word.substr(unit);
        } else if (hasWrongLetter(word)) {
            addNumber(kNan, start);
        } else {
            addWord(start, m_at);
        }
    }

    /// Notes the unit of the last number, if a word is one; pixels are none.
    bool setUnit(std::string_view word)
    {
        std::string &unit = m_groups[m_value].unit;
        const bool isUnit = base::isListed(kUnits, word);
        if (isUnit && !base::isListed(' ' + unit + ' ', word))
            unit += (unit.empty() ? "" : " ") + std::string(word);
        return isUnit || base::isListed(kPixels, word);
    }

    void addNumber(double value, std::size_t start, bool isInWord = false)
    {
        endName(Name);
        start -= std::size_t(m_given[start] == m_text[start] ? 0 : 2); // U+2212
        m_groups.back().numbers.push_back({value * m_factor * m_unit, isInWord, m_isBehindSemicolon, start,
                                           m_at - start, m_line, m_open.empty() ? 0 : m_open.back(),
                                           std::exchange(m_subscripts, {}), std::exchange(m_isOperand, false)});
        m_count += std::size_t(!m_groups.back().numbers.back().isOperand);
        m_isBehindSemicolon = m_isBehindEquals = false;
        m_operandLine = m_line;
    }

    void readWord()
    {
        const std::size_t start = m_at;
        while ((m_at = behind(m_at, kOfName)),
               isHere("->") || isHere("::") || (at(m_at) == '-' && isAmong(at(m_at + 1), kOfName)))
            m_at += 2;
        const auto end = m_text.find_last_not_of('.', m_at - 1) + 1;
        const auto name = m_text.substr(start, end - start);
        const std::string word = plain(lastPart(name)),
                          type = plain(lastPart(m_name.substr(m_name.find_last_of(" \t*/@") + 1)));
        if (m_commentEnd > 0)
            return addWord(start, end);
        if (word == "nan" || word == "inf" || word == "infinity")
            return addNumber(*numberOf(word), start);
        const bool isUnit = m_name.empty() && m_count > 0 && m_operandLine == m_line && lengthOf("_=") == 0;
        if ((isUnit && !isAmong(at(behind(m_at, " \t")), "=:(") && setUnit(word)) || readComputed(word, start)
            || readFilled(word, start))
            return;
        if (word == "x" && m_name.empty() && m_operandLine == m_line && lengthOf("_9") > 0)
            return; // 800 x 600
        if (isAmongNumbers(start, end)) {
            constexpr std::size_t kFew = 1000; // groups: a larger text is no program's
            const bool areFew = m_groups.size() < kFew;
            if (areFew)
                shareAll(); // "fx, fy = 600, 610"
            const auto known = areFew ? valueOf(name) : std::nullopt;
            if (!known)
                setArithmetic(std::string(name) + ',');
            return addNumber(known.value_or(kNan), start);
        }
        addWord(start, end);
        m_at += lengthOf(":9`:"); // main.cpp:123:
        readSubscripts(word);
        if (const auto length = lengthOf("<&,_9>"); length > 0) { // std::array<double, 9>
            m_at += length;
            return endName(Other);
        }
        if (at(m_at) != '(')
            return;
        constexpr std::string_view kTypes[]{"mat", "vec", "point3", "size", "quat", "dquat", "angleaxis"};
        const bool isTyped = std::ranges::any_of(kTypes, [&](std::string_view one) { return type.starts_with(one); });
        if (isTyped || (m_isNameFirst && m_name.find(' ') != m_name.npos && !m_name.starts_with("return")))
            return endName(Name); // Vec3d t(0, 0, 5)
        endName(Other);
        const bool isBehindOperand = m_count > 0 && m_operandLine == m_line;
        if (base::isListed(" inv inverse transpose ", word)
                ? isBehindOperand || m_count == 0
                : isBehindOperand && at(start - 1) == '.'
                      && base::isListed(" inverted invertedsafe transposed t ", word))
            setArithmetic(word);
        const bool isOfQuaternion = m_groups[m_value].name.find("uaternion") != m_text.npos;
        if (isOfQuaternion && word.starts_with("vector4")) // Eigen's order is another one then
            setArithmetic(word);
        if (word == "matrix" && lengthOf("(c(") > 0) { // R
            const auto rest = m_text.substr(m_at);
            const auto call = rest.substr(0, base::closingBracket(rest, 0));
            if (call.find("byrow") == call.npos)
                setArithmetic(std::string(kByColumns));
        }
        if (m_isBehindEquals && lengthOf("(_+_)") > 0 && !base::isListed(kCasts, word)
            && word.find("float") == word.npos)
            setArithmetic(word);
        if (word == "radians" || word == "deg2rad" || word == "degtorad") {
            m_unit = geometry::radiansFromDegrees(1.0);
            m_unitDepth = m_open.size();
        }
    }

    /// The number that "fx: 600" above gives a name, and nothing else.
    std::optional<double> valueOf(std::string_view name) const
    {
        std::optional<double> value;
        for (const Group &group : m_groups) {
            if (group.kind != Name || group.name != name || group.numbers.empty())
                continue;
            const bool isPlain = group.numbers.size() == 1 && group.arithmetic.empty() && group.unit.empty();
            const auto end = std::size_t(group.name.data() - m_given.data()) + name.size();
            const bool isSet = at(behind(end, " \t\"'")) != ':'; // by a program: withValues() has its value
            if (!isPlain || isSet || (value && *value != group.numbers[0].value))
                return std::nullopt;
            value = group.numbers[0].value;
        }
        return value;
    }

    /// Returns whether a word stands for a number of a list: [0.1, null, 0.3].
    bool isAmongNumbers(std::size_t begin, std::size_t end) const
    {
        if (m_lists.empty() || !m_lists.back() || begin == 0)
            return false;
        const auto last = m_text.find_last_not_of(" \t\r\n", begin - 1), next = behind(end, " \t\r\n");
        if (!isAmong(at(last), ",[{") || !isAmong(at(next), ",]}"))
            return false;
        const auto &numbers = m_groups.back().numbers;
        const bool isBehind = !numbers.empty() && numbers.back().bracket == m_open.back();
        return isBehind || (at(next) == ',' && isNumberAt(behind(next + 1, " \t\r\n")));
    }

    /// Reads the value of "np.pi / 3" and "math.sqrt(2)"; that of a function that is not known is NaN.
    /// Returns whether it is one.
    bool readComputed(const std::string &word, std::size_t start)
    {
        const bool isCall =
            at(m_at) == '(' && (m_isBehindEquals || !m_open.empty()) && base::isListed(kFunctions, word);
        if (word != "pi" && !isCall)
            return false;
        constexpr std::size_t kMost = 80;
        const auto rest = m_text.substr(start, m_at - start + kMost);
        const auto close = isCall ? base::closingBracket(rest, m_at - start) : 0;
        const auto text = rest.substr(0, rest.find_first_of(",;)]}\n", close == rest.npos ? 0 : close + 1));
        const auto value = base::sourceNumber(text, [](std::string_view) { return std::optional<std::string_view>(); });
        if (!value && !isCall)
            return false;
        const bool isNegative = before(start) == '-' && !m_isBehindEquals;
        m_at = start + text.size();
        addNumber(!value ? kNan : isNegative ? -value->value : value->value, start);
        if (!value)
            setArithmetic(std::string(text));
        return true;
    }

    /// Reads the numbers of eye(3), zeros((3, 1)) and OpenCV's zeros(3, 1, CV_64F). Returns whether it is one.
    bool readFilled(const std::string &word, std::size_t start)
    {
        const bool isIdentity = word == "eye" || word == "identity";
        if (!isIdentity && word != "zeros")
            return false;
        for (const char *pattern : {"('~)", "(('~,_'~))", "('~,_'~,_&)"}) {
            const auto length = lengthOf(pattern);
            m_at += length;
            const int side = length > 0 ? foundAt(0) : 0, count = isIdentity           ? side
                                                                  : m_found.size() > 1 ? foundAt(1)
                                                                                       : 1;
            for (int i = 0; i < side * count; ++i)
                addNumber(isIdentity && i % (side + 1) == 0 ? 1.0 : 0.0, start);
            if (length > 0)
                return true;
        }
        return false;
    }

    /// Reads the one or two integers of m[3], m[1][2], m(0, 1) and m01, and skips other subscripts,
    /// data['xpos'].
    void readSubscripts(const std::string &word)
    {
        std::vector<int> found;
        m_subscripts.clear();
        if (const auto pair = base::numberIn<int>(std::string_view(word).substr(!word.empty()));
            pair && word.size() == 3 && isAmong(word[0], "me"))
            m_subscripts = {*pair / 10, *pair % 10}; // Unity's e00
        for (const char *pattern : {"[_'9_][_'9_]", "[_'9_]", "[_'9_,_'9_]", "(_'~_,_'~_)"}) {
            const auto length = lengthOf(pattern);
            if (length == 0)
                continue;
            for (std::size_t i = 0; i < m_found.size(); ++i)
                found.push_back(foundAt(i));
            setSubscripts(std::move(found));
            if (m_subscripts.size() == 2 && pattern[5] == ']') // as GLM counts: the position in memory
                m_subscripts = {4 * m_subscripts[0] + m_subscripts[1]};
            m_at += length;
            return;
        }
        m_at += lengthOf("[X]");
    }

    /// Takes the subscripts of an entry of a matrix; others, of longer arrays, tell nothing.
    void setSubscripts(std::vector<int> found)
    {
        constexpr int kLargest = 16; // some libraries count from 1
        const bool isEntry = std::ranges::all_of(found, [](int one) { return one >= 0 && one <= kLargest; });
        m_subscripts = isEntry ? std::move(found) : std::vector<int>();
    }

    void readSign(char c)
    {
        if (m_commentEnd == 0 && readArithmetic(c))
            return;
        ++m_at;
        if (isAmong(c, ",;)]}"))
            endName(Word);
        else if (isAmong(c, "([{<:") || (c == '=' && at(m_at) != '='))
            endName(Name);
        if (m_commentEnd > 0)
            return;
        m_isBehindEquals = isAmong(c, "=:");
        m_isBehindSemicolon = m_isBehindSemicolon || c == ';';
        m_isOperand = m_isOperand && !isAmong(c, ",;[]{}");
        if (isAmong(c, "([{")) {
            m_open.push_back(++m_brackets);
            m_lists.push_back(c != '(');
            m_subscripts.clear();
        } else if (isAmong(c, ")]}")) {
            if (!m_open.empty()) {
                m_open.pop_back();
                m_lists.pop_back();
            }
            if (m_open.size() <= m_unitDepth)
                m_unit = 1.0;
            m_operandLine = m_line;
        } else if (c == '#') {
            m_at = behind(m_at, kDigits); // #1
        }
    }

    /// Notes an operator that changes the numbers of a value. Returns whether there is one.
    bool readArithmetic(char c)
    {
        if (!isAmong(c, "*/@+-'."))
            return false;
        constexpr std::size_t kMost = 40;
        const auto line = m_text.substr(m_at + 1, kMost);
        const bool isBehindOperand = m_count > 0 && m_operandLine == m_line && m_name.empty(),
                   isProduct = isAmong(c, "*/@");
        const auto operand = behind(m_at + 1, m_open.empty() ? " \t\r" : " \t\r\n");
        const bool isApartInList = at(m_at + 1) == '\n' && !m_open.empty();
        const bool isSum =
            isAmong(c, "+-") && (at(m_at + 1) == ' ' || isApartInList) && isAmong(at(operand), "0123456789+-.[");
        const bool isTransposed = isAmong(before(), "])") && ((c == '\'' && m_at + 1 != m_quoteEnd) || isHere(".T"));
        const bool isOfList = c == '-' && isAmong(at(operand), "([{"); // -[1, 2, 3]
        // "scale * np.array(…)", "-np.array(…)"
        const bool isFirst =
            m_count == 0 && m_isBehindEquals && (m_name.empty() ? lengthOf("-@") > 0 || isOfList : isProduct);
        if (isFirst)
            setArithmetic(std::string(m_name.substr(0, kMost)) + (m_name.empty() ? "-" : std::string{' ', c}));
        else if (isBehindOperand && isTransposed)
            setArithmetic(".T");
        else if (isBehindOperand && (isProduct || isSum))
            setArithmetic(std::string{c, ' '}
                          + std::string(base::trimmed(line.substr(0, line.find_first_of("\r\n;#")))));
        // "1280 - 80", but not "3 - 5 6"
        const bool isSumOfTwo = isBehindOperand && isSum && m_count == 1 && at(operand) != '['
                                && !isNumberAt(behind(behind(operand, kOfNumber), " \t\r,"));
        m_isOperand = m_isOperand || isSumOfTwo || (isBehindOperand && isAmong(c, "*/"));
        // Skipping a sign would negate the number.
        const auto last = m_text.find_last_not_of(" \t", m_at - 1);
        const bool isApart = isSum && c == '-' && m_at > 0 && isAmong(at(last), "0123456789[({,;.");
        if (!isFirst && !isApart && !(isBehindOperand && (isTransposed || isProduct)))
            return false;
        m_at += 1 + std::size_t(c == '.');
        if (isApart) {
            addNumber(kNan, m_at - 1);
            m_isOperand = isSumOfTwo;
        }
        return true;
    }

    void setArithmetic(const std::string &text)
    {
        std::string &arithmetic = m_groups[m_value].arithmetic;
        if (arithmetic.empty())
            arithmetic = text;
    }

    void addWord(std::size_t begin, std::size_t end)
    {
        if (m_name.empty()) {
            m_nameBegin = begin;
            m_isNameFirst = m_isLineBlank;
        }
        m_name = m_text.substr(m_nameBegin, end - m_nameBegin);
    }

    /// Ends the adjacent words here, if there are any.
    void endName(GroupKind kind)
    {
        if (!m_name.empty())
            add(m_commentEnd > 0 ? Other : kind, m_nameBegin, m_nameBegin + m_name.size());
        m_name = {};
    }

    void add(GroupKind kind, std::size_t begin, std::size_t end)
    {
        if (m_groups.size() > kMostGroups)
            throw base::Error{
                .text = base::tr("the text has more than %1 names; give the part that has the camera", kMostGroups),
                .line = static_cast<int>(m_line)};
        m_groups.push_back({m_given.substr(begin, end - begin), kind, m_line});
        m_factor = kind == Other ? m_factor : 1.0;
        m_value = kind == Name ? m_groups.size() - 1 : m_value;
        m_count = kind == Name ? 0 : m_count;
        m_isOperand = m_isOperand && kind != Name;
    }

    std::string_view m_given;
    std::string m_plain;
    std::string_view m_text = m_plain;
    bool m_isXml = false;
    std::size_t m_at = 0, m_line = 1;
    std::size_t m_commentEnd = 0, m_quoteEnd = 0; ///< of the comment (0: none) and the quoted numbers that are read
    std::vector<std::size_t> m_found, m_labels;   ///< places in a pattern, and those of labels
    std::vector<std::size_t> m_open;              ///< the enclosing brackets
    std::vector<bool> m_lists;                    ///< of these, whether they are [ or {
    std::size_t m_brackets = 0;
    std::string_view m_name; ///< the adjacent words that ended here last, if nothing followed them yet
    std::size_t m_nameBegin = 0;
    bool m_isNameFirst = false, m_isLineBlank = true;
    bool m_isBehindSemicolon = false;    ///< of the next number
    std::vector<int> m_subscripts;       ///< of the next number
    double m_unit = 1.0, m_factor = 1.0; ///< of the numbers up to a closing bracket, and of those up to the next name
    std::size_t m_unitDepth = 0;         ///< the open brackets around that one
    std::size_t m_operandLine = 0;       ///< the line of the last number or closing bracket
    bool m_isBehindEquals = false;       ///< only words stand between the last equals sign or colon and here
    std::size_t m_value = 0;             ///< the last group of the kind Name
    std::size_t m_count = 0;             ///< of the numbers behind that name, without operands
    bool m_isOperand = false;            ///< the next number is one
    std::vector<Group> m_groups;
};

} // namespace

std::vector<Group> scan(std::string_view text)
{
    return Scanner(text).scan();
}

std::string withoutRemarks(std::string_view given)
{
    std::string text(given);
    int open = 0;
    constexpr std::string_view kBlank = " \t\r\n";
    for (std::size_t at = 0; (at = text.find_first_not_of(kBlank, at)) != text.npos;) {
        const std::string_view rest = std::string_view(text).substr(at), start = rest.substr(0, 3);
        const bool isQuoted = start == "\"\"\"" || start == "'''";
        const bool isRemark =
            isQuoted || (open <= 0 && (rest.starts_with(';') || base::lowerCase(rest.substr(0, 4)) == "rem "));
        const std::size_t end = isQuoted ? text.find(start, at + 3) : text.find('\n', at);
        for (const std::size_t last = end > text.size() ? text.size() : end + (isQuoted ? 3 : 0); at < last; ++at) {
            char &c = text[at];
            c = isRemark && c != '\n' ? ' ' : c;
            open += isAmong(c, "([{") ? 1 : isAmong(c, ")]}") ? -1 : 0;
        }
    }
    return text;
}

std::string plain(std::string_view name)
{
    std::string letters = base::lowerCase(name);
    std::erase_if(letters, [](char c) { return c == '_' || !isAmong(c, kOfName); });
    std::erase(letters, '.');
    return letters;
}

std::vector<std::string> wordsOf(std::string_view names)
{
    std::vector<std::string> words;
    const auto kind = [&](std::size_t i) {
        const char c = i < names.size() ? names[i] : ' ';
        return isDigit(c) ? '9' : c >= 'a' && c <= 'z' ? 'a' : c >= 'A' && c <= 'Z' ? 'A' : ' ';
    };
    for (std::size_t i = 0; i < names.size(); ++i) {
        const char before = kind(i - 1), here = kind(i), next = kind(i + 1);
        if (here == ' ')
            continue;
        const bool isHump = here == 'A' && (before == 'a' || (before == 'A' && next == 'a' && i + 2 < names.size()));
        const bool isTo = names[i] == '2' && isAmong(before, "aA") && isAmong(next, "aA");
        const bool isWordTo = before == 'A' && names.substr(i).starts_with("to") && kind(i + 2) == 'A'; // ItoC
        if (before == ' ' || (here == '9') != (before == '9') || isHump || isWordTo)
            words.emplace_back(isTo ? "to" : "");
        if (isTo)
            continue;
        words.back() += base::lowerCase(names.substr(i, 1));
    }
    return words;
}

std::string_view lastPart(std::string_view path)
{
    return path.substr(path.find_last_of(".>:") + 1);
}

} // namespace unprojector::cameras
