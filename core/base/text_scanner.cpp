#include "core/base/text_scanner.h"

#include "core/base/printable.h"
#include "core/base/translation.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace unprojector::base {

namespace {

bool isLineEnd(char c)
{
    return c == '\n' || c == '\r';
}

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

} // namespace

void TextScanner::skipLineEnd()
{
    if (m_text[m_offset] == '\r' && m_offset + 1 < m_text.size() && m_text[m_offset + 1] == '\n')
        ++m_offset;
    ++m_offset;
    ++m_line;
}

std::string_view TextScanner::nextWordInLine()
{
    while (m_offset < m_text.size() && isBlank(m_text[m_offset]))
        ++m_offset;
    const std::size_t begin = m_offset;
    while (m_offset < m_text.size() && !isBlank(m_text[m_offset]) && !isLineEnd(m_text[m_offset]))
        ++m_offset;
    return m_text.substr(begin, m_offset - begin);
}

std::string_view TextScanner::nextWord()
{
    for (;;) {
        const std::string_view word = nextWordInLine();
        if (!word.empty() || isAtEnd())
            return word;
        skipLineEnd();
    }
}

void TextScanner::skipLine()
{
    while (m_offset < m_text.size() && !isLineEnd(m_text[m_offset]))
        ++m_offset;
    if (!isAtEnd())
        skipLineEnd();
}

void TextScanner::skipBlankLines()
{
    while (m_offset < m_text.size() && (isBlank(m_text[m_offset]) || isLineEnd(m_text[m_offset]))) {
        if (isBlank(m_text[m_offset]))
            ++m_offset;
        else
            skipLineEnd();
    }
}

std::string_view TextScanner::restOfLine()
{
    while (m_offset < m_text.size() && isBlank(m_text[m_offset]))
        ++m_offset;
    const std::size_t begin = m_offset;
    while (m_offset < m_text.size() && !isLineEnd(m_text[m_offset]))
        ++m_offset;
    std::size_t end = m_offset;
    while (end > begin && isBlank(m_text[end - 1]))
        --end;
    if (!isAtEnd())
        skipLineEnd();
    return m_text.substr(begin, end - begin);
}

std::optional<double> doubleFromWord(std::string_view word)
{
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    double value = 0.0;
    const char *end = word.data() + word.size();
    const std::from_chars_result result = std::from_chars(word.data(), end, value);
    if (result.ec == std::errc::result_out_of_range) {
        // from_chars does not tell overflow from underflow; without an exponent there are hundreds
        // of digits either way.
        const std::size_t exponent = word.find_first_of("eE");
        const std::size_t firstDigit = word.find_first_of("123456789.");
        const bool isTiny = exponent != word.npos && exponent + 1 < word.size()
                                ? word[exponent + 1] == '-'
                                : firstDigit != word.npos && word[firstDigit] == '.';
        value = isTiny ? 0.0 : std::numeric_limits<double>::infinity();
    } else if (result.ec != std::errc()) {
        return std::nullopt;
    }
    if (result.ptr == end)
        return value;
    // Accepts the output of Microsoft's C library for NaN and infinity.
    if (std::string_view(result.ptr, static_cast<std::size_t>(end - result.ptr)).starts_with('#')
        || (result.ptr != word.data() && result.ptr + 1 < end && result.ptr[0] == '.' && result.ptr[1] == '#'))
        return std::numeric_limits<double>::quiet_NaN();
    return std::nullopt;
}

std::optional<float> floatFromWord(std::string_view word)
{
    const std::optional<double> value = doubleFromWord(word);
    return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

std::optional<long long> integerFromWord(std::string_view word)
{
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    long long value = 0;
    const char *end = word.data() + word.size();
    const std::from_chars_result result = std::from_chars(word.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end)
        return std::nullopt;
    return value;
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n\v\f");
    return first == text.npos ? std::string_view()
                              : text.substr(first, text.find_last_not_of(" \t\r\n\v\f") - first + 1);
}

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    for (char &c : lower)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

std::string quoted(std::string_view word)
{
    return base::tr("\"%1\"", base::printableBeginning(word, 40));
}

} // namespace unprojector::base
