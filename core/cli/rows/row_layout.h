#pragma once

#include "core/cli/rows/number_table.h"
#include "core/cli/rows/row_writer.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {

/// The columns of the output: those of the input, each where it stood, then the results. A column of the input that has the
/// name of a result is written anew, and only there. In JSON
/// lines a name that was there already gets a number behind it: "n", "n_2".
class RowLayout {
public:
    RowLayout(const NumberColumns &columns, const std::vector<std::string> &results, RowFormat format);

    /// As a RowWriter takes them.
    const std::vector<std::string> &names() const { return m_names; }

    /// Writes what a row has of the input: its numbers, and whatever else is in it, unchanged.
    void writeInput(RowWriter &writer, const LineBlock &block, const NumberRows &rows, std::size_t row) const;
    /// Writes all that a row without a result has of the input, unchanged. The block may be one line that is too long: it is
    /// empty then.
    void writeBad(RowWriter &writer, const LineBlock &block, const NumberRows &rows, std::size_t row) const;

private:
    // Beside the three wanted columns, 0 to 2.
    static constexpr std::size_t kPassed = 3;
    static constexpr std::size_t kDropped = 4;

    /// Calls `number` for the wanted columns with what is written there, and passes the others.
    template <class Number>
    void writeCells(RowWriter &writer, std::string_view line, const Number &number) const;

    std::vector<std::string> m_names;
    std::vector<std::size_t> m_columns; ///< of the input: which of the three, kPassed, or kDropped
    bool m_isPlain;                     ///< the three, in their order, and nothing else
};

} // namespace unprojector::cli
