// Detects the format of a table: its separator, its columns, its decimal mark, and the end of its
// rows.

#include "core/landmark_files/csv_table.h"

#include "core/base/text_scanner.h"
#include "core/base/translation.h"

#include <algorithm>
#include <set>
#include <string>

namespace unprojector::landmark_files::csv {
using namespace landmarks;
using base::CsvReader;
using base::CsvRow;
using base::tr;
namespace {

constexpr std::array<Column, 10> kNumberColumns{X, Y, Z, U, V, W, Dx, Dy, Dz, EdgeShare};

/// Removes apostrophes that keep spreadsheets from taking texts for formulas.
/// @return number of apostrophes removed
std::size_t takeApostrophesOff(CsvRow &row)
{
    std::size_t count = 0;
    for (base::CsvCell &cell : row.cells) {
        const bool isQuoted = base::isQuotedFormula(cell.text);
        cell.text.remove_prefix(isQuoted ? 1 : 0);
        count += isQuoted ? 1 : 0;
    }
    return count;
}

bool hasAll(const CsvRow &row, const std::array<const char *, 3> &names)
{
    return std::all_of(names.begin(), names.end(),
                       [&](const char *name) { return row.column(name) < row.cells.size(); });
}

constexpr std::array kPlain{"x", "y", "z"}, kLps{"l", "p", "s"}, kRas{"r", "a", "s"};

bool isHeader(const CsvRow &row)
{
    return hasAll(row, kPlain) || hasAll(row, kLps) || hasAll(row, kRas);
}

/// Assigns the columns that 3D Slicer's table names differently.
void takeSlicerColumns(Header &header, const CsvRow &row)
{
    header.axes = hasAll(row, kLps) ? Axes::Lps : Axes::Ras;
    for (std::size_t i = 0; i < kLps.size(); ++i)
        header.places[X + i] = row.column((header.axes == Axes::Lps ? kLps : kRas)[i]);
    for (const auto &[column, name] :
         {std::pair(Name, "label"), std::pair(Note, "description"), std::pair(Defined, "defined"),
          std::pair(Visible, "visible"), std::pair(Selected, "selected"), std::pair(Locked, "locked")}) {
        if (!header.has(column))
            header.places[column] = row.column(name);
    }
}

Header headerOf(const CsvRow &row)
{
    Header header;
    header.count = row.cells.size();
    header.places.fill(header.count);
    std::copy(kColumnNames.begin(), kColumnNames.end(), header.titles.begin());
    std::set<std::string> names;
    for (std::size_t i = 0; i < header.count; ++i) {
        const std::string text(row.cells[i].text);
        const std::size_t known = columnOf(text);
        if (!trimmed(text).empty() && !names.insert(known < kWrittenCount ? kColumnNames[known] : text).second)
            fail(row.line, tr("the column \"%1\" is there twice; rename one of them", text));
        if (known < kWrittenCount)
            header.places[known] = i;
    }
    if (!hasAll(row, kPlain) && (hasAll(row, kLps) || hasAll(row, kRas)))
        takeSlicerColumns(header, row);
    // A column of that name without the other curve columns belongs to another program.
    if (!header.has(CurvePoints) && !header.has(CurveWay) && !header.has(CurveCount))
        header.places[CurveName] = header.count;
    for (const char *name : {"label", "landmark", "point", "marker"}) { // synonyms of "name"
        if (!header.has(Name))
            header.places[Name] = row.column(name);
    }
    for (std::size_t i = 0; i < header.count; ++i) {
        const auto known = std::find(header.places.begin(), header.places.end(), i);
        if (known == header.places.end())
            header.others.emplace_back(i, row.cells[i].text);
        else
            header.titles[static_cast<std::size_t>(known - header.places.begin())] = row.cells[i].text;
    }
    return header;
}

/// Removes the slashes of CloudCompare's first line "//X Y Z".
void takeSlashesOff(CsvRow &row)
{
    std::string_view &cell = row.cells.front().text;
    if (cell.starts_with("//"))
        cell.remove_prefix(std::min(cell.find_first_not_of(" \t", 2), cell.size()));
}

bool isNumber(std::string_view cell, const base::DecimalMark &mark)
{
    return base::doubleFromWord(mark.withPoint(cell)).has_value();
}

bool isWholeNumber(std::string_view cell)
{
    return !cell.empty() && cell.find_first_not_of("0123456789") == cell.npos;
}

/// The columns of a table without a header: a name and three numbers, or three numbers. Four
/// numbers count as a name and three only if the first are whole and some of the others are not, or if
/// the first count the rows from 0, as CloudCompare does; otherwise the fourth may be a scanner's measurement.
/// @return empty if the rows have another form
std::optional<Header> guessedHeader(std::string_view text, char separator)
{
    base::DecimalMark mark(separator);
    for (CsvReader reader(text, separator); reader.next();) {
        for (const base::CsvCell &cell : reader.row().cells)
            mark.see(cell.text);
    }
    std::size_t count = 0;
    bool hasNames = false, allWhole = true, firstsWhole = true, firstsCount = true;
    std::size_t rows = 0;
    for (CsvReader reader(text, separator); reader.next();) {
        CsvRow &row = reader.row();
        if (row.isPadding())
            continue;
        row.trimPadding(count == 0 ? 3 : count);
        if (count == 0)
            count = row.cells.size();
        if (row.cells.size() != count || count < 3 || count > 4)
            return std::nullopt;
        for (std::size_t i = count - 3; i < count; ++i) {
            const std::string_view cell = row.cells[i].text;
            if (!isNumber(cell, mark))
                return std::nullopt;
            allWhole = allWhole && isWholeNumber(cell.substr(cell.starts_with('-') ? 1 : 0));
        }
        if (count == 4) {
            hasNames = hasNames || !isNumber(row.cells[0].text, mark);
            firstsWhole = firstsWhole && isWholeNumber(row.cells[0].text);
            firstsCount = firstsCount && row.cells[0].text == std::to_string(rows);
        }
        ++rows;
    }
    if (count == 0 || (count == 4 && !hasNames && (!firstsWhole || (allWhole && (!firstsCount || rows < 2)))))
        return std::nullopt;
    Header header;
    header.count = count;
    header.places.fill(count);
    header.isGuessed = true;
    if (count == 4)
        header.places[Name] = 0;
    for (std::size_t i = 0; i < kPlain.size(); ++i) {
        header.places[X + i] = count - kPlain.size() + i;
        header.titles[X + i] = kPlain[i];
    }
    return header;
}

} // namespace

std::size_t columnOf(std::string_view name)
{
    const auto is = [name = lowerCase(trimmed(name))](const char *known) { return lowerCase(known) == name; };
    return static_cast<std::size_t>(std::find_if(kColumnNames.begin(), kColumnNames.end(), is) - kColumnNames.begin());
}

void Table::readHeader(std::optional<char> separator)
{
    const std::string candidates =
        separator ? std::string(1, *separator) : std::string(base::kCsvSeparators.begin(), base::kCsvSeparators.end());
    std::optional<std::string_view> first;
    std::optional<base::CsvError> error; ///< with another separator the quotes may be valid
    for (const char candidate : candidates) {
        m_reader = CsvReader(m_text, candidate);
        if (!m_reader.next()) {
            error = error ? error : m_reader.error();
            continue;
        }
        if (!first)
            first = m_reader.row().source;
        takeSlashesOff(m_reader.row());
        if (isHeader(m_reader.row())) {
            static_cast<void>(takeApostrophesOff(m_reader.row()));
            m_separator = candidate;
            m_header = headerOf(m_reader.row());
            return;
        }
    }
    if (!first && !error)
        fail(1, tr("the file is empty; the first line names the columns, name,x,y,z at least"));
    for (std::size_t i = 0; first && i < candidates.size(); ++i) {
        if (std::optional<Header> guessed = guessedHeader(m_text, candidates[i])) {
            m_separator = candidates[i];
            m_header = std::move(*guessed);
            return;
        }
    }
    if (error)
        fail(error->line, error->text);
    m_reader = CsvReader(m_text, separator.value_or(base::csvSeparatorOf(*first)));
    static_cast<void>(m_reader.next());
    for (const char *name : kPlain) {
        if (m_reader.row().column(name) == m_reader.row().cells.size())
            fail(m_reader.row().line,
                 tr("there is no column %1; the first line names the columns, name,x,y,z at least", name));
    }
}

/// Moves before the first row.
void Table::rewind()
{
    m_reader = CsvReader(m_text, m_separator);
    m_read = m_apostrophes = 0;
    if (!m_header.isGuessed)
        static_cast<void>(m_reader.next());
}

/// Finds the last row that is no padding, and an unnamed first column.
void Table::survey()
{
    bool isEachOneLonger = true, areFirstsWhole = true;
    std::size_t count = 0;
    for (rewind(); m_reader.next();) {
        CsvRow &row = m_reader.row();
        ++count;
        row.trimPadding(m_header.count);
        if (row.isPadding())
            continue;
        m_rowCount = count;
        isEachOneLonger = isEachOneLonger && row.cells.size() == m_header.count + 1;
        areFirstsWhole = areFirstsWhole && isWholeNumber(row.text(0));
    }
    if (m_reader.error())
        fail(m_reader.error()->line, m_reader.error()->text);
    m_paddingCount = count - m_rowCount;
    // A surplus comma in a table with commas, as in "Smith, John", would shift the names.
    const bool mayShift = m_separator == '\t' || m_separator == ' ';
    if (mayShift && m_rowCount > 0 && isEachOneLonger && !m_header.isGuessed) {
        for (std::size_t &index : m_header.places)
            ++index;
        for (auto &[place, name] : m_header.others)
            ++place;
        m_header.others.emplace(m_header.others.begin(), 0, std::string());
        ++m_header.count;
    }
    if (!m_header.others.empty() && m_header.others.front() == std::pair(std::size_t{0}, std::string())) {
        m_header.others.erase(m_header.others.begin());
        // Row numbers in a table of several specimens are not names, because each specimen's begin
        // with another number.
        if (!m_header.has(Name) && !(m_header.has(Specimen) && areFirstsWhole))
            m_header.places[Name] = 0;
        else
            m_header.rowNames = 0;
    }
}

Table::Table(std::string_view text)
{
    const std::optional<char> separator = base::takeSeparatorLine(text);
    m_text = text;
    readHeader(separator);
    survey();
    m_mark = base::DecimalMark(m_separator);
    for (rewind(); next();) {
        for (const Column column : kNumberColumns) {
            if (m_header.has(column))
                m_mark.see(row().text(m_header.places[column]));
        }
    }
    rewind();
}

bool Table::next()
{
    if (m_read == m_rowCount || !m_reader.next())
        return false;
    ++m_read;
    CsvRow &row = m_reader.row();
    row.trimPadding(m_header.count);
    m_apostrophes += takeApostrophesOff(row);
    const std::size_t cells = row.cells.size();
    if (cells != m_header.count)
        fail(row.line, tr(cells > m_header.count
                              ? "this row has %1 cells, and the first line names %2 columns; put a cell that has the "
                                "separator in it in quotes"
                              : "this row has fewer cells (%1) than the first line names columns (%2); leave cells "
                                "without a value empty",
                          cells, m_header.count));
    return true;
}

} // namespace unprojector::landmark_files::csv
