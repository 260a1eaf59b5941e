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

[[noreturn]] void fail(const base::CsvError &error)
{
    throw Failure{error.line, error.text};
}

/// Removes apostrophes that keep spreadsheets from taking texts for formulas.
/// @return number of apostrophes removed
std::size_t takeApostrophesOff(CsvRow &row)
{
    std::size_t count = 0;
    for (base::CsvCell &cell : row.cells) {
        if (!base::isQuotedFormula(cell.text))
            continue;
        cell.text.erase(0, 1);
        ++count;
    }
    return count;
}

std::string nameOfCell(const base::CsvCell &cell)
{
    return lowerCase(trimmed(cell.text));
}

std::size_t placeOf(const CsvRow &row, std::string_view name)
{
    const auto found =
        std::find_if(row.cells.begin(), row.cells.end(), [&](const auto &cell) { return nameOfCell(cell) == name; });
    return found == row.cells.end() ? Header::npos : static_cast<std::size_t>(found - row.cells.begin());
}

bool hasAll(const CsvRow &row, const std::array<const char *, 3> &names)
{
    return std::all_of(names.begin(), names.end(),
                       [&](const char *name) { return placeOf(row, name) != Header::npos; });
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
    const std::array<const char *, 3> &axes = header.axes == Axes::Lps ? kLps : kRas;
    for (std::size_t i = 0; i < axes.size(); ++i)
        header.places[X + i] = placeOf(row, axes[i]);
    for (const auto &[column, name] :
         {std::pair(Name, "label"), std::pair(Note, "description"), std::pair(Defined, "defined"),
          std::pair(Visible, "visible"), std::pair(Selected, "selected"), std::pair(Locked, "locked")}) {
        if (!header.has(column))
            header.places[column] = placeOf(row, name);
    }
}

Header headerOf(const CsvRow &row)
{
    Header header;
    header.places.fill(Header::npos);
    std::copy(kColumnNames.begin(), kColumnNames.end(), header.titles.begin());
    header.count = row.cells.size();
    std::set<std::string> names;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const std::string name = nameOfCell(row.cells[i]);
        const auto known = std::find(kColumnNames.begin(), kColumnNames.end(), name);
        if (!name.empty() && !names.insert(known != kColumnNames.end() ? name : row.cells[i].text).second)
            throw Failure{row.line, tr("the column \"%1\" is there twice; rename one of them", row.cells[i].text)};
        if (known != kColumnNames.end())
            header.places[static_cast<std::size_t>(known - kColumnNames.begin())] = i;
    }
    if (!hasAll(row, kPlain) && (hasAll(row, kLps) || hasAll(row, kRas)))
        takeSlicerColumns(header, row);
    // A column of that name without the other curve columns belongs to another program.
    if (!header.has(CurvePoints) && !header.has(CurveWay) && !header.has(CurveCount))
        header.places[CurveName] = Header::npos;
    for (const char *name : {"label", "landmark", "point", "marker"}) { // synonyms of "name"
        if (!header.has(Name))
            header.places[Name] = placeOf(row, name);
    }
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
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
    std::string &cell = row.cells.front().text;
    if (cell.starts_with("//"))
        cell.erase(0, std::min(cell.find_first_not_of(" \t", 2), cell.size()));
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
            const std::string &cell = row.cells[i].text;
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
    header.places.fill(Header::npos);
    header.count = count;
    header.isGuessed = true;
    if (count == 4)
        header.places[Name] = 0;
    for (std::size_t i = 0; i < kPlain.size(); ++i) {
        header.places[X + i] = count - kPlain.size() + i;
        header.titles[X + i] = kPlain[i];
    }
    return header;
}

/// Finds the separator and the columns.
void readHeader(Table &table, std::optional<char> separator)
{
    std::optional<CsvRow> first;
    std::optional<base::CsvError> error; ///< with another separator the quotes may be valid
    for (const char candidate : base::kCsvSeparators) {
        CsvReader reader(table.text, candidate);
        if (separator.value_or(candidate) != candidate)
            continue;
        if (!reader.next()) {
            error = error ? error : reader.error();
            continue;
        }
        if (!first)
            first = reader.row();
        takeSlashesOff(reader.row());
        if (isHeader(reader.row())) {
            static_cast<void>(takeApostrophesOff(reader.row()));
            table.separator = candidate;
            table.header = headerOf(reader.row());
            return;
        }
    }
    if (!first && error)
        fail(*error);
    if (!first)
        throw Failure{1, tr("the file is empty; the first line names the columns, name,x,y,z at least")};
    for (const char candidate : base::kCsvSeparators) {
        if (separator.value_or(candidate) != candidate)
            continue;
        if (std::optional<Header> guessed = guessedHeader(table.text, candidate)) {
            table.separator = candidate;
            table.header = std::move(*guessed);
            return;
        }
    }
    table.separator = separator.value_or(base::csvSeparatorOf(first->source));
    if (error)
        fail(*error);
    CsvReader reader(table.text, table.separator);
    static_cast<void>(reader.next());
    for (const char *name : kPlain) {
        if (placeOf(reader.row(), name) == Header::npos)
            throw Failure{first->line,
                          tr("there is no column %1; the first line names the columns, name,x,y,z at least", name)};
    }
}

/// Adds an unnamed column before all others.
void shift(Header &header)
{
    for (std::size_t &index : header.places)
        index += index == Header::npos ? 0 : 1;
    for (auto &[place, name] : header.others)
        ++place;
    header.others.emplace(header.others.begin(), 0, std::string());
    ++header.count;
}

/// Properties of all rows of a table.
struct Survey {
    std::size_t rows = 0, filledRows = 0; ///< filledRows: up to the last row that is no padding
    bool isEachOneLonger = true, areFirstsWhole = true;
};

Survey surveyOf(Table &table)
{
    Survey survey;
    Header &header = table.header;
    CsvReader reader(table.text, table.separator);
    if (!header.isGuessed)
        static_cast<void>(reader.next());
    while (reader.next()) {
        CsvRow &row = reader.row();
        ++survey.rows;
        row.trimPadding(header.count);
        if (row.isPadding())
            continue;
        survey.filledRows = survey.rows;
        survey.isEachOneLonger = survey.isEachOneLonger && row.cells.size() == header.count + 1;
        survey.areFirstsWhole = survey.areFirstsWhole && isWholeNumber(row.cells.front().text);
    }
    if (reader.error())
        fail(*reader.error());
    return survey;
}

/// Examines the numbers, now that every column is known.
void seeNumbers(Table &table)
{
    table.mark = base::DecimalMark(table.separator);
    for (TableRows rows(table); rows.next();) {
        for (const Column column : kNumberColumns) {
            if (table.header.has(column))
                table.mark.see(rows.row().cells[table.header.places[column]].text);
        }
    }
}

} // namespace

Table tableOf(std::string_view text)
{
    Table table;
    const std::optional<char> separator = base::takeSeparatorLine(text);
    table.text = text;
    readHeader(table, separator);
    const Survey survey = surveyOf(table);
    table.rowCount = survey.filledRows;
    table.paddingCount = survey.rows - survey.filledRows;
    Header &header = table.header;
    // A surplus comma in a table with commas, as in "Smith, John", would shift the names.
    const bool mayShift = table.separator == '\t' || table.separator == ' ';
    if (mayShift && survey.filledRows > 0 && survey.isEachOneLonger && !header.isGuessed)
        shift(header);
    if (!header.others.empty() && header.others.front() == std::pair(std::size_t{0}, std::string())) {
        header.others.erase(header.others.begin());
        // Row numbers in a table of several specimens are not names, because each specimen's begin
        // with another number.
        if (!header.has(Name) && !(header.has(Specimen) && survey.areFirstsWhole))
            header.places[Name] = 0;
        else
            header.rowNames = 0;
    }
    seeNumbers(table);
    return table;
}

TableRows::TableRows(const Table &table) : m_table(table), m_reader(table.text, table.separator)
{
    if (!table.header.isGuessed)
        static_cast<void>(m_reader.next());
}

bool TableRows::next()
{
    if (m_read == m_table.rowCount || !m_reader.next())
        return false;
    ++m_read;
    CsvRow &row = m_reader.row();
    const std::size_t count = m_table.header.count;
    row.trimPadding(count);
    m_apostrophes = takeApostrophesOff(row);
    if (row.cells.size() > count)
        throw Failure{row.line,
                      tr("this row has %1 cells, and the first line names %2 columns; put a cell that has the "
                         "separator in it in quotes",
                         row.cells.size(), count)};
    if (row.cells.size() < count)
        throw Failure{row.line, tr("this row has fewer cells (%1) than the first line names columns (%2); leave cells "
                                   "without a value empty",
                                   row.cells.size(), count)};
    return true;
}

} // namespace unprojector::landmark_files::csv
