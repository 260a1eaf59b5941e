#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace unprojector::mesh::reader {

/// Iterates over the statements of an OBJ file, which end at "#". A backslash at the end of a line
/// joins it with the next. Line ends: LF, CRLF or CR.
class ObjCursor {
public:
    explicit ObjCursor(std::string_view text) : m_begin(text.data()), m_at(m_begin), m_end(m_begin + text.size()) {}

    bool isAtEnd() const { return m_at == m_end; }
    std::size_t offset() const { return static_cast<std::size_t>(m_at - m_begin); }
    /// The number of line ends so far.
    std::size_t linesBefore() const { return m_lines; }

    /// Returns whether the statement has no further word.
    bool isAtStatementEnd();
    /// Moves to the start of the next statement.
    void skipStatement();
    /// The next word, empty at the end of the statement.
    std::string_view word();
    /// The rest of the line, comments included, without blanks at its ends: names may contain
    /// blanks and "#".
    std::string_view restOfLine();
    /// Reads the word as a number, rounded correctly. A number beyond the range of double becomes
    /// infinite or 0. The names that C libraries print for NaN and infinity are read too.
    /// @return false if it is no number; then the word is not consumed
    bool readNumber(double &value);
    /// Reads an integer up to the first character that cannot belong to it. A value beyond 32 bits
    /// becomes some number beyond 32 bits.
    /// @return false if there is none
    bool readInteger(std::int64_t &value);
    /// Consumes the next character if it equals c.
    bool readIf(char c);
    bool isAtWordEnd() const { return isAtWordEnd(m_at); }

private:
    bool isAtWordEnd(const char *at) const;
    const char *afterJoint(const char *backslash) const;
    const char *afterLineEnd(const char *lineEnd) const;

    const char *m_begin;
    const char *m_at;
    const char *m_end;
    std::size_t m_lines = 0;
};

} // namespace unprojector::mesh::reader
