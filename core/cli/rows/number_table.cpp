#include "core/cli/rows/number_table.h"

#include "core/base/printable.h"
#include "core/base/translation.h"
#include "core/cli/rows/csv_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace unprojector::cli {
using base::tr;
namespace {

/// A cell shortened for a message, on one line.
std::string shown(std::string_view cell)
{
    constexpr std::size_t kMost = 40;
    return tr("\"%1\"", base::printableBeginning(trimmed(cell), kMost));
}

/// The number of a cell; empty, with the reason, if there is none.
std::optional<double> numberOf(std::string_view cell, const std::string &column, std::string &reason)
{
    std::string_view digits = unquoted(cell);
    if (digits.empty()) {
        reason = tr("%1 is missing", column);
        return std::nullopt;
    }
    if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-')
        digits.remove_prefix(1); // std::from_chars accepts no plus
    double value = 0.0;
    const char *end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error == std::errc::result_out_of_range)
        reason = tr("%1: %2 is beyond the range of double precision", column, shown(cell));
    else if (error != std::errc{} || stop != end)
        reason = tr("%1: %2 is not a number", column, shown(cell));
    else if (!std::isfinite(value))
        reason = tr("%1: %2 is not finite", column, shown(cell));
    else
        return value;
    return std::nullopt;
}

/// The start of a cell's text in its line; the line's end where it has no such cell.
std::size_t placeOf(std::string_view line, std::size_t cell)
{
    std::size_t start = 0;
    for (std::size_t n = 0; n < cell; ++n) {
        const std::size_t end = cellEnd(line, start);
        if (end == line.size())
            return trimmed(line).empty() ? 0 : line.find_last_not_of(" \t\r") + 1;
        start = end + 1;
    }
    const std::size_t text = line.find_first_not_of(" \t\r", start);
    return text == std::string_view::npos ? start : text;
}

/// A hint why a header lacks a column that it seems to have.
std::string hintFor(std::string_view header, std::string_view column, const std::vector<std::string_view> &found)
{
    if (header.starts_with("\xFF\xFE") || header.starts_with("\xFE\xFF"))
        return tr("; the file is UTF-16, save it as UTF-8");
    if (header.find(column) != std::string_view::npos) {
        for (const char *separator : {";", "\t"}) {
            if (header.find(separator) != std::string_view::npos)
                return tr(*separator == ';' ? "; columns are separated by commas here, not by semicolons"
                                            : "; columns are separated by commas here, not by tabs");
        }
    }
    for (const std::string_view name : found) {
        if (std::equal(name.begin(), name.end(), column.begin(), column.end(),
                       [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; }))
            return tr("; %1 is written in small letters", shown(name));
    }
    return {};
}

} // namespace

std::optional<NumberColumns> readHeader(LineBlocks &blocks, const ByteSource &source,
                                        const std::vector<ColumnNames> &alternatives)
{
    const auto listed = [](const ColumnNames &names) {
        return names[0] + ',' + names[1] + (names[2].empty() ? "" : ',' + names[2]);
    };
    std::string wanted = listed(alternatives.front());
    for (std::size_t k = 1; k < alternatives.size(); ++k)
        wanted = tr("%1 or %2", wanted, listed(alternatives[k]));
    const auto refuse = [&source](const std::string &what) {
        complain(source.name() + what);
        return std::nullopt;
    };
    LineBlock first;
    if (!blocks.firstLine(first))
        return refuse(tr(source.hasFailed() ? ": cannot be read" : ": is empty; its first line must be %1", wanted));
    if (first.isOverlong)
        return refuse(":1: " + tr("the line is longer than %1 bytes; it must be %2", LineBlocks::kMostBytes, wanted));
    const std::string_view header = std::string_view(first.text).substr(0, first.text.find_last_not_of("\r\n") + 1);
    if (header.find('\r') != std::string_view::npos)
        return refuse(":1: " + tr("the lines end with CR alone, as on old Macs; save the file with LF or CRLF"));
    if (const RowEnd row = rowEnd(header, 0); !row.isClosed)
        return refuse(":1:" + std::to_string(placeOf(header, row.cell) + 1) + ": "
                      + tr("the quote is not closed; the names of the columns must be on one line"));
    NumberColumns columns;
    columns.heads.clear();
    std::vector<std::string_view> found;
    for (std::size_t start = 0; start <= header.size();) {
        const std::size_t end = cellEnd(header, start);
        columns.heads.emplace_back(header.substr(start, end - start));
        found.push_back(unquoted(header.substr(start, end - start)));
        start = end + 1;
    }
    const auto hasAll = [&found](const ColumnNames &names) {
        return std::all_of(names.begin(), names.end(), [&found](const std::string &name) {
            return name.empty() || std::find(found.begin(), found.end(), name) != found.end();
        });
    };
    // Take the first alternative that is present; if none is, report the first as missing.
    const auto there = std::find_if(alternatives.begin(), alternatives.end(), hasAll);
    columns.names = there == alternatives.end() ? alternatives.front() : *there;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string &name = columns.names[k];
        columns.places[k] = kNoColumn;
        if (name.empty())
            continue;
        const auto place = std::find(found.begin(), found.end(), name);
        if (place == found.end())
            return refuse(":1:1: " + tr("the header has no column %1; the first line must be %2", name, wanted)
                          + hintFor(header, name, found));
        columns.places[k] = static_cast<std::size_t>(place - found.begin());
        const auto again = std::find(place + 1, found.end(), name);
        if (again != found.end()) {
            const std::size_t column = placeOf(header, static_cast<std::size_t>(again - found.begin()));
            return refuse(":1:" + std::to_string(column + 1) + ": " + tr("the header names the column %1 twice", name));
        }
    }
    return columns;
}

void NumberReader::complainAt(const LineBlock &block, const RowPlace &place, std::size_t cell, std::string_view what,
                              std::vector<LineMessage> &messages) const
{
    std::string message = m_fileName + ':' + std::to_string(block.firstLine + place.line);
    if (cell != kNoColumn) {
        message += ':' + std::to_string(placeOf(rowAt(block.text, place.start), cell) + 1);
    }
    message.append(": ").append(what);
    messages.push_back({place.line, std::move(message)});
}

void NumberReader::complainOf(const LineBlock &block, const RowPlace &place, std::size_t column, std::string_view what,
                              std::vector<LineMessage> &messages) const
{
    complainAt(block, place, column < 3 ? m_columns.places[column] : kNoColumn, what, messages);
}

NumberReader::Cells NumberReader::cellsOf(std::string_view line, std::size_t &surplus) const
{
    Cells cells;
    surplus = 0;
    std::size_t start = 0;
    for (std::size_t index = 0; start <= line.size(); ++index) {
        const std::size_t end = cellEnd(line, start);
        const std::string_view cell = line.substr(start, end - start);
        for (std::size_t k = 0; k < 3; ++k) {
            if (m_columns.places[k] == index)
                cells[k] = cell;
        }
        if (index >= m_columns.count() && !trimmed(cell).empty())
            surplus = index + 1;
        start = end + 1;
    }
    return cells;
}

void NumberReader::readRow(const LineBlock &block, std::string_view line, const RowPlace &place, NumberRows &rows,
                           std::vector<LineMessage> &messages) const
{
    std::size_t surplus = 0, fault = kNoColumn;
    const Cells cells = cellsOf(line, surplus);
    std::array<double, 3> numbers{};
    std::string reason;
    for (std::size_t k = 0; k < 3 && fault == kNoColumn; ++k) {
        if (m_columns.places[k] == kNoColumn)
            continue;
        if (const std::optional<double> value = numberOf(cells[k], m_columns.names[k], reason))
            numbers[k] = *value;
        else
            fault = m_columns.places[k];
    }
    // Otherwise decimal commas would be read as other numbers.
    if (fault == kNoColumn && surplus > 0) {
        fault = m_columns.count();
        reason = tr("the row has %1 cells, the header %2", surplus, m_columns.count());
    }
    if (fault != kNoColumn) {
        refuseRow(block, place, fault, reason, rows, messages);
        return;
    }
    for (std::size_t k = 0; k < 3; ++k)
        rows.values[k].push_back(numbers[k]);
    rows.places.push_back(place);
}

void NumberReader::refuseRow(const LineBlock &block, const RowPlace &place, std::size_t cell, std::string_view what,
                             NumberRows &rows, std::vector<LineMessage> &messages) const
{
    complainAt(block, place, cell, what, messages);
    rows.bad.push_back(rows.count());
    for (auto &column : rows.values)
        column.push_back(0.0);
    rows.places.push_back(place);
}

void NumberReader::read(const LineBlock &block, NumberRows &rows, std::vector<LineMessage> &messages) const
{
    for (auto &column : rows.values)
        column.clear();
    rows.places.clear();
    rows.bad.clear();
    if (block.isOverlong) {
        complainOf(block, {}, kNoColumn, tr("the line is longer than %1 bytes", LineBlocks::kMostBytes), messages);
        rows.bad.push_back(0);
        for (auto &column : rows.values)
            column.push_back(0.0);
        rows.places.push_back({});
        return;
    }
    const std::string_view text = block.text;
    const bool hasQuotes = text.find('"') != std::string_view::npos;
    std::uint32_t number = 0;
    std::size_t next = 0;
    for (std::size_t start = 0; start < text.size(); start = next) {
        const RowPlace place{number++, static_cast<std::uint32_t>(start)};
        const RowEnd row = hasQuotes ? rowEnd(text, start) : RowEnd{std::min(text.find('\n', start), text.size())};
        std::string_view line = text.substr(start, row.end - start);
        next = row.end + 1;
        if (hasQuotes)
            number += static_cast<std::uint32_t>(std::count(line.begin(), line.end(), '\n'));
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
        // Fast path: nearly all rows are three plain numbers. readRow reads or explains all others.
        if (m_columns.places == std::array<std::size_t, 3>{0, 1, 2}) {
            std::array<double, 3> numbers;
            const char *at = line.data(), *stop = line.data() + line.size();
            bool isPlain = true;
            for (std::size_t k = 0; k < 3 && isPlain; ++k) {
                const auto [behind, error] = std::from_chars(at, stop, numbers[k]);
                isPlain =
                    error == std::errc{} && std::isfinite(numbers[k]) && (k == 2 || (behind != stop && *behind == ','));
                at = k == 2 ? behind : behind + 1;
            }
            if (isPlain && at == stop) {
                for (std::size_t k = 0; k < 3; ++k)
                    rows.values[k].push_back(numbers[k]);
                rows.places.push_back(place);
                continue;
            }
        }
        if (!row.isClosed)
            refuseRow(block, place, row.cell, tr("the quote is not closed; quotes in quotes are doubled"), rows,
                      messages);
        else if (!trimmed(line).empty())
            readRow(block, line, place, rows, messages);
    }
}

} // namespace unprojector::cli
