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
    std::array<std::size_t, kColumnCount> places;            ///< index of each column; `count` or more: it is missing
    std::array<std::string, kColumnCount> titles;            ///< the table's own names for them
    std::vector<std::pair<std::size_t, std::string>> others; ///< columns of other programs
    std::optional<std::size_t> rowNames; ///< index of an unnamed first column with R's row names, which are dropped
    std::size_t count = 0;
    landmarks::Axes axes = landmarks::Axes::Lps;
    bool isGuessed = false; ///< the header is missing; the columns are name, x, y, z or x, y, z

    bool has(Column column) const { return places[column] < count; }
};

/// A table: its rows after the header, each with as many cells as the header.
class Table {
public:
    /// Finds the separator, the header, the last row and the decimal mark.
    explicit Table(std::string_view text);

    /// Moves to the next row.
    /// @return false after the last row.
    bool next();
    const base::CsvRow &row() const { return m_reader.row(); }
    const Header &header() const { return m_header; }
    const base::DecimalMark &mark() const { return m_mark; }
    /// The number of rows of padding after the last row.
    std::size_t paddingCount() const { return m_paddingCount; }
    /// The number of cells so far in which an apostrophe before a formula was removed.
    std::size_t apostropheCount() const { return m_apostrophes; }

private:
    void readHeader(std::optional<char> separator);
    void survey();
    void rewind();

    std::string_view m_text;
    char m_separator = ',';
    Header m_header;
    base::CsvReader m_reader{std::string_view()};
    std::size_t m_rowCount = 0, m_paddingCount = 0, m_read = 0, m_apostrophes = 0;
    base::DecimalMark m_mark{','};
};

} // namespace unprojector::landmark_files::csv
