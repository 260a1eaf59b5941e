#pragma once

#include "core/cli/rows/number_table.h"
#include "core/cli/rows/row_writer.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {

/// The columns of the output: the input's in their order, then the results. An input column with
/// the name of a result is dropped, and the result replaces it. In JSON lines a repeated name gets
/// a number: "n", "n_2".
class RowLayout {
public:
    RowLayout(const NumberColumns &columns, const std::vector<std::string> &results, RowFormat format);

    /// The names in the form that a RowWriter takes.
    const std::vector<std::string> &names() const { return m_names; }

    /// Writes a row's input cells: its numbers, and all other cells unchanged.
    void writeInput(RowWriter &writer, const LineBlock &block, const NumberRows &rows, std::size_t row) const;
    /// Writes all input cells of a row without a result, unchanged. For a line that is too long,
    /// the block is empty.
    void writeBad(RowWriter &writer, const LineBlock &block, const NumberRows &rows, std::size_t row) const;

private:
    // Values after the wanted columns' 0 to 2.
    static constexpr std::size_t kPassed = 3;
    static constexpr std::size_t kDropped = 4;

    /// Calls `number` with the text of each wanted column, and copies the others.
    template <class Number>
    void writeCells(RowWriter &writer, std::string_view line, const Number &number) const;

    std::vector<std::string> m_names;
    std::vector<std::size_t> m_columns; ///< for each input column: one of the three, kPassed, or kDropped
    bool m_isPlain;                     ///< the three in their order, and no other column
};

} // namespace unprojector::cli
