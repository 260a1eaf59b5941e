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

/// An empty name, at the end: so many are not wanted.
using ColumnNames = std::array<std::string, 3>;

constexpr std::size_t kNoColumn = std::numeric_limits<std::size_t>::max();

/// Where the three columns that are wanted stand in a row of comma-separated values.
struct NumberColumns {
    ColumnNames names;
    std::array<std::size_t, 3> places{};                          ///< kNoColumn where none is wanted
    std::vector<std::string> heads = std::vector<std::string>(3); ///< of all columns, as the header writes them

    std::size_t count() const { return heads.size(); }
};

/// Reads the first line and finds the columns by their names, whatever others there are. Blanks around names and quotes
/// around them are taken off; a comma in quotes separates nothing. Errors are printed on stderr.
/// @param alternatives  names that the three may have, the preferred ones first; at least one
std::optional<NumberColumns> readHeader(LineBlocks &blocks, const ByteSource &source,
                                        const std::vector<ColumnNames> &alternatives);

/// Where a row stands in its block.
struct RowPlace {
    std::uint32_t line = 0;  ///< counted from the block's first
    std::uint32_t start = 0; ///< of its text
};

/// Rows of three numbers, one array a column. A bad row, which has no result, has zeros, as a column that is not wanted
/// has, and is named in `bad`.
struct NumberRows {
    std::array<std::vector<double>, 3> values;
    std::vector<RowPlace> places; ///< of each row
    std::vector<std::size_t> bad; ///< rows, ascending

    std::size_t count() const { return places.size(); }
};

/// Reads the rows of a block. Empty lines are passed over. Numbers may have quotes and blanks around them, a sign and an exponent;
/// anything else, NaN, infinity, more cells than the header has and a quote that is not closed make a row bad and are said in
/// `messages`.
class NumberReader {
public:
    NumberReader(std::string fileName, NumberColumns columns)
        : m_fileName(std::move(fileName)), m_columns(std::move(columns))
    {
    }

    void read(const LineBlock &block, NumberRows &rows, std::vector<LineMessage> &messages) const;

    static constexpr std::size_t kNoColumn = cli::kNoColumn;
    /// Adds "file:line:column: what" to the messages.
    /// @param column  which of the three is at fault, or kNoColumn
    void complainOf(const LineBlock &block, const RowPlace &place, std::size_t column, std::string_view what,
                    std::vector<LineMessage> &messages) const;

private:
    using Cells = std::array<std::string_view, 3>;
    /// @param cell  counted from the line's start
    void complainAt(const LineBlock &block, const RowPlace &place, std::size_t cell, std::string_view what,
                    std::vector<LineMessage> &messages) const;
    void readRow(const LineBlock &block, std::string_view line, const RowPlace &place, NumberRows &rows,
                 std::vector<LineMessage> &messages) const;
    /// Names the row in rows.bad and says why; its numbers are zeros.
    /// @param cell  at fault, counted from the line's start
    void refuseRow(const LineBlock &block, const RowPlace &place, std::size_t cell, std::string_view what,
                   NumberRows &rows, std::vector<LineMessage> &messages) const;
    /// @param surplus  how many cells there are if those are more than the header has, blank ones aside; else 0
    Cells cellsOf(std::string_view line, std::size_t &surplus) const;

    std::string m_fileName;
    NumberColumns m_columns;
};

} // namespace unprojector::cli
