#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::base {

// Tables of text: comma-separated values and their dialects.

/// The protection of texts in a table's cells.
enum class CellTexts {
    Verbatim, ///< as they are
    ReadBack, ///< as this program's reader of landmarks, which removes an apostrophe before a formula, gets them back
    SpreadsheetSafe ///< after an apostrophe if a spreadsheet would take them for formulas
};
/// Returns whether a text is a formula after one or more apostrophes.
bool isQuotedFormula(std::string_view text);

/// The separators between the cells of a row. A blank stands for any run of blanks and tabs.
inline constexpr std::array kCsvSeparators{',', ';', '\t', ' '};

/// A cell, valid until the reader moves.
struct CsvCell {
    std::string_view text;   ///< without its quotes; an unquoted text is trimmed
    std::string_view source; ///< as it stands in the row
    bool isQuoted = false;
    bool hadBlanks = false; ///< trimmed blanks that no quotes protect

    /// Returns whether nothing is written: a quoted cell counts as content, even an empty one.
    bool isBlank() const { return text.empty() && !isQuoted; }
};

struct CsvRow {
    std::vector<CsvCell> cells;
    std::size_t line = 0;    ///< the line on which it begins, counted from 1
    std::string_view source; ///< the row's text without its line end

    /// Returns whether it has only separators, as spreadsheets pad a table.
    bool isPadding() const;
    /// Removes padding after the first `count` cells.
    void trimPadding(std::size_t count);
    /// The index of the first cell from `from` on with a name in any case; the number of cells if there
    /// is none.
    std::size_t column(std::string_view name, std::size_t from = 0) const;
    /// The text of a cell; empty where the row is shorter.
    std::string_view text(std::size_t index) const;
};

struct CsvError {
    std::size_t line = 0;
    std::size_t cell = 0; ///< index of the cell with the quote
    bool isOpen = false;  ///< more text could close the quote
    std::string text;     ///< the problem and the remedy
};

/// Reads a text row by row according to RFC 4180, in a dialect:
///
/// - Lines end with LF or CRLF; in a text without LF (outside quotes), with CR. Any other CR
///   outside quotes is a blank.
/// - Blank lines are skipped. A quote inside an unquoted cell is an ordinary character.
class CsvReader {
public:
    explicit CsvReader(std::string_view text, char separator = ',');
    /// @param lineEnd  LF or CR
    CsvReader(std::string_view text, char separator, char lineEnd)
        : m_text(text), m_separator(separator), m_lineEnd(lineEnd)
    {
    }

    /// Moves to the next row that is not blank.
    /// @return false at the end of the text and at an error
    bool next();
    const CsvRow &row() const { return m_row; }
    CsvRow &row() { return m_row; }
    /// The row's error: an open quote, or characters after a closed one.
    const std::optional<CsvError> &error() const { return m_error; }

    /// Moves to the next row, also if it is blank or wrong, and leaves its cells to split(). Only the first
    /// line of a row with an error is the row.
    /// @return false at the end of the text
    bool nextSource();
    /// Splits the row's source into its cells. Wrong quotes are part of the text.
    void split();
    /// The number of bytes up to the end of the row, with its line end.
    std::size_t offset() const { return m_next; }
    /// Returns whether more text would not change the row: it has a line end, and no quote is open.
    bool isWhole() const { return !(m_error && m_error->isOpen) && m_text[m_next - 1] == m_lineEnd; }

private:
    std::size_t endWithQuotes(std::size_t start, std::size_t lineEnd);
    std::size_t behindBlanks(std::string_view text, std::size_t at) const;
    bool isBlank(char c) const { return c == ' ' || c == '\r' || (c == '\t' && m_separator != '\t'); }
    bool isSeparator(char c) const { return c == m_separator || (m_separator == ' ' && isBlank(c)); }

    std::string_view m_text;
    char m_separator, m_lineEnd;
    std::size_t m_next = 0, m_line = 1; ///< of the next row
    CsvRow m_row;
    std::string m_unescaped; ///< the row's texts with quotes in them
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

/// A text as JSON, in quotes. Invalid UTF-8 is replaced.
std::string jsonText(std::string_view text);

/// Writes rows, cell by cell: comma-separated values, or one JSON object per line.
class RowWriter {
public:
    /// @param keys  of a JSON object, escaped; none: comma-separated values
    explicit RowWriter(std::string &output, CellTexts texts = CellTexts::Verbatim,
                       const std::vector<std::string> &keys = {});

    bool isJson() const { return m_isJson; }
    /// Writes the fewest digits that read back to the number.
    void number(double value)
    {
        startCell();
        std::array<char, 32> cell; // with its comma, for one call of append
        const auto end = std::to_chars(cell.data(), cell.data() + cell.size() - 1, value).ptr;
        *end = ',';
        m_output.append(cell.data(), static_cast<std::size_t>(end - cell.data()) + 1);
    }
    /// Writes a number; an empty cell for NaN and infinity.
    void numberOrNothing(double value)
    {
        if (std::isfinite(value))
            number(value);
        else
            nothing();
    }
    void numberOr(std::string_view none, const std::optional<double> &value)
    {
        if (value)
            number(*value);
        else
            plain(none);
    }
    /// Writes an empty cell; null in JSON.
    void nothing() { plain(m_isJson ? "null" : ""); }
    /// Writes a text that needs no quotes.
    void plain(std::string_view text)
    {
        startCell();
        m_output += text;
        m_output += ',';
    }
    /// Writes a text of any characters, in quotes where it needs them: without quotes NA means missing.
    void text(std::string_view text);
    /// Copies a cell of the input. In JSON it is a number where it is written as one, null where it is
    /// empty, else a text.
    void passed(const CsvCell &cell);
    /// Copies a cell of the input where a number is expected: in JSON null where it is none.
    void passedNumber(const CsvCell &cell);

    /// Ends a row, which has a cell at least.
    void endRow()
    {
        m_output.back() = m_isJson ? '}' : '\n';
        if (m_isJson)
            m_output += '\n';
        m_column = 0;
    }

private:
    void startCell()
    {
        if (m_isJson)
            m_output += m_keys[m_column++];
    }

    std::string &m_output;
    CellTexts m_texts;
    bool m_isJson;
    std::vector<std::string> m_keys; ///< with their signs: "key":
    std::size_t m_column = 0;
};

} // namespace unprojector::base
