#include "core/cli/number_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace unprojector {
namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

std::string_view unquoted(std::string_view text)
{
    text = trimmed(text);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        text = trimmed(text.substr(1, text.size() - 2));
    return text;
}

/// A cell as a message can show it: short, and on one line.
std::string shown(std::string_view cell)
{
    constexpr std::size_t kMost = 40;
    cell = trimmed(cell);
    std::string text(cell.substr(0, kMost));
    std::replace_if(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, '?');
    return '"' + text + (cell.size() > kMost ? "…\"" : "\"");
}

/// The number of a cell, or nothing with the reason.
std::optional<double> numberOf(std::string_view cell, const std::string &column, std::string &reason)
{
    std::string_view digits = unquoted(cell);
    if (digits.empty()) {
        reason = column + " is missing";
        return std::nullopt;
    }
    if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-')
        digits.remove_prefix(1); // std::from_chars takes no plus
    double value = 0.0;
    const char *end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error == std::errc::result_out_of_range)
        reason = column + ": " + shown(cell) + " is beyond the range of double precision";
    else if (error != std::errc{} || stop != end)
        reason = column + ": " + shown(cell) + " is not a number";
    else if (!std::isfinite(value))
        reason = column + ": " + shown(cell) + " is not finite";
    else
        return value;
    return std::nullopt;
}

/// Where a cell's text starts in its line; the line's end where it has no such cell.
std::size_t placeOf(std::string_view line, std::size_t cell)
{
    std::size_t start = 0;
    for (std::size_t n = 0; n < cell; ++n) {
        const std::size_t comma = line.find(',', start);
        if (comma == std::string_view::npos)
            return trimmed(line).empty() ? 0 : line.find_last_not_of(" \t\r") + 1;
        start = comma + 1;
    }
    const std::size_t text = line.find_first_not_of(" \t\r", start);
    return text == std::string_view::npos ? start : text;
}

} // namespace

std::optional<NumberColumns> readHeader(LineBlocks &blocks, const ByteSource &source,
                                        const std::array<std::string, 3> &names)
{
    const std::string wanted = names[0] + ',' + names[1] + ',' + names[2];
    std::string header;
    if (!blocks.firstLine(header)) {
        complain(source.name() + (source.hasFailed() ? ": cannot be read" : ": is empty; its first line must be " + wanted));
        return std::nullopt;
    }
    std::vector<std::string_view> found;
    for (std::size_t start = 0; start <= header.size();) {
        const std::size_t comma = std::min(header.find(',', start), header.size());
        found.push_back(unquoted(std::string_view(header).substr(start, comma - start)));
        start = comma + 1;
    }
    NumberColumns columns{names, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto place = std::find(found.begin(), found.end(), names[k]);
        const bool isThere = place != found.end();
        if (!isThere || std::find(place + 1, found.end(), names[k]) != found.end()) {
            complain(source.name() + ":1:1: the header " + (isThere ? "names the column " : "has no column ") + names[k]
                     + (isThere ? " twice" : "; the first line must be " + wanted));
            return std::nullopt;
        }
        columns.places[k] = static_cast<std::size_t>(place - found.begin());
    }
    return columns;
}

void NumberReader::complainOf(const LineBlock &block, std::uint32_t line, std::size_t column, std::string_view what,
                              std::vector<LineMessage> &messages) const
{
    std::string message = m_fileName + ':' + std::to_string(block.firstLine + line);
    if (column < 3) {
        std::size_t start = 0;
        for (std::uint32_t n = 0; n < line; ++n)
            start = block.text.find('\n', start) + 1;
        const std::string_view rest = std::string_view(block.text).substr(start);
        const std::string_view text = rest.substr(0, std::min(rest.find('\n'), rest.size()));
        message += ':' + std::to_string(placeOf(text, m_columns.places[column]) + 1);
    }
    message.append(": ").append(what);
    messages.push_back({line, std::move(message)});
}

NumberReader::Cells NumberReader::cellsOf(std::string_view line) const
{
    Cells cells;
    const std::size_t last = *std::max_element(m_columns.places.begin(), m_columns.places.end());
    std::size_t start = 0;
    for (std::size_t place = 0; start <= line.size() && place <= last; ++place) {
        const std::size_t comma = std::min(line.find(',', start), line.size());
        for (std::size_t k = 0; k < 3; ++k) {
            if (m_columns.places[k] == place)
                cells[k] = line.substr(start, comma - start);
        }
        start = comma + 1;
    }
    return cells;
}

void NumberReader::readRow(const LineBlock &block, std::string_view line, std::uint32_t number, NumberRows &rows,
                           std::vector<LineMessage> &messages) const
{
    const Cells cells = cellsOf(line);
    std::array<double, 3> numbers{};
    std::string reason;
    for (std::size_t k = 0; k < 3; ++k) {
        if (const std::optional<double> value = numberOf(cells[k], m_columns.names[k], reason)) {
            numbers[k] = *value;
            continue;
        }
        complainOf(block, number, k, reason, messages);
        BadRow bad{rows.count(), {}};
        std::transform(cells.begin(), cells.end(), bad.cells.begin(),
                       [](std::string_view text) { return std::string(trimmed(text)); });
        rows.bad.push_back(std::move(bad));
        numbers = {};
        break;
    }
    for (std::size_t k = 0; k < 3; ++k)
        rows.values[k].push_back(numbers[k]);
    rows.lines.push_back(number);
}

void NumberReader::read(const LineBlock &block, NumberRows &rows, std::vector<LineMessage> &messages) const
{
    for (auto &column : rows.values)
        column.clear();
    rows.lines.clear();
    rows.bad.clear();
    if (block.isOverlong) {
        complainOf(block, 0, kNoColumn, "the line is longer than " + std::to_string(LineBlocks::kMostBytes) + " bytes", messages);
        rows.bad.push_back({0, {}});
        for (auto &column : rows.values)
            column.push_back(0.0);
        rows.lines.push_back(0);
        return;
    }
    const std::string_view text = block.text;
    std::uint32_t number = 0;
    for (std::size_t start = 0; start < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        std::string_view line = text.substr(start, end - start);
        start = end + 1;
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
        // Nearly all rows are three plain numbers and nothing else. What this cannot read, readRow can, or explains.
        if (m_columns.places == std::array<std::size_t, 3>{0, 1, 2}) {
            std::array<double, 3> numbers;
            const char *at = line.data(), *stop = line.data() + line.size();
            bool isPlain = true;
            for (std::size_t k = 0; k < 3 && isPlain; ++k) {
                const auto [next, error] = std::from_chars(at, stop, numbers[k]);
                isPlain = error == std::errc{} && std::isfinite(numbers[k]) && (k == 2 || (next != stop && *next == ','));
                at = k == 2 ? next : next + 1;
            }
            if (isPlain && at == stop) {
                for (std::size_t k = 0; k < 3; ++k)
                    rows.values[k].push_back(numbers[k]);
                rows.lines.push_back(number);
                continue;
            }
        }
        if (!trimmed(line).empty())
            readRow(block, line, number, rows, messages);
    }
}

} // namespace unprojector
