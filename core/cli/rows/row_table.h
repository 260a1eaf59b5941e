#pragma once

#include "core/base/csv.h"
#include "core/cli/rows/block_pipeline.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {

/// The names of three columns. A column that is not wanted has an empty name, at the end.
using ColumnNames = std::array<std::string, 3>;

/// The columns of a point, as one command writes them and another reads them: "formula_x" to
/// "formula_z", in any space.
ColumnNames pointColumnsOf(const std::string &method);

/// The options shared by all commands that take rows of numbers through a scene.
struct RowOptions {
    std::string scene;           ///< a scene file, or clicks; "-" for stdin
    std::string input = "-";     ///< a CSV file, "-" for stdin
    bool isInputGiven = false;   ///< input has a name; else clicks serve as rows
    std::string space = "world"; ///< space of the points: "eye", "world" or "object:NAME"
    bool isJson = false;         ///< writes JSON lines, else comma-separated values
    bool isSpreadsheetSafe = false;
    bool isHeaderless = false; ///< writes no header, so that results can be concatenated
    unsigned threads = 2;      ///< 0: one per core

    /// @param names  of the columns, as they are written
    base::RowWriter writer(std::string &output, const std::vector<std::string> &names) const;
    std::string header(const std::vector<std::string> &names) const;
};

/// The position of a row in its block.
struct RowPlace {
    std::uint32_t line = 0;  ///< counted from the block's first
    std::uint32_t start = 0; ///< of its text
};

/// Rows of three numbers, one array per column. A bad row has no result: its numbers are zeros. A
/// column that is not wanted has zeros, too.
struct NumberRows {
    std::array<std::vector<double>, 3> values;
    std::vector<RowPlace> places; ///< of each row
    std::vector<char> isBad;      ///< of each row

    std::size_t count() const { return places.size(); }
};

/// A table of comma-separated values of which three columns are numbers for a command. The command
/// writes it again with its results behind: a column with the name of a result is dropped, the others
/// are copied unchanged, in their order. In JSON lines a repeated name gets a number: "n", "n_2".
class RowTable {
public:
    static constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

    /// Opens the input, reads its first line and finds the columns by name; other columns may be
    /// present. Blanks and quotes around names are removed; a comma in quotes does not separate.
    /// Refuses an unusable header.
    /// @param alternatives  accepted names of the three, the preferred ones first; at least one
    /// @param results  names of the columns written
    RowTable(const RowOptions &options, const std::vector<ColumnNames> &alternatives,
             const std::vector<std::string> &results);
    RowTable(const RowTable &) = delete; // m_blocks refers to m_source
    RowTable &operator=(const RowTable &) = delete;

    /// The name of the input, for messages.
    const std::string &name() const { return m_source.name(); }
    /// The rows behind the header.
    LineBlocks &blocks() { return m_blocks; }

    /// Reads the rows of a block. Empty lines are skipped. Numbers may have quotes and blanks around
    /// them, a sign and an exponent. A row is bad if it has anything else, NaN, infinity, more cells
    /// than the header, or an unclosed quote. `messages` gets the reason.
    void read(const LineBlock &block, NumberRows &rows, std::vector<LineMessage> &messages) const;

    /// Adds "file:line:column: what" to the messages.
    /// @param column  index of the wrong one among the three, or kNoColumn
    void complainOf(const LineBlock &block, const RowPlace &place, std::size_t column, std::string_view what,
                    std::vector<LineMessage> &messages) const;

    /// Writes the rows of a block: their input cells, then the results, which a bad row does not have.
    /// @param results  writes the results of a row, and returns why some are missing, or an empty text
    template <class Results>
    void write(const LineBlock &block, const NumberRows &rows, BlockResult &result, const Results &results) const
    {
        base::RowWriter writer = m_options.writer(result.output, m_names);
        base::CsvReader reader(block.text, ',', '\n');
        for (std::size_t i = 0; i < rows.count(); ++i) {
            if (!m_isPlain || rows.isBad[i]) {
                writeCells(writer, reader, block, rows, i);
            } else {
                for (const auto &column : rows.values)
                    writer.number(column[i]);
            }
            if (rows.isBad[i]) {
                for (std::size_t k = 0; k < m_resultCount; ++k)
                    writer.nothing();
            }
            const std::string what = rows.isBad[i] ? std::string() : results(i, writer);
            if (!what.empty())
                complainOf(block, rows.places[i], kNoColumn, what, result.messages);
            result.hasBadRows = result.hasBadRows || rows.isBad[i] || !what.empty();
            writer.endRow();
        }
    }

    /// Processes all rows with workers and writes them, after the header.
    /// @param worker  makes the worker of a thread
    ExitCode run(ByteSink &sink, const std::function<BlockWorker()> &worker);
    /// The same for results that depend on a row's numbers alone.
    /// @param results  as in write(), of a glm::dvec3
    template <class Results>
    ExitCode runEach(ByteSink &sink, const Results &results)
    {
        return run(sink, [&]() -> BlockWorker {
            return [&, rows = NumberRows()](const LineBlock &block, BlockResult &result) mutable {
                read(block, rows, result.messages);
                write(block, rows, result, [&](std::size_t row, base::RowWriter &writer) {
                    return results(glm::dvec3(rows.values[0][row], rows.values[1][row], rows.values[2][row]), writer);
                });
            };
        });
    }

private:
    /// @param cell  index of the wrong cell, from the row's start, or kNoColumn
    void complainAt(const LineBlock &block, const base::CsvRow &row, std::size_t cell, std::string_view what,
                    std::vector<LineMessage> &messages) const;
    /// The fault of a row, and the index of its cell; an empty text if there is none.
    std::string fault(const base::CsvRow &row, std::array<double, 3> &numbers, std::size_t &cell) const;
    /// Writes a row's input cells: its numbers, and all other cells unchanged. A bad row has them all.
    void writeCells(base::RowWriter &writer, base::CsvReader &reader, const LineBlock &block, const NumberRows &rows,
                    std::size_t row) const;
    void nameColumns(const base::CsvRow &header, const std::vector<std::string> &results);

    RowOptions m_options;
    ByteSource m_source;
    LineBlocks m_blocks{m_source};
    ColumnNames m_wanted;
    std::array<std::size_t, 3> m_places{kNoColumn, kNoColumn, kNoColumn}; ///< of the three in a row
    std::vector<std::size_t> m_columns; ///< for each input column: one of the three, kPassed, or kDropped
    std::vector<std::string> m_names;   ///< of the columns written
    std::size_t m_resultCount = 0;
    bool m_isPlain = false; ///< the three in their order, and no other column
};

} // namespace unprojector::cli
