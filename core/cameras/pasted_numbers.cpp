#include "core/cameras/pasted_numbers.h"

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/call_syntax.h"
#include "core/cameras/paste_marks.h"
#include "core/cameras/pasted_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>

namespace unprojector::cameras {
using namespace geometry;
using syntax::isDigit;

namespace {

/// U+2212, the minus sign of typeset numbers.
constexpr std::string_view kMinusSign = "\xe2\x88\x92";

bool isWordCharacter(char c)
{
    // Includes # for 1.#QNAN, which is not 1.
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' || c == '-' || c == '#';
}

/// Parses a number, with or without the f of a C float.
std::optional<double> numberOf(std::string_view word)
{
    if (word.size() > 1 && word.front() == '+')
        word.remove_prefix(1);
    if (word.size() > 1 && (word.back() == 'f' || word.back() == 'F') && word.find_first_of("0123456789") != word.npos)
        word.remove_suffix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

/// Returns whether a word stands for a number that cannot be read: the output of other languages
/// and broken programs, or an overflow, as in 1.#QNAN, 0x10, 1d0, 1e400. If it were skipped,
/// another number would take its position.
bool isMeantAsNumber(std::string_view word)
{
    if (!word.empty() && (word.front() == '-' || word.front() == '+'))
        word.remove_prefix(1);
    if (word.empty() || !(isDigit(word.front()) || word.front() == '.')
        || word.find_first_of("0123456789") == word.npos)
        return false;
    return word.find('#') != word.npos || word.substr(0, 2) == "0x" || word.substr(0, 2) == "0X"
           || word.find_first_not_of("0123456789.eEdD+-") == word.npos;
}

/// One or two integers in the brackets that open at `at`, as in m[3] and m(0, 1), or nothing. A
/// single number in round brackets is no subscript.
std::optional<std::vector<int>> subscriptsAt(std::string_view text, std::size_t at, std::size_t &end)
{
    const char close = text[at] == '[' ? ']' : ')';
    std::vector<int> indices;
    for (end = at + 1; end < text.size() && indices.size() < 2;) {
        while (end < text.size() && text[end] == ' ')
            ++end;
        int index = 0;
        std::size_t digits = 0;
        for (; end < text.size() && isDigit(text[end]) && digits < 3; ++end, ++digits)
            index = 10 * index + (text[end] - '0');
        if (digits == 0 || digits > 2)
            return std::nullopt;
        indices.push_back(index);
        while (end < text.size() && text[end] == ' ')
            ++end;
        if (end >= text.size())
            return std::nullopt;
        if (text[end] == close && (close == ']' || indices.size() == 2)) {
            ++end;
            return indices;
        }
        if (text[end++] != ',')
            return std::nullopt;
    }
    return std::nullopt;
}

/// {row, column} of m01 and M_01.
std::vector<int> subscriptsOfName(const std::string &word)
{
    const std::size_t n = word.size();
    if (n < 3 || !isDigit(word[n - 1]) || !isDigit(word[n - 2]))
        return {};
    const char before = word[n - 3] == '_' && n > 3 ? word[n - 4] : word[n - 3];
    if (before != 'm' && !(before == 'e' && n == 3)) // Unity's files have e00
        return {};
    return {word[n - 2] - '0', word[n - 1] - '0'};
}

class Reader {
public:
    explicit Reader(std::string_view text) : m_text(text) {}

    Result<PastedNumbers, PasteError> read()
    {
        while (m_at < m_text.size()) {
            if (isWordHere()) {
                if (const auto error = readWord())
                    return *error;
            } else {
                readMark();
            }
        }
        addSize();
        return PastedNumbers{std::move(m_numbers), std::move(m_aside)};
    }

private:
    bool isWordHere() const { return isWordCharacter(m_text[m_at]) || m_text.substr(m_at).starts_with(kMinusSign); }

    void readMark()
    {
        const char c = m_text[m_at];
        // A name may contain one bracket of two.
        if (c != '\n' && isComment(m_at)) {
            ++m_at;
            return;
        }
        if (c == '[' || c == '(') {
            const bool isBehindName = m_at > 0 && (isWordCharacter(m_text[m_at - 1]) || m_text[m_at - 1] == ']');
            std::size_t end = 0;
            if (const auto indices = isBehindName ? subscriptsAt(m_text, m_at, end) : std::nullopt) {
                // m[1][2] as GLM counts: the position in memory.
                const bool isSecond = m_text[m_at - 1] == ']' && m_subscripts.size() == 1 && indices->size() == 1;
                m_subscripts = isSecond ? std::vector<int>{4 * m_subscripts[0] + indices->front()} : *indices;
                m_at = end;
                return;
            }
        }
        if (c == '\\' && takePowerOfTen())
            return;
        if (c == '[' || c == '(' || c == '{') {
            m_open.push_back(++m_brackets);
            m_subscripts.clear();
        } else if ((c == ']' || c == ')' || c == '}') && !m_open.empty()) {
            m_open.pop_back();
        } else if (c == ';') {
            m_isBehindSemicolon = true;
        } else if (c == '\n') {
            ++m_line;
            m_lineStart = m_at + 1;
            m_isAside = false;
            m_size = SizePart::None;
        }
        ++m_at;
    }

    /// The viewport of a width and a height, 0 0 width height, if the text names no other.
    void addSize()
    {
        const bool hasViewport = std::any_of(m_numbers.begin(), m_numbers.end(), [](const PastedNumber &number) {
            return number.part == PastedPart::Viewport;
        });
        const bool isOfMatrix = m_width && m_height && *m_width <= kMatrixSide && *m_height <= kMatrixSide;
        if (m_numbers.empty() || hasViewport || !m_width || !m_height || isOfMatrix) {
            if (m_width)
                m_aside.emplace_back("width");
            if (m_height)
                m_aside.emplace_back("height");
            return;
        }
        m_named = NamedPart{PastedPart::Viewport};
        for (const double value : {0.0, 0.0, *m_width, *m_height})
            add(value, m_text.size(), {});
    }

    /// Returns whether the number is a factor alone on its line: MATLAB's 1.0e+03 *.
    bool isFactor() const
    {
        const std::size_t star = m_text.find_first_not_of(" \t", m_at);
        if (star == m_text.npos || m_text[star] != '*')
            return false;
        const std::size_t next = m_text.find_first_not_of(" \t\r", star + 1);
        return next == m_text.npos || m_text[next] == '\n';
    }

    /// Takes a number that belongs to no matrix. Returns whether it is one.
    bool takeAside(double value)
    {
        if (takeSize(value))
            return true;
        if (m_isAside)
            nameAside();
        return m_isAside;
    }

    /// Takes a number of a width, a height or both. The first width and height are used; a name
    /// that repeats them with other numbers is reported.
    bool takeSize(double value)
    {
        const int most = m_size == SizePart::None ? 0 : m_size == SizePart::Both ? 2 : 1;
        if (m_sizeNumbers == most)
            return false;
        const bool isHeight = m_size == SizePart::Height || m_sizeNumbers == 1;
        ++m_sizeNumbers;
        std::optional<double> &side = isHeight ? m_height : m_width;
        if (!side || *side <= kMatrixSide)
            side = value;
        else if (*side != value)
            nameAside();
        return true;
    }
    void nameAside()
    {
        if (m_aside.empty() || m_aside.back() != m_name)
            m_aside.push_back(m_name);
    }

    /// Reads LaTeX's \cdot 10^{-16} after a number.
    bool takePowerOfTen()
    {
        constexpr std::string_view kTimes = "\\cdot 10^{";
        const std::string_view rest = m_text.substr(m_at);
        if (m_numbers.empty() || !rest.starts_with(kTimes))
            return false;
        const std::size_t close = rest.find('}');
        if (close == rest.npos)
            return false;
        const std::string exponent(rest.substr(kTimes.size(), close - kTimes.size()));
        const auto value = numberOf(m_lastWord + 'e' + exponent);
        if (!value || !std::isfinite(*value))
            return false;
        m_numbers.back().value = *value;
        m_at += close + 1;
        return true;
    }

    /// Returns whether a key ends at `end`: a colon follows, perhaps after a quote.
    bool isKey(std::size_t end) const
    {
        if (end < m_text.size() && (m_text[end] == '"' || m_text[end] == '\''))
            ++end;
        return end < m_text.size() && m_text[end] == ':';
    }

    /// Returns whether a separate minus is the sign of a number rather than a bullet or dash.
    /// Skipping a sign would negate the number.
    bool isSignApart(std::size_t at) const
    {
        const std::string_view before = m_text.substr(m_lineStart, at - m_lineStart);
        const std::size_t last = before.find_last_not_of(" \t");
        return last != before.npos
               && (isDigit(before[last]) || std::string_view("[({,;.").find(before[last]) != before.npos);
    }

    /// Returns whether the line is a comment. Its numbers are not a matrix's, but its words may
    /// name one.
    bool isComment(std::size_t at) const
    {
        std::string_view before = m_text.substr(m_lineStart, at - m_lineStart);
        before.remove_prefix(std::min(before.find_first_not_of(" \t"), before.size()));
        return before.starts_with('#') || before.starts_with('%') || before.starts_with("//");
    }

    PasteError wordError(const std::string &word, std::size_t start) const
    {
        return {base::tr("\"%1\" is not a finite number", word), m_line + 1, start - m_lineStart + 1};
    }

    std::optional<PasteError> readWord()
    {
        const std::size_t start = m_at;
        std::string word;
        while (m_at < m_text.size() && isWordHere()) {
            const bool isSign = !isWordCharacter(m_text[m_at]);
            word += isSign ? '-' : m_text[m_at];
            m_at += isSign ? kMinusSign.size() : 1;
        }
        const std::optional<double> value = numberOf(word);
        if (isComment(start)) {
            if (!value)
                name(word, start);
            return std::nullopt;
        }
        // Qt prints the size of a rectangle as 300x200.
        const bool isOfViewport = m_named && m_named->part == PastedPart::Viewport;
        if (const std::size_t cross = word.find('x');
            (isOfViewport || m_size == SizePart::Both) && cross != word.npos) {
            const auto width = numberOf(word.substr(0, cross)), height = numberOf(word.substr(cross + 1));
            if (width && height && *width > 0.0 && std::isfinite(*width) && std::isfinite(*height)) {
                if (!takeAside(*width))
                    add(*width, start, word);
                if (!takeAside(*height))
                    add(*height, start + cross + 1, word);
                return std::nullopt;
            }
        }
        if (word == "-" && isSignApart(start))
            return wordError(word, start);
        if (!value && isMeantAsNumber(word))
            return wordError(word, start);
        if (!value) {
            name(word, start);
            return std::nullopt;
        }
        if (!std::isfinite(*value)) {
            return wordError(word, start);
        }
        if (takeAside(*value))
            return std::nullopt;
        if (isFactor()) {
            m_factor = *value;
            return std::nullopt;
        }
        if (isKey(m_at) && word.find_first_not_of("0123456789") == word.npos && word.size() <= 2) {
            m_subscripts = {int(*value)};
            return std::nullopt;
        }
        add(*value, start, word);
        return std::nullopt;
    }

    void add(double value, std::size_t start, const std::string &word)
    {
        PastedNumber number;
        number.value = value * m_factor;
        number.at = start;
        number.line = m_line;
        number.bracket = m_open.empty() ? 0 : m_open.back();
        number.isBehindSemicolon = m_isBehindSemicolon;
        number.subscripts = std::move(m_subscripts);
        number.words = std::move(m_words);
        if (m_named) {
            number.part = m_named->part;
            number.isInverse = m_named->isInverse;
        }
        m_numbers.push_back(std::move(number));
        m_subscripts.clear();
        m_words.clear();
        m_name.clear();
        m_isBehindSemicolon = false;
        m_lastWord = word;
    }

    /// Adds a name. Adjacent words form one name: "model view", "projection * view",
    /// "inverse(view)".
    void name(const std::string &word, std::size_t start)
    {
        const std::string_view between = m_text.substr(m_nameEnd, start - m_nameEnd);
        // Names are short. Prose, as one name, would be searched again at each of its words.
        constexpr std::size_t kLongestName = 80;
        const bool isJoined = !m_name.empty() && m_name.size() < kLongestName
                              && (between.find_first_not_of(" *\t") == between.npos
                                  || (between == "(" && base::lowerCase(m_name).ends_with("inverse")));
        m_name = isJoined ? m_name + ' ' + word : word;
        m_nameEnd = m_at;
        m_words.push_back(base::lowerCase(word));
        m_subscripts = subscriptsOfName(m_words.back());
        m_factor = 1.0;
        const std::string letters = lettersOf(m_name);
        m_isAside = isAside(letters);
        m_size = letters == "width"    ? SizePart::Width
                 : letters == "height" ? SizePart::Height
                 : isSize(letters)     ? SizePart::Both
                                       : SizePart::None;
        m_sizeNumbers = 0;
        if (m_isAside || m_size != SizePart::None)
            return;
        if (const auto named = namedBy(m_name))
            m_named = named;
    }

    /// The numbers of this line that are an image's size.
    enum class SizePart { None, Width, Height, Both };

    static constexpr double kMatrixSide = 4.0; ///< "size 4x4" is a matrix's

    std::string_view m_text;
    std::size_t m_at = 0, m_line = 0, m_lineStart = 0;
    std::vector<std::size_t> m_open; ///< the enclosing brackets
    std::size_t m_brackets = 0;
    bool m_isBehindSemicolon = false;
    std::vector<int> m_subscripts;
    std::vector<std::string> m_words;
    std::string m_lastWord; ///< the last word that is a number
    std::string m_name;
    std::size_t m_nameEnd = 0;
    std::optional<NamedPart> m_named;
    double m_factor = 1.0;  ///< of the numbers up to the next name
    bool m_isAside = false; ///< the numbers of this line belong to no matrix
    SizePart m_size = SizePart::None;
    int m_sizeNumbers = 0; ///< read after the size's name
    std::optional<double> m_width, m_height;
    std::vector<std::string> m_aside; ///< names of numbers that belong to no matrix
    std::vector<PastedNumber> m_numbers;
};

} // namespace

Result<PastedNumbers, PasteError> pastedNumbers(std::string_view text)
{
    const std::string cleaned = withoutPrintersMarks(text);
    return Reader(cleaned).read();
}

} // namespace unprojector::cameras
