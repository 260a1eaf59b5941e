#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace unprojector::mesh::reader {

/// Walks over the statements of an OBJ file: lines that a backslash at their end joins with the next, up to a "#".
/// Line ends: LF, CRLF or CR.
class ObjCursor {
public:
    explicit ObjCursor(std::string_view text) : m_begin(text.data()), m_at(m_begin), m_end(m_begin + text.size()) {}

    bool isAtEnd() const { return m_at == m_end; }
    std::size_t offset() const { return static_cast<std::size_t>(m_at - m_begin); }
    /// Line ends so far.
    std::size_t linesBefore() const { return m_lines; }

    /// Whether the statement has no further word.
    bool isAtStatementEnd();
    /// Moves to the start of the next statement.
    void skipStatement();
    /// The next word, empty at the statement's end.
    std::string_view word();
    /// The rest of the line without blanks at its ends, comments and all: names may hold both.
    std::string_view restOfLine();
    /// Reads the word as a number, rounded correctly; too large or too small for a double it is infinite or 0, and so
    /// are the names that C libraries print for NaN and infinity. False when it is none; then it stays to be read.
    bool readNumber(double &value);
    /// Reads an integer up to what cannot belong to it; beyond 32 bits it becomes some number beyond 32 bits. False when
    /// there is none.
    bool readInteger(std::int64_t &value);
    /// Reads one character if it is that.
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
