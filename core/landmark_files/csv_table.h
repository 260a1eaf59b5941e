#pragma once

#include "core/base/csv.h"
#include "core/landmark_files/csv_columns.h"
#include "core/landmark_files/lines.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::landmark_files::csv {

/// The columns that a table's first line names, and properties of all its rows.
struct Header {
    std::array<std::size_t, kColumnCount> places;            ///< index of each column; npos: it is missing
    std::array<std::string, kColumnCount> titles;            ///< the table's own names for them
    std::vector<std::pair<std::size_t, std::string>> others; ///< columns of other programs
    std::optional<std::size_t> rowNames; ///< index of an unnamed first column with R's row names, which are dropped
    std::size_t count = 0;
    landmarks::Axes axes = landmarks::Axes::Lps;
    bool isGuessed = false; ///< the header is missing; the columns are name, x, y, z or x, y, z

    static constexpr std::size_t npos = std::size_t(-1);
    bool has(Column column) const { return places[column] != npos; }
};

struct Table {
    std::string_view text;
    char separator = ',';
    Header header;
    std::size_t rowCount = 0; ///< without the header, and without padding after the last row
    std::size_t paddingCount = 0;
    base::DecimalMark mark{','};
};

/// Finds a table's separator, header, row count and decimal mark. Throws Failure.
Table tableOf(std::string_view text);

/// The rows of a table after its header, each with as many cells as the header.
class TableRows {
public:
    explicit TableRows(const Table &table);
    /// Moves to the next row.
    /// @return false after the last row. Throws Failure.
    bool next();
    const base::CsvRow &row() const { return m_reader.row(); }
    /// The number of the row's cells in which an apostrophe before a formula was removed.
    std::size_t apostropheCount() const { return m_apostrophes; }

private:
    const Table &m_table;
    base::CsvReader m_reader;
    std::size_t m_read = 0, m_apostrophes = 0;
};

} // namespace unprojector::landmark_files::csv
