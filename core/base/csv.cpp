#include "core/base/csv.h"

#include "core/base/printable.h"
#include "core/base/translation.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <charconv>

namespace unprojector::base {
namespace {

/// The line-end character: CR in files of old Macintoshes, which have no LF.
char lineEndOf(std::string_view text)
{
    bool isQuoted = false;
    for (const char c : text) {
        if (c == '"')
            isQuoted = !isQuoted;
        else if (c == '\n' && !isQuoted)
            return '\n';
    }
    return text.find('\r') != text.npos ? '\r' : '\n';
}

/// Returns whether a text is a signed number, "-5", "+0.5e-3": a spreadsheet computes the same
/// value from it.
bool isSignedNumber(std::string_view text)
{
    if (text.find_first_not_of("0123456789.eE+-") != text.npos)
        return false;
    text.remove_prefix(1); // from_chars does not accept "+"
    double number = 0.0;
    const char *end = text.data() + text.size();
    return !text.empty() && text.front() != '-' && std::from_chars(text.data(), end, number).ptr == end;
}

/// The row with each quoted cell replaced by one character, for any dialect: separators inside
/// quotes don't separate.
std::string withoutQuotedCells(std::string_view row)
{
    std::string plain;
    bool beginsCell = true;
    for (std::size_t at = 0; at < row.size(); ++at) {
        std::size_t end = row.npos;
        if (beginsCell && row[at] == '"') {
            end = row.find('"', at + 1);
            while (end != row.npos && end + 1 < row.size() && row[end + 1] == '"')
                end = row.find('"', end + 2);
        }
        plain += end == row.npos ? row[at] : 'q';
        beginsCell = std::find(kCsvSeparators.begin(), kCsvSeparators.end(), row[at]) != kCsvSeparators.end();
        if (end != row.npos)
            at = end;
    }
    return plain;
}

/// Returns whether a cell has a decimal comma, "1,5", "-0,25e-3": optional digits, one comma, a
/// digit.
bool hasDecimalComma(std::string_view cell)
{
    const std::size_t comma = cell.find(',');
    return comma != cell.npos && cell.find(',', comma + 1) == cell.npos && comma + 1 < cell.size()
           && cell[comma + 1] >= '0' && cell[comma + 1] <= '9' && cell.find('.') == cell.npos;
}

} // namespace

bool isFormula(std::string_view text)
{
    if (text.empty() || std::string_view("=+-@").find(text.front()) == text.npos)
        return false;
    return !((text.front() == '+' || text.front() == '-') && isSignedNumber(text));
}

bool isQuotedFormula(std::string_view text)
{
    const std::size_t first = text.find_first_not_of('\'');
    return first != 0 && first != text.npos && isFormula(text.substr(first));
}

bool CsvRow::isPadding() const
{
    return std::all_of(cells.begin(), cells.end(),
                       [](const CsvCell &cell) { return cell.text.empty() && !cell.isQuoted; });
}

void CsvRow::trimPadding(std::size_t count)
{
    while (cells.size() > count && cells.back().text.empty() && !cells.back().isQuoted)
        cells.pop_back();
}

CsvReader::CsvReader(std::string_view text, char separator, std::size_t firstLine)
    : m_text(text), m_separator(separator), m_lineEnd(lineEndOf(text)), m_line(firstLine)
{
}

bool CsvReader::isBlank(char c) const
{
    return c == ' ' || c == '\r' || (c == '\t' && m_separator != '\t');
}

bool CsvReader::next()
{
    while (m_at < m_text.size() && !m_error) {
        const std::size_t start = m_at;
        m_row.line = m_line;
        const bool isFilled = readRow();
        std::size_t end = m_at;
        if (m_at < m_text.size() && !m_error) {
            ++m_at;
            ++m_line;
        }
        while (end > start && m_text[end - 1] == '\r')
            --end;
        m_row.source = m_text.substr(start, end - start);
        if (isFilled)
            return true;
    }
    return false;
}

void CsvReader::skipBlanks()
{
    while (!isLineEnd(m_at) && isBlank(m_text[m_at]))
        ++m_at;
}

CsvCell &CsvReader::addCell()
{
    if (m_count == m_row.cells.size())
        m_row.cells.emplace_back();
    CsvCell &cell = m_row.cells[m_count++]; // reuses the memory of the previous row's cell
    cell.text.clear();
    cell.isQuoted = cell.hadBlanks = false;
    return cell;
}

bool CsvReader::readRow()
{
    const bool isRunOfBlanks = m_separator == ' ';
    m_count = 0;
    while (true) {
        const std::size_t start = m_at;
        skipBlanks();
        if (isLineEnd(m_at) && (m_count == 0 || isRunOfBlanks)) { // a blank line, or trailing blanks of a row
            m_row.cells.resize(m_count);
            return m_count > 0;
        }
        CsvCell &cell = addCell();
        if (!isLineEnd(m_at) && m_text[m_at] == '"') {
            if (!readQuoted(cell))
                return false;
        } else {
            const std::size_t first = m_at;
            readPlain(cell);
            cell.hadBlanks = !isRunOfBlanks && !cell.text.empty() && (cell.hadBlanks || first > start);
        }
        if (isLineEnd(m_at)) {
            m_row.cells.resize(m_count);
            return true;
        }
        ++m_at; // the separator
    }
}

void CsvReader::readPlain(CsvCell &cell)
{
    const std::size_t start = m_at;
    const auto isEnd = [this](char c) { return c == m_separator || (m_separator == ' ' && isBlank(c)); };
    while (!isLineEnd(m_at) && !isEnd(m_text[m_at]))
        ++m_at;
    std::size_t end = m_at, lastReturn = m_at;
    while (isLineEnd(m_at) && lastReturn > start && m_text[lastReturn - 1] == '\r')
        --lastReturn; // belongs to the line end, not to the cell
    while (end > start && (isBlank(m_text[end - 1]) || m_text[end - 1] == '\v' || m_text[end - 1] == '\f'))
        --end;
    cell.text.assign(m_text.substr(start, end - start));
    cell.hadBlanks = end < lastReturn;
}

bool CsvReader::readQuoted(CsvCell &cell)
{
    const std::size_t firstLine = m_line;
    cell.isQuoted = true;
    for (++m_at;; ++m_at) {
        if (m_at == m_text.size()) {
            m_error = CsvError{firstLine,
                               tr("a quote is opened here and never closed; close it, or double it within quotes")};
            return false;
        }
        const char c = m_text[m_at];
        if (c == '"' && (m_at + 1 == m_text.size() || m_text[m_at + 1] != '"'))
            break;
        if (c == '"')
            ++m_at;
        else if (c == '\n' || (c == '\r' && (m_at + 1 == m_text.size() || m_text[m_at + 1] != '\n')))
            ++m_line;
        cell.text += c;
    }
    ++m_at;
    const std::size_t behind = m_at;
    skipBlanks();
    if (isLineEnd(m_at) || m_text[m_at] == m_separator)
        return true;
    if (m_separator == ' ' && m_at > behind) {
        --m_at; // one of the blanks is the separator
        return true;
    }
    m_error =
        CsvError{m_line, tr("\"%1\" follows the closing quote; put the whole cell in quotes and double those in it",
                            printableLine(firstCharacters(m_text.substr(m_at), 1)))};
    return false;
}

char csvSeparatorOf(std::string_view row)
{
    char best = kCsvSeparators.front();
    std::size_t most = 1;
    const std::string plain = withoutQuotedCells(row);
    for (const char separator : kCsvSeparators) {
        CsvReader reader(plain, separator);
        const std::size_t count = reader.next() ? reader.row().cells.size() : 0;
        // A header of words with blanks does not make a table separated by blanks.
        if (separator == ' ' ? most == 1 && count > 1 : count > most) {
            most = count;
            best = separator;
        }
    }
    return best;
}

std::optional<char> takeSeparatorLine(std::string_view &text)
{
    constexpr std::string_view kKey = "sep=";
    std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    const std::size_t length = line.size();
    if (line.starts_with('"') && line.ends_with('"') && line.size() > 1)
        line = line.substr(1, line.size() - 2);
    if (!line.starts_with(kKey) || line.size() != kKey.size() + 1)
        return std::nullopt;
    text.remove_prefix(length); // keeps the line end, so that the line count stays right
    return line.back();
}

void DecimalMark::see(std::string_view cell)
{
    m_hasComma = m_hasComma || hasDecimalComma(cell);
    m_hasPoint = m_hasPoint || cell.find('.') != cell.npos;
}

std::string DecimalMark::withPoint(std::string_view cell) const
{
    std::string number(cell);
    if (isComma() && hasDecimalComma(cell))
        number[cell.find(',')] = '.';
    return number;
}

} // namespace unprojector::base
