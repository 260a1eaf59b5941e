#include "core/cli/rows/row_layout.h"

#include "core/cli/rows/csv_line.h"

#include <algorithm>

namespace unprojector::cli {
namespace {

/// A key that no other column of the object has.
std::string freeKey(const std::string &key, const std::vector<std::string> &names,
                    const std::vector<std::string> &results)
{
    const auto isIn = [](const std::vector<std::string> &all, const std::string &name) {
        return std::find(all.begin(), all.end(), name) != all.end();
    };
    std::string free = key;
    for (int number = 2; isIn(names, free) || isIn(results, free); ++number) {
        free = key;
        free += '_';
        free += std::to_string(number);
    }
    return free;
}

} // namespace

RowLayout::RowLayout(const NumberColumns &columns, const std::vector<std::string> &results, RowFormat format)
{
    for (std::size_t index = 0; index < columns.count(); ++index) {
        const std::string &head = columns.heads[index];
        const auto wanted = std::find(columns.places.begin(), columns.places.end(), index);
        if (wanted != columns.places.end()) {
            m_columns.push_back(static_cast<std::size_t>(wanted - columns.places.begin()));
            m_names.push_back(columns.names[m_columns.back()]);
        } else if (std::find(results.begin(), results.end(), unquoted(head)) != results.end()) {
            m_columns.push_back(kDropped);
        } else {
            m_columns.push_back(kPassed);
            const std::string key = jsonOfText(unquoted(head));
            // A JSON object has each key once; a table's column names are copied unchanged.
            m_names.push_back(format == RowFormat::Jsonl     ? freeKey(key.substr(1, key.size() - 2), m_names, results)
                              : format == RowFormat::SafeCsv ? safeCell(passedCell(head))
                                                             : passedCell(head));
        }
    }
    m_isPlain = m_columns == std::vector<std::size_t>{0, 1, 2};
    m_names.insert(m_names.end(), results.begin(), results.end());
}

template <class Number>
void RowLayout::writeCells(RowWriter &writer, std::string_view line, const Number &number) const
{
    std::size_t start = 0;
    for (const std::size_t column : m_columns) {
        std::string_view cell; // a line may be shorter than the header
        if (start <= line.size()) {
            const std::size_t end = cellEnd(line, start);
            cell = line.substr(start, end - start);
            start = end + 1;
        }
        if (column < kPassed)
            number(column, cell);
        else if (column == kPassed)
            writer.passed(cell);
    }
}

void RowLayout::writeInput(RowWriter &writer, const LineBlock &block, const NumberRows &rows, std::size_t row) const
{
    if (m_isPlain) {
        for (const auto &column : rows.values)
            writer.number(column[row]);
        return;
    }
    writeCells(writer, rowAt(block.text, rows.places[row].start),
               [&](std::size_t column, std::string_view) { writer.number(rows.values[column][row]); });
}

void RowLayout::writeBad(RowWriter &writer, const LineBlock &block, const NumberRows &rows, std::size_t row) const
{
    writeCells(writer, rowAt(block.text, rows.places[row].start),
               [&](std::size_t, std::string_view cell) { writer.passedNumber(cell); });
}

} // namespace unprojector::cli
