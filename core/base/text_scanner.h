#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace unprojector::base {

/// Iterates over a text file's words and counts its lines. Line ends: LF, CRLF or CR.
class TextScanner {
public:
    explicit TextScanner(std::string_view text, std::size_t offset = 0, std::size_t line = 1)
        : m_text(text), m_offset(offset), m_line(line)
    {
    }

    /// The next word in the whole text, or empty at its end.
    std::string_view nextWord();
    /// The next word in this line, or empty at the line's end, which stays unread.
    std::string_view nextWordInLine();
    /// Moves to the start of the next line.
    void skipLine();
    /// Moves to the first word of the next non-empty line, past the rest of this line if that is
    /// empty.
    void skipBlankLines();
    /// The rest of the line without blanks at its ends; moves to the start of the next line.
    std::string_view restOfLine();

    bool isAtEnd() const { return m_offset >= m_text.size(); }
    std::size_t offset() const { return m_offset; }
    /// The line of the last word read, counted from 1.
    std::size_t line() const { return m_line; }

private:
    void skipLineEnd();

    std::string_view m_text;
    std::size_t m_offset;
    std::size_t m_line;
};

/// The text without blanks and line ends around it.
std::string_view trimmed(std::string_view text);
std::string lowerCase(std::string_view text);

/// The number that a word represents, rounded correctly and independent of the locale. "nan", "inf"
/// and "1.#IND" count as numbers; values beyond the range of double become infinity or 0. Nothing
/// if the word is not a number.
std::optional<double> doubleFromWord(std::string_view word);
std::optional<float> floatFromWord(std::string_view word);
std::optional<long long> integerFromWord(std::string_view word);

/// A word for a message: quoted, cut at 40 characters, with unprintable characters escaped (see
/// base::printableBeginning).
std::string quoted(std::string_view word);

/// The value of a text that is a number of its type in full, as std::from_chars reads it.
template <class Number>
std::optional<Number> numberIn(std::string_view text)
{
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

} // namespace unprojector::base
