#include "core/base/csv.h"

#include "core/base/json.h"
#include "core/base/printable.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/base/utf8.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <utility>

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

/// The closing quote of a cell; npos if it stays open. Doubled quotes are part of the text.
std::size_t closingQuote(std::string_view text, std::size_t opening)
{
    std::size_t quote = text.find('"', opening + 1);
    while (quote != text.npos && quote + 1 < text.size() && text[quote + 1] == '"')
        quote = text.find('"', quote + 2);
    return quote;
}

/// The row with each quoted cell replaced by one character, for any dialect: separators inside
/// quotes don't separate.
std::string withoutQuotedCells(std::string_view row)
{
    std::string plain;
    bool beginsCell = true;
    for (std::size_t at = 0; at < row.size(); ++at) {
        const std::size_t quote = beginsCell && row[at] == '"' ? closingQuote(row, at) : row.npos;
        plain += quote == row.npos ? row[at] : 'q';
        beginsCell = std::find(kCsvSeparators.begin(), kCsvSeparators.end(), row[at]) != kCsvSeparators.end();
        at = quote == row.npos ? at : quote;
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

/// Returns whether a spreadsheet takes a text for a formula: it begins with =, +, - or @ and is no
/// number.
bool isFormula(std::string_view text)
{
    if (text.empty() || std::string_view("=+-@").find(text.front()) == text.npos)
        return false;
    return !((text.front() == '+' || text.front() == '-') && isSignedNumber(text));
}

void appendQuoted(std::string &output, std::string_view text, std::string_view apostrophe = {})
{
    output.append("\"").append(apostrophe);
    for (const char c : text)
        output.append(c == '"' ? 2 : 1, c);
    output += '"';
}

} // namespace

bool isQuotedFormula(std::string_view text)
{
    const std::size_t first = text.find_first_not_of('\'');
    return first != 0 && first != text.npos && isFormula(text.substr(first));
}

bool CsvRow::isPadding() const
{
    return std::all_of(cells.begin(), cells.end(), [](const CsvCell &cell) { return cell.isBlank(); });
}

void CsvRow::trimPadding(std::size_t count)
{
    while (cells.size() > count && cells.back().isBlank())
        cells.pop_back();
}

std::size_t CsvRow::column(std::string_view name, std::size_t from) const
{
    while (from < cells.size() && lowerCase(trimmed(cells[from].text)) != name)
        ++from;
    return from;
}

std::string_view CsvRow::text(std::size_t index) const
{
    return index < cells.size() ? cells[index].text : std::string_view();
}

CsvReader::CsvReader(std::string_view text, char separator) : CsvReader(text, separator, lineEndOf(text)) {}

bool CsvReader::next()
{
    while (!m_error && nextSource()) {
        split();
        if (!m_error && !m_row.cells.empty())
            return true;
    }
    return false;
}

bool CsvReader::nextSource()
{
    m_error.reset();
    m_row.cells.clear();
    m_row.line = m_line;
    const std::size_t start = m_next;
    std::size_t end = std::min(m_text.find(m_lineEnd, start), m_text.size());
    m_row.source = m_text.substr(start, end - start);
    if (m_row.source.find('"') != m_text.npos) { // most tables have none
        end = endWithQuotes(start, end);
        m_row.source = m_text.substr(start, end - start);
        m_line += static_cast<std::size_t>(std::count(m_row.source.begin(), m_row.source.end(), m_lineEnd));
    }
    ++m_line;
    m_next = std::min(end + 1, m_text.size());
    while (m_row.source.ends_with('\r'))
        m_row.source.remove_suffix(1);
    return start < m_text.size();
}

std::size_t CsvReader::behindBlanks(std::string_view text, std::size_t at) const
{
    while (at < text.size() && text[at] != m_lineEnd && isBlank(text[at]))
        ++at;
    return at;
}

/// The end of a row; that of its first line if its quotes are wrong.
std::size_t CsvReader::endWithQuotes(std::size_t start, std::size_t lineEnd)
{
    std::size_t at = start;
    const auto failed = [&](std::size_t place, std::size_t cell, bool isOpen, std::string text) {
        const auto before = m_text.substr(start, place - start);
        m_error = CsvError{m_line + static_cast<std::size_t>(std::count(before.begin(), before.end(), m_lineEnd)), cell,
                           isOpen, std::move(text)};
        return lineEnd;
    };
    for (std::size_t cell = 0;; ++cell, ++at) {
        at = behindBlanks(m_text, at);
        if (at < m_text.size() && m_text[at] == '"') {
            const std::size_t quote = closingQuote(m_text, at);
            if (quote == m_text.npos)
                return failed(at, cell, true,
                              tr("a quote is opened here and never closed; close it, or double it within quotes"));
            at = behindBlanks(m_text, quote + 1);
            const bool isBehindBlank = m_separator == ' ' && at > quote + 1; // one of the blanks is the separator
            if (at < m_text.size() && m_text[at] != m_lineEnd && !isSeparator(m_text[at]) && !isBehindBlank)
                return failed(
                    at, cell, false,
                    tr("\"%1\" follows the closing quote; put the whole cell in quotes and double those in it",
                       printableLine(firstCharacters(m_text.substr(at), 1))));
            if (isBehindBlank)
                at = quote + 1;
        }
        while (at < m_text.size() && m_text[at] != m_lineEnd && !isSeparator(m_text[at]))
            ++at;
        if (at == m_text.size() || m_text[at] == m_lineEnd)
            return at;
    }
}

void CsvReader::split()
{
    const std::string_view row = m_row.source;
    m_row.cells.clear();
    m_unescaped.clear();
    for (std::size_t start = 0;;) {
        const std::size_t first = behindBlanks(row, start);
        if (first == row.size() && (m_row.cells.empty() || m_separator == ' '))
            return; // a blank line, or trailing blanks of a row
        CsvCell &cell = m_row.cells.emplace_back();
        const std::size_t quote = first < row.size() && row[first] == '"' ? closingQuote(row, first) : row.npos;
        const std::size_t from = quote == row.npos ? first : quote + 1;
        const std::size_t end =
            std::min(m_separator == ' ' ? row.find_first_of(" \t\r", from) : row.find(m_separator, from), row.size());
        cell.source = row.substr(start, end - start);
        cell.isQuoted = quote != row.npos && behindBlanks(row.substr(0, end), quote + 1) == end;
        if (cell.isQuoted) {
            cell.text = row.substr(first + 1, quote - first - 1);
            if (cell.text.find('"') != row.npos) {
                m_unescaped.reserve(row.size()); // the texts before stay where they are
                const std::size_t begin = m_unescaped.size();
                for (std::size_t i = 0; i < cell.text.size(); i += cell.text[i] == '"' ? 2u : 1u)
                    m_unescaped += cell.text[i];
                cell.text = std::string_view(m_unescaped).substr(begin);
            }
        } else {
            cell.text = row.substr(first, end - first);
            while (!cell.text.empty()
                   && (isBlank(cell.text.back()) || cell.text.ends_with('\v') || cell.text.ends_with('\f')))
                cell.text.remove_suffix(1);
            cell.hadBlanks = m_separator != ' ' && !cell.text.empty() && cell.text.size() < cell.source.size();
        }
        if (end == row.size())
            return;
        start = end + 1;
    }
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

std::string jsonText(std::string_view text)
{
    return compactJson(text);
}

RowWriter::RowWriter(std::string &output, CellTexts texts, const std::vector<std::string> &keys)
    : m_output(output), m_texts(texts), m_isJson(!keys.empty())
{
    for (const std::string &key : keys)
        m_keys.push_back((m_keys.empty() ? "{\"" : "\"") + key + "\":");
}

void RowWriter::text(std::string_view text)
{
    if (m_isJson)
        return plain(jsonText(text));
    const bool isGuarded = (m_texts == CellTexts::SpreadsheetSafe && isFormula(text))
                           || (m_texts != CellTexts::Verbatim && isQuotedFormula(text));
    const char *apostrophe = isGuarded ? "'" : "";
    if (text.find_first_of(",\"\r\n") == text.npos && trimmed(text).size() == text.size() && text != "NA"
        && text != "#N/A")
        m_output.append(apostrophe).append(text);
    else
        appendQuoted(m_output, text, apostrophe);
    m_output += ',';
}

void RowWriter::passed(const CsvCell &cell)
{
    if (m_isJson)
        return cell.isQuoted             ? text(cell.text)
               : cell.text.empty()       ? nothing()
               : isJsonNumber(cell.text) ? plain(cell.text)
                                         : text(cell.source);
    const std::size_t start = m_output.size();
    if (!cell.isQuoted && cell.text.starts_with('"')) // an open quote would swallow the cells behind it
        appendQuoted(m_output, cell.source);
    else
        m_output += cell.source;
    if (m_texts == CellTexts::SpreadsheetSafe && isFormula(trimmed(cell.text)))
        m_output.insert(m_output.find_first_not_of(" \t\"", start), 1, '\'');
    m_output += ',';
}

void RowWriter::passedNumber(const CsvCell &cell)
{
    if (!m_isJson)
        passed(cell);
    else if (const std::string_view number = trimmed(cell.text); isJsonNumber(number))
        plain(number);
    else
        nothing();
}

} // namespace unprojector::base
