#include "core/cli/rows/row_table.h"

#include "core/base/parallel.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace unprojector::cli {
using namespace base;
namespace {

// Kinds of columns behind the wanted ones' 0 to 2.
constexpr std::size_t kPassed = 3, kDropped = 4;

/// The reason why a cell has no number; empty if it has one.
std::string faultOf(const CsvCell &cell, const std::string &column, double &number)
{
    std::string_view digits = cell.isQuoted ? trimmed(cell.text) : cell.text;
    if (digits.empty())
        return tr("%1 is missing", column);
    if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-')
        digits.remove_prefix(1); // std::from_chars accepts no plus
    const char *end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number);
    if (error == std::errc{} && stop == end && std::isfinite(number))
        return {};
    return tr(error == std::errc::result_out_of_range ? "%1: %2 is beyond the range of double precision"
              : error != std::errc{} || stop != end   ? "%1: %2 is not a number"
                                                      : "%1: %2 is not finite",
              column, quoted(trimmed(cell.source)));
}

/// Reads a row of three plain numbers, as nearly all are.
bool arePlain(std::string_view row, std::array<double, 3> &numbers)
{
    const char *at = row.data(), *end = at + row.size();
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [behind, error] = std::from_chars(at, end, numbers[k]);
        if (error != std::errc{} || !std::isfinite(numbers[k]) || (k < 2 && (behind == end || *behind != ',')))
            return false;
        at = k == 2 ? behind : behind + 1;
    }
    return at == end;
}

/// The column of a cell's text in its line, from 1; the end of the line where there is no such cell.
std::size_t columnOf(const CsvRow &row, std::size_t cell)
{
    if (cell >= row.cells.size())
        return row.source.find_last_not_of(" \t\r") + 2;
    const auto start = static_cast<std::size_t>(row.cells[cell].source.data() - row.source.data());
    const std::size_t text = row.source.find_first_not_of(" \t\r", start);
    return (text == row.source.npos ? start : text) + 1;
}

/// A hint why a header lacks a column that it seems to have.
std::string hintFor(const CsvRow &header, std::string_view column)
{
    if (header.source.starts_with("\xFF\xFE") || header.source.starts_with("\xFE\xFF"))
        return tr("; the file is UTF-16, save it as UTF-8");
    const auto has = [&header](std::string_view text) { return header.source.find(text) != std::string_view::npos; };
    if (has(column) && has(";"))
        return tr("; columns are separated by commas here, not by semicolons");
    if (has(column) && has("\t"))
        return tr("; columns are separated by commas here, not by tabs");
    const std::size_t other = header.column(column);
    return other < header.cells.size()
               ? tr("; %1 is written in small letters", quoted(trimmed(header.cells[other].text)))
               : std::string();
}

bool isIn(const std::vector<std::string> &all, std::string_view name)
{
    return std::find(all.begin(), all.end(), name) != all.end();
}

} // namespace

ColumnNames pointColumnsOf(const std::string &method)
{
    return {method + "_x", method + "_y", method + "_z"};
}

RowWriter RowOptions::writer(std::string &output, const std::vector<std::string> &names) const
{
    return RowWriter(output, isSpreadsheetSafe ? CellTexts::SpreadsheetSafe : CellTexts::Verbatim,
                     isJson ? names : std::vector<std::string>());
}

std::string RowOptions::header(const std::vector<std::string> &names) const
{
    std::string text;
    if (isJson || isHeaderless)
        return text;
    RowWriter writer(text);
    for (const std::string &name : names)
        writer.plain(name);
    writer.endRow();
    return text;
}

RowTable::RowTable(const RowOptions &options, const std::vector<ColumnNames> &alternatives,
                   const std::vector<std::string> &results)
    : m_options(options), m_source(options.input)
{
    std::string wanted;
    for (const ColumnNames &names : alternatives) {
        const std::string list = names[0] + ',' + names[1] + (names[2].empty() ? "" : ',' + names[2]);
        wanted = wanted.empty() ? list : tr("%1 or %2", wanted, list);
    }
    const auto fail = [this](const std::string &what) { refuse(name() + what); };
    LineBlock first;
    if (!m_blocks.next(first, true))
        fail(tr(m_source.hasFailed() ? ": cannot be read" : ": is empty; its first line must be %1", wanted));
    if (first.isOverlong)
        fail(":1: " + tr("the line is longer than %1 bytes; it must be %2", LineBlocks::kMostBytes, wanted));
    CsvReader reader(first.text, ',', '\n');
    reader.nextSource();
    reader.split();
    const CsvRow &header = reader.row();
    if (header.source.find('\r') != std::string_view::npos)
        fail(":1: " + tr("the lines end with CR alone, as on old Macs; save the file with LF or CRLF"));
    const auto failAt = [&](std::size_t cell, const std::string &what) {
        fail(":1:" + std::to_string(columnOf(header, cell)) + ": " + what);
    };
    if (reader.error())
        failAt(reader.error()->cell, tr("the quote is not closed; the names of the columns must be on one line"));
    const auto find = [&header](const std::string &name, std::size_t from = 0) {
        while (from < header.cells.size() && trimmed(header.cells[from].text) != name)
            ++from;
        return from;
    };
    const auto hasAll = [&](const ColumnNames &names) {
        return std::all_of(names.begin(), names.end(),
                           [&](const std::string &name) { return name.empty() || find(name) < header.cells.size(); });
    };
    // Take the first alternative that is present; if none is, report the first as missing.
    const auto there = std::find_if(alternatives.begin(), alternatives.end(), hasAll);
    m_wanted = there == alternatives.end() ? alternatives.front() : *there;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string &name = m_wanted[k];
        if (name.empty())
            continue;
        m_places[k] = find(name);
        if (m_places[k] == header.cells.size())
            fail(":1:1: " + tr("the header has no column %1; the first line must be %2", name, wanted)
                 + hintFor(header, name));
        if (const std::size_t again = find(name, m_places[k] + 1); again < header.cells.size())
            failAt(again, tr("the header names the column %1 twice", name));
    }
    nameColumns(header, results);
}

void RowTable::nameColumns(const CsvRow &header, const std::vector<std::string> &results)
{
    for (std::size_t index = 0; index < header.cells.size(); ++index) {
        const CsvCell &cell = header.cells[index];
        const auto wanted = std::find(m_places.begin(), m_places.end(), index);
        const std::string_view name = trimmed(cell.text);
        if (wanted != m_places.end()) {
            m_columns.push_back(static_cast<std::size_t>(wanted - m_places.begin()));
            m_names.push_back(m_wanted[m_columns.back()]);
        } else if (isIn(results, name)) {
            m_columns.push_back(kDropped);
        } else {
            m_columns.push_back(kPassed);
            std::string written;
            if (m_options.isJson) { // an object has each key once
                const std::string text = jsonText(name), key = text.substr(1, text.size() - 2);
                written = key;
                for (int number = 2; isIn(m_names, written) || isIn(results, written); ++number)
                    written = key + '_' + std::to_string(number);
            } else {
                m_options.writer(written, m_names).passed(cell);
                written.pop_back(); // the comma
            }
            m_names.push_back(std::move(written));
        }
    }
    m_isPlain = m_columns == std::vector<std::size_t>{0, 1, 2};
    m_names.insert(m_names.end(), results.begin(), results.end());
    m_resultCount = results.size();
}

void RowTable::complainAt(const LineBlock &block, const CsvRow &row, std::size_t cell, std::string_view what,
                          std::vector<LineMessage> &messages) const
{
    std::string message = name() + ':' + std::to_string(block.firstLine + row.line - 1);
    if (cell != kNoColumn)
        message += ':' + std::to_string(columnOf(row, cell));
    messages.push_back({row.line, message.append(": ").append(what)});
}

void RowTable::complainOf(const LineBlock &block, const RowPlace &place, std::size_t column, std::string_view what,
                          std::vector<LineMessage> &messages) const
{
    CsvReader reader(std::string_view(block.text).substr(place.start), ',', '\n');
    reader.nextSource();
    reader.split();
    reader.row().line += place.line;
    complainAt(block, reader.row(), column < 3 ? m_places[column] : kNoColumn, what, messages);
}

std::string RowTable::fault(const CsvRow &row, std::array<double, 3> &numbers, std::size_t &cell) const
{
    for (std::size_t k = 0; k < 3; ++k) {
        cell = m_places[k];
        std::string reason;
        if (cell != kNoColumn)
            reason = faultOf(cell < row.cells.size() ? row.cells[cell] : CsvCell(), m_wanted[k], numbers[k]);
        if (!reason.empty())
            return reason;
    }
    std::size_t count = row.cells.size();
    while (count > m_columns.size() && row.cells[count - 1].isBlank())
        --count;
    cell = m_columns.size();
    // Otherwise decimal commas would be read as other numbers.
    return count > cell ? tr("the row has %1 cells, the header %2", count, cell) : std::string();
}

void RowTable::read(const LineBlock &block, NumberRows &rows, std::vector<LineMessage> &messages) const
{
    for (auto &column : rows.values)
        column.clear();
    rows.places.clear();
    rows.isBad.clear();
    CsvReader reader(block.text, ',', '\n');
    const auto add = [&](const std::array<double, 3> &numbers) {
        for (std::size_t k = 0; k < 3; ++k)
            rows.values[k].push_back(numbers[k]);
        rows.places.push_back({static_cast<std::uint32_t>(reader.row().line - 1),
                               static_cast<std::uint32_t>(reader.row().source.data() - block.text.data())});
    };
    const auto refuse = [&](std::size_t cell, std::string_view what) {
        complainAt(block, reader.row(), cell, what, messages);
        rows.isBad.resize(rows.count());
        rows.isBad.push_back(true);
        add({});
    };
    const bool areFirst = m_places == std::array<std::size_t, 3>{0, 1, 2};
    while (reader.nextSource()) {
        std::array<double, 3> numbers{};
        if (areFirst && arePlain(reader.row().source, numbers)) {
            add(numbers);
            continue;
        }
        reader.split();
        if (reader.error()) {
            refuse(reader.error()->cell, tr("the quote is not closed; quotes in quotes are doubled"));
        } else if (!reader.row().cells.empty()) {
            std::size_t cell = kNoColumn;
            numbers = {};
            if (const std::string what = fault(reader.row(), numbers, cell); what.empty())
                add(numbers);
            else
                refuse(cell, what);
        }
    }
    if (block.isOverlong)
        refuse(kNoColumn, tr("the line is longer than %1 bytes", LineBlocks::kMostBytes));
    rows.isBad.resize(rows.count());
}

void RowTable::writeCells(RowWriter &writer, CsvReader &reader, const LineBlock &block, const NumberRows &rows,
                          std::size_t row) const
{
    while (reader.nextSource() && reader.row().source.data() - block.text.data() < rows.places[row].start)
        continue; // blank lines, and rows that need not be split
    reader.split();
    const std::vector<CsvCell> &cells = reader.row().cells;
    for (std::size_t index = 0; index < m_columns.size(); ++index) {
        const CsvCell cell = index < cells.size() ? cells[index] : CsvCell();
        if (m_columns[index] == kPassed)
            writer.passed(cell);
        else if (m_columns[index] < kPassed && rows.isBad[row])
            writer.passedNumber(cell);
        else if (m_columns[index] < kPassed)
            writer.number(rows.values[m_columns[index]][row]);
    }
}

ExitCode RowTable::run(ByteSink &sink, const std::function<BlockWorker()> &worker)
{
    sink.write(m_options.header(m_names));
    return runBlocks(m_blocks, m_source, sink, m_options.threads > 0 ? m_options.threads : coreCount(), worker);
}

} // namespace unprojector::cli
