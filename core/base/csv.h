#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::base {

// Tables of text: comma-separated values and their dialects.

/// The protection of texts in a table's cells.
enum class CellTexts {
    AsTheyAre,
    SpreadsheetSafe ///< after an apostrophe if a spreadsheet would take them for formulas
};
/// Returns whether a spreadsheet takes a text for a formula: it begins with =, +, - or @ and is no
/// number.
bool isFormula(std::string_view text);
/// Returns whether a text is a formula after one or more apostrophes.
bool isQuotedFormula(std::string_view text);

/// The separators between the cells of a row. A blank stands for any run of blanks and tabs.
inline constexpr std::array kCsvSeparators{',', ';', '\t', ' '};

struct CsvCell {
    std::string text; ///< without its quotes; an unquoted text is trimmed
    bool isQuoted = false;
    bool hadBlanks = false; ///< trimmed blanks that no quotes protect
};

struct CsvRow {
    std::vector<CsvCell> cells;
    std::size_t line = 0;    ///< the line on which it begins, counted from 1
    std::string_view source; ///< the row's text without its line end

    /// Returns whether it has only separators, as spreadsheets pad a table. A quoted cell counts as
    /// content, even an empty one.
    bool isPadding() const;
    /// Removes padding after the first `count` cells.
    void trimPadding(std::size_t count);
};

struct CsvError {
    std::size_t line = 0;
    std::string text; ///< the problem and the remedy
};

/// Reads a text row by row according to RFC 4180, in a dialect:
///
/// - Lines end with LF or CRLF; in a text without LF (outside quotes), with CR. Any other CR
///   outside quotes is a blank.
/// - Blank lines are skipped. A quote inside an unquoted cell is an ordinary character.
class CsvReader {
public:
    explicit CsvReader(std::string_view text, char separator = ',', std::size_t firstLine = 1);

    /// Moves to the next row.
    /// @return false at the end of the text and at an error
    bool next();
    const CsvRow &row() const { return m_row; }
    CsvRow &row() { return m_row; }
    /// The error: an open quote, or characters after a closed one.
    const std::optional<CsvError> &error() const { return m_error; }

private:
    /// @return false if the row is a blank line, and at an error
    bool readRow();
    void skipBlanks();
    void readPlain(CsvCell &cell);
    bool readQuoted(CsvCell &cell);
    bool isLineEnd(std::size_t at) const { return at == m_text.size() || m_text[at] == m_lineEnd; }
    bool isBlank(char c) const;
    CsvCell &addCell();

    std::string_view m_text;
    char m_separator, m_lineEnd;
    std::size_t m_at = 0, m_line;
    std::size_t m_count = 0; ///< of the cells of the current row
    CsvRow m_row;
    std::optional<CsvError> m_error;
};

/// The separator of a table, derived from its first row: the one that gives most cells; of equals,
/// the first of kCsvSeparators. Quoted characters are ignored.
char csvSeparatorOf(std::string_view row);

/// Removes the first line "sep=;", with which spreadsheets declare the separator, from the text.
/// Returns that separator.
std::optional<char> takeSeparatorLine(std::string_view &text);

/// The decimal mark of a table's numbers. A comma is one only if the separator differs and no
/// number has a point: "1,234.5" is no number, and "1,5" beside "2.5" is a mistake.
class DecimalMark {
public:
    explicit DecimalMark(char separator) : m_mayBeComma(separator != ',') {}

    /// Records the mark of a cell that should be a number.
    void see(std::string_view cell);
    bool isComma() const { return m_mayBeComma && m_hasComma && !m_hasPoint; }
    /// The cell with a decimal point.
    std::string withPoint(std::string_view cell) const;

private:
    bool m_mayBeComma, m_hasComma = false, m_hasPoint = false;
};

} // namespace unprojector::base
