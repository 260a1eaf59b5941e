#include "core/cameras/named_values.h"

#include "core/base/expression.h"
#include "core/base/letters.h"
#include "core/geometry/numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

namespace unprojector::cameras {
using base::isDigit;
using base::isLetter;

namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/// The part of "camera.data.lens" or "cam->lens" behind the last dot or arrow.
std::string_view lastPart(std::string_view path)
{
    const std::size_t dot = path.find_last_of(".>");
    return dot == path.npos ? path : path.substr(dot + 1);
}

class Reader {
public:
    explicit Reader(std::string_view text) : m_text(text) {}

    std::vector<NamedValue> read()
    {
        m_values.emplace_back().words.emplace_back();
        while (m_at < m_text.size())
            readOne();
        endWords();
        return std::move(m_values);
    }

private:
    void readOne()
    {
        const char c = m_text[m_at];
        const bool isQuote =
            c == '"' || (c == '\'' && (m_at == 0 || (!isLetter(m_text[m_at - 1]) && !isBehindBracket())));
        if (c == '\n')
            endLine();
        else if (c == '#' || m_text.substr(m_at).starts_with("//"))
            m_at = std::min(m_text.find('\n', m_at), m_text.size());
        else if (isQuote && readQuoted())
            return;
        else if (isLetter(c))
            readName();
        else if (const std::size_t length = numberLength(); length > 0)
            readNumber(length);
        else
            readMark(c);
    }

    void endLine()
    {
        // A name alone on its line may be the name of the numbers below.
        const bool isName = !m_words.empty() && m_areWordsFirst;
        const std::size_t next = isName ? m_text.find_first_not_of(" \t\r\n", m_at) : m_text.npos;
        const bool isAlone = next != m_text.npos
                             && (isDigit(m_text[next]) || std::string_view("-+.[(<").find(m_text[next]) != m_text.npos);
        if (isAlone)
            begin();
        else
            endWords();
        ++m_line;
        ++m_at;
        m_isLineBlank = true;
    }

    /// Reads a mark that is no part of a name or number.
    void readMark(char c)
    {
        if (readArithmetic(c))
            return;
        if (c == '=' || c == ':') {
            m_behindEquals = m_at + 1;
            if (!m_words.empty() && !m_text.substr(m_at).starts_with("=="))
                begin();
        } else if (c == ',' || c == ';' || c == ')' || c == ']' || c == '}') {
            endWords();
        } else if ((c == '(' || c == '[' || c == '<') && !m_words.empty()) {
            begin(); // "position (1, 2, 3)"
        }
        if (c == ')' || c == ']')
            m_operandLine = m_line;
        m_isLineBlank = m_isLineBlank && isBlank(c);
        ++m_at;
    }

    bool isBehindBracket() const { return m_at > 0 && (m_text[m_at - 1] == ']' || m_text[m_at - 1] == ')'); }

    /// The rest of the line behind `at`, without blanks around it.
    std::string_view restOfLine(std::size_t at) const
    {
        constexpr std::size_t kMost = 40;
        std::string_view rest = m_text.substr(at, kMost);
        rest = rest.substr(0, rest.find_first_of("\r\n;#"));
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        return rest.substr(0, rest.find_last_not_of(" \t") + 1);
    }

    /// Reads an operator that changes the numbers of a value: MATLAB's factor is applied, others are
    /// noted. Returns whether there is one.
    bool readArithmetic(char c)
    {
        if (std::string_view("*/@+-'.").find(c) == std::string_view::npos)
            return false;
        NamedValue &value = m_values.back();
        const char next = m_at + 1 < m_text.size() ? m_text[m_at + 1] : '\0';
        const bool isBehindOperand = !value.numbers.empty() && m_operandLine == m_line && m_words.empty();
        const std::string_view rest = restOfLine(m_at + 1);
        if (c == '*' && isBehindOperand && value.numbers.size() == 1 && (rest.empty() || rest.front() == '[')) {
            m_factor = value.numbers.front();
            value.numbers.clear();
            m_at += 1;
            return true;
        }
        const char before = m_at > 0 ? m_text[m_at - 1] : '\0';
        const bool isComment = (c == '/' && next == '*') || (c == '*' && (next == '/' || before == '/'));
        const bool isProduct = (c == '*' || c == '/' || c == '@') && !isComment;
        const bool isSum = (c == '+' || c == '-') && next == ' ' && !rest.empty()
                           && (isDigit(rest.front()) || rest.front() == '[') && isBehindClosed();
        const bool isTransposed = isBehindBracket() && (c == '\'' || (c == '.' && next == 'T'));
        // "scale * np.array(…)", "-np.array(…)"
        const std::optional<std::string_view> operand = operandBefore();
        const bool isFirst = value.numbers.empty() && operand
                             && ((isProduct && !operand->empty()) || (c == '-' && operand->empty() && isLetter(next)));
        if (!(isBehindOperand && (isProduct || isSum || isTransposed)) && !isFirst)
            return false;
        if (value.arithmetic.empty())
            value.arithmetic = isTransposed ? ".T"
                               : isFirst    ? std::string(*operand) + c
                                            : c + (' ' + std::string(rest));
        m_at += isTransposed && c == '.' ? 2 : 1;
        m_isLineBlank = false;
        return true;
    }

    /// The name between the last equals sign or colon and here, perhaps empty; nothing for another
    /// text.
    std::optional<std::string_view> operandBefore() const
    {
        constexpr std::size_t kMost = 40;
        if (m_behindEquals == 0 || m_at - m_behindEquals > kMost)
            return std::nullopt;
        std::string_view before = m_text.substr(m_behindEquals, m_at - m_behindEquals);
        before.remove_prefix(std::min(before.find_first_not_of(" \t"), before.size()));
        const bool isName = std::all_of(before.begin(), before.end(), [](char one) {
            return isLetter(one) || isDigit(one) || one == '.' || one == ' ';
        });
        return isName ? std::optional(before) : std::nullopt;
    }

    /// Returns whether the last character before the blanks here closes a bracket.
    bool isBehindClosed() const
    {
        std::size_t at = m_at;
        while (at > 0 && isBlank(m_text[at - 1]))
            --at;
        return at > 0 && (m_text[at - 1] == ']' || m_text[at - 1] == ')');
    }

    /// Reads a quoted name or value. Returns whether the quote ends in its line.
    bool readQuoted()
    {
        const std::size_t end = m_text.find_first_of(std::array{m_text[m_at], '\n', '\0'}.data(), m_at + 1);
        if (end == m_text.npos || m_text[end] == '\n')
            return false;
        const std::string_view quoted = m_text.substr(m_at + 1, end - m_at - 1);
        std::size_t behind = end + 1;
        while (behind < m_text.size() && isBlank(m_text[behind]))
            ++behind;
        m_at = end + 1;
        m_isLineBlank = false;
        if (behind < m_text.size() && (m_text[behind] == ':' || m_text[behind] == '=')) {
            m_words = {plain(quoted)};
            m_whole = m_written = quoted;
            m_wordsLine = m_line;
            begin();
            m_at = behind + 1;
        } else {
            takeWord(quoted);
        }
        return true;
    }

    void readName()
    {
        const std::size_t start = m_at;
        while (m_at < m_text.size()
               && (isLetter(m_text[m_at]) || isDigit(m_text[m_at]) || m_text[m_at] == '.'
                   || m_text.substr(m_at).starts_with("->"))) {
            m_at += m_text[m_at] == '-' ? std::size_t{2} : std::size_t{1};
        }
        std::string_view name = m_text.substr(start, m_at - start);
        while (name.ends_with('.'))
            name.remove_suffix(1);
        const std::string word = plain(lastPart(name));
        if (word == "pi" && readPi(start))
            return;
        if (m_words.empty() && readNotFinite(word))
            return;
        skipSubscript();
        if (m_at < m_text.size() && m_text[m_at] == '(') { // a type or a function
            const bool isChange = word == "inv" || word == "inverse" || word == "transpose";
            NamedValue &value = m_values.back();
            if (isChange && (value.numbers.empty() || m_operandLine == m_line) && value.arithmetic.empty())
                value.arithmetic = word;
            m_areDegrees = word == "radians" || word == "deg2rad" || word == "degtorad";
            m_words.clear();
            ++m_at;
        } else if (name == "Matrix" && m_text.substr(m_at).starts_with(" 4x4")) {
            m_at += std::string_view(" 4x4").size();
        } else if (!isCross(name)) {
            if (m_words.empty()) {
                m_areWordsFirst = m_isLineBlank;
                m_wordsLine = m_line;
                m_whole = name;
            }
            m_words.push_back(word);
            m_written = name;
            m_whole = {m_whole.data(), std::size_t(name.data() + name.size() - m_whole.data())};
        }
        m_isLineBlank = false;
    }

    /// Reads nan, inf and infinity. Returns whether the word is one behind a name.
    bool readNotFinite(std::string_view word)
    {
        const bool isNan = word == "nan";
        if (m_values.size() == 1 || !(isNan || word == "inf" || word == "infinity"))
            return false;
        m_values.back().numbers.push_back(isNan ? std::numeric_limits<double>::quiet_NaN()
                                                : std::numeric_limits<double>::infinity());
        m_isLineBlank = false;
        return true;
    }

    /// Reads the value of "np.pi / 3". Returns whether it is one.
    bool readPi(std::size_t start)
    {
        const std::size_t end = std::min(m_text.find_first_of(",;)\n", start), m_text.size());
        const auto value = base::evaluate(m_text.substr(start, end - start), [](std::string_view name) {
            return lastPart(name) == "pi" ? std::optional(geometry::kPi) : std::nullopt;
        });
        if (!value)
            return false;
        m_values.back().numbers.push_back(*value);
        m_at = end;
        return true;
    }

    /// Returns whether a name is the cross of "800 x 600".
    bool isCross(std::string_view name) const
    {
        const std::size_t next = m_text.find_first_not_of(" \t", m_at);
        return name == "x" && !m_values.back().numbers.empty() && m_words.empty() && next != m_text.npos
               && isDigit(m_text[next]);
    }

    /// Skips the subscript of cam_xpos[0] and data['xpos'].
    void skipSubscript()
    {
        if (m_at >= m_text.size() || m_text[m_at] != '[')
            return;
        const std::size_t close = m_text.find_first_of("],. \n", m_at);
        if (close == m_text.npos || m_text[close] != ']')
            return;
        m_at = close + 1;
    }

    /// The length of the number that begins here, or 0.
    std::size_t numberLength()
    {
        const std::size_t start = m_at + (m_text[m_at] == '+' ? 1 : 0);
        const auto [end, error] = std::from_chars(m_text.data() + start, m_text.data() + m_text.size(), m_number);
        if (error != std::errc{} || !std::isfinite(m_number))
            return 0;
        return std::size_t(end - m_text.data()) - m_at;
    }

    void readNumber(std::size_t length)
    {
        if (!m_words.empty())
            begin(); // "lens 50"
        m_values.back().numbers.push_back(m_factor
                                          * (m_areDegrees ? geometry::radiansFromDegrees(m_number) : m_number));
        m_operandLine = m_line;
        m_areDegrees = false;
        m_at += length;
        m_isLineBlank = false;
        const auto next = [this](std::size_t i) { return m_at + i < m_text.size() ? m_text[m_at + i] : '\0'; };
        const bool isTimes = next(0) == 'x' && isDigit(next(1));                        // 800x600
        const bool isSuffix = (next(0) == 'f' || next(0) == 'F') && !isLetter(next(1)); // 1.0f
        if (isTimes || isSuffix)
            ++m_at;
    }

    /// Begins a value under the words read last.
    void begin()
    {
        if (m_values.back().numbers.empty() && m_values.back().word.empty())
            m_parent = m_values.back().words.back();
        NamedValue value;
        m_factor = 1.0;
        value.words = std::exchange(m_words, {});
        value.written = m_whole;
        if (value.words.size() > 1 && value.words.back().size() == 1) { // "Location X=1 Y=2 Z=3"
            m_parent = value.words[value.words.size() - 2];
            value.words = {value.words.back()};
            value.written = m_written;
        }
        value.parent = m_parent;
        value.line = m_wordsLine;
        m_values.push_back(std::move(value));
    }

    /// Words that name nothing are the value of the name before.
    void endWords()
    {
        if (!m_words.empty())
            takeWord(m_written);
        m_words.clear();
    }

    void takeWord(std::string_view word)
    {
        if (m_values.back().numbers.empty() && m_values.back().word.empty())
            m_values.back().word = word;
    }

    std::string_view m_text;
    std::size_t m_at = 0, m_line = 1;
    std::vector<std::string> m_words; ///< adjacent names that have no values yet
    std::string_view m_written;       ///< the last of them as written
    std::string_view m_whole;         ///< all of them as written
    std::size_t m_wordsLine = 1;
    bool m_areWordsFirst = false, m_isLineBlank = true;
    bool m_areDegrees = false; ///< of the next number: "np.radians(60)"
    std::string m_parent;
    double m_number = 0.0, m_factor = 1.0;
    std::size_t m_operandLine = 0;  ///< the line of the last number or closing bracket
    std::size_t m_behindEquals = 0; ///< the position behind the last equals sign or colon
    std::vector<NamedValue> m_values;
};

} // namespace

std::string plain(std::string_view name)
{
    std::string result;
    for (const char c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

bool NamedValue::isNamed(std::string_view name) const
{
    for (auto last = words.rbegin(); last != words.rend() && !name.empty() && name.ends_with(*last); ++last) {
        name.remove_suffix(last->size());
        if (name.empty())
            return true;
    }
    return false;
}

NamedValues::NamedValues(std::string_view text) : m_values(Reader(text).read()) {}

const NamedValue *NamedValues::find(std::initializer_list<std::string_view> names) const
{
    for (const std::string_view name : names) {
        const auto found = std::find_if(m_values.begin(), m_values.end(),
                                        [name](const NamedValue &value) { return value.isNamed(name); });
        if (found != m_values.end())
            return &*found;
    }
    return nullptr;
}

std::optional<double> NamedValues::number(std::initializer_list<std::string_view> names) const
{
    for (const std::string_view name : names) {
        for (const NamedValue &value : m_values) {
            if (value.isNamed(name) && !value.numbers.empty())
                return value.numbers.front();
        }
    }
    return std::nullopt;
}

bool NamedValues::isTrue(std::string_view name) const
{
    const NamedValue *value = find({name});
    return value
           && (value->word == "True" || value->word == "true"
               || (!value->numbers.empty() && value->numbers.front() != 0.0));
}

std::vector<double> NamedValues::numbers(std::initializer_list<std::string_view> names, std::size_t count,
                                         std::initializer_list<std::string_view> components) const
{
    for (const std::string_view name : names) {
        for (const NamedValue &value : m_values) {
            if (value.isNamed(name) && value.numbers.size() >= count)
                return value.numbers;
        }
        std::vector<double> found;
        for (const std::string_view component : components) {
            const auto one = std::find_if(m_values.begin(), m_values.end(), [&](const NamedValue &value) {
                return value.parent.ends_with(name) && value.isNamed(component) && value.numbers.size() == 1;
            });
            if (one != m_values.end())
                found.push_back(one->numbers.front());
        }
        if (!found.empty() && found.size() == components.size() && found.size() >= count)
            return found;
    }
    return {};
}

} // namespace unprojector::cameras
