#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::text {

// Tables of text: comma-separated values and their dialects.

/// How texts stand in a table's cells.
enum class CellTexts {
    AsTheyAre,
    SpreadsheetSafe ///< behind an apostrophe, where a spreadsheet would take them for formulas
};
/// Whether a spreadsheet takes a text for a formula: it begins with =, +, - or @ and is no number.
bool isFormula(std::string_view text);
/// The same behind any apostrophes, at least one.
bool isQuotedFormula(std::string_view text);

/// What programs put between the cells of a row. A blank stands for any run of blanks and tabs.
inline constexpr std::array kCsvSeparators{',', ';', '\t', ' '};

struct CsvCell {
    std::string text; ///< without its quotes; without quotes, without the blanks around it
    bool isQuoted = false;
    bool hadBlanks = false; ///< around it, and no quotes that keep them
};

struct CsvRow {
    std::vector<CsvCell> cells;
    std::size_t line = 0;    ///< where it begins, counted from 1
    std::string_view source; ///< as it stands in the text, without its line end

    /// Whether it has nothing but separators, as spreadsheets pad a table. A quoted cell is something, even an empty one.
    bool isPadding() const;
    /// Removes padding behind the first `count` cells.
    void trimPadding(std::size_t count);
};

struct CsvError {
    std::size_t line = 0;
    std::string text; ///< what is wrong and what to do
};

/// Reads a text row by row, as RFC 4180 has it, in a dialect.
///
/// - Lines end with LF or CRLF; in a text without LF (outside quotes), with CR. Any other CR outside quotes is a blank.
/// - Blank lines are passed over. A quote inside an unquoted cell is a character like others.
class CsvReader {
public:
    explicit CsvReader(std::string_view text, char separator = ',', std::size_t firstLine = 1);

    /// Moves to the next row.
    /// @return false at the end of the text and at an error
    bool next();
    const CsvRow &row() const { return m_row; }
    CsvRow &row() { return m_row; }
    /// An open quote, or something behind a closed one.
    const std::optional<CsvError> &error() const { return m_error; }

private:
    /// @return false where the row is a blank line, and at an error
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
    std::size_t m_count = 0; ///< of the cells of the row that is being read
    CsvRow m_row;
    std::optional<CsvError> m_error;
};

/// The separator of a table by its first row: the one that gives most cells; of equals, the first of kCsvSeparators. What
/// stands in quotes does not count.
char csvSeparatorOf(std::string_view row);

/// The first line "sep=;", by which spreadsheets say the separator; it is taken off the text.
std::optional<char> takeSeparatorLine(std::string_view &text);

/// The decimal mark of a table's numbers. A comma counts where the separator is another and no number has a point:
/// "1,234.5" is no number, and "1,5" beside "2.5" is a mistake.
class DecimalMark {
public:
    explicit DecimalMark(char separator) : m_mayBeComma(separator != ',') {}

    /// Looks at a cell that should be a number.
    void see(std::string_view cell);
    bool isComma() const { return m_mayBeComma && m_hasComma && !m_hasPoint; }
    /// The cell with a decimal point.
    std::string withPoint(std::string_view cell) const;

private:
    bool m_mayBeComma, m_hasComma = false, m_hasPoint = false;
};

} // namespace unprojector::text
