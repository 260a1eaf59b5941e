#pragma once

#include "core/cli/rows/line_blocks.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {

/// The names of three columns. A column that is not wanted has an empty name, at the end.
using ColumnNames = std::array<std::string, 3>;

constexpr std::size_t kNoColumn = std::numeric_limits<std::size_t>::max();

/// The positions of the three wanted columns in a row of comma-separated values.
struct NumberColumns {
    ColumnNames names;
    std::array<std::size_t, 3> places{};                          ///< kNoColumn for a column that is not wanted
    std::vector<std::string> heads = std::vector<std::string>(3); ///< names of all columns, as the header writes them

    std::size_t count() const { return heads.size(); }
};

/// Reads the first line and finds the columns by name; other columns may be present. Blanks and
/// quotes around names are removed; a comma in quotes does not separate. Errors are printed on
/// stderr.
/// @param alternatives  accepted names of the three, the preferred ones first; at least one
std::optional<NumberColumns> readHeader(LineBlocks &blocks, const ByteSource &source,
                                        const std::vector<ColumnNames> &alternatives);

/// The position of a row in its block.
struct RowPlace {
    std::uint32_t line = 0;  ///< counted from the block's first
    std::uint32_t start = 0; ///< of its text
};

/// Rows of three numbers, one array per column. A bad row has no result: its numbers are zeros, and
/// `bad` contains its index. A column that is not wanted has zeros, too.
struct NumberRows {
    std::array<std::vector<double>, 3> values;
    std::vector<RowPlace> places; ///< of each row
    std::vector<std::size_t> bad; ///< rows, ascending

    std::size_t count() const { return places.size(); }
};

/// Reads the rows of a block. Empty lines are skipped. Numbers may have quotes and blanks around
/// them, a sign and an exponent. A row is bad if it has anything else, NaN, infinity, more cells
/// than the header, or an unclosed quote. `messages` gets the reason.
class NumberReader {
public:
    NumberReader(std::string fileName, NumberColumns columns)
        : m_fileName(std::move(fileName)), m_columns(std::move(columns))
    {
    }

    void read(const LineBlock &block, NumberRows &rows, std::vector<LineMessage> &messages) const;

    static constexpr std::size_t kNoColumn = cli::kNoColumn;
    /// Adds "file:line:column: what" to the messages.
    /// @param column  index of the wrong one among the three, or kNoColumn
    void complainOf(const LineBlock &block, const RowPlace &place, std::size_t column, std::string_view what,
                    std::vector<LineMessage> &messages) const;

private:
    using Cells = std::array<std::string_view, 3>;
    /// @param cell  index from the line's start
    void complainAt(const LineBlock &block, const RowPlace &place, std::size_t cell, std::string_view what,
                    std::vector<LineMessage> &messages) const;
    void readRow(const LineBlock &block, std::string_view line, const RowPlace &place, NumberRows &rows,
                 std::vector<LineMessage> &messages) const;
    /// Adds the row to rows.bad with a message; its numbers become zeros.
    /// @param cell  index of the wrong cell, from the line's start
    void refuseRow(const LineBlock &block, const RowPlace &place, std::size_t cell, std::string_view what,
                   NumberRows &rows, std::vector<LineMessage> &messages) const;
    /// @param surplus  the number of cells if it exceeds the header's, not counting blank ones;
    ///         else 0
    Cells cellsOf(std::string_view line, std::size_t &surplus) const;

    std::string m_fileName;
    NumberColumns m_columns;
};

} // namespace unprojector::cli
