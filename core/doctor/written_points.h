#pragma once

#include "core/base/csv.h"
#include "core/doctor/diagnosis.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Wrong points as text: a program's output, one point at a time or as a table.
namespace unprojector::doctor {

/// A number with its written digits.
struct WrittenNumber {
    double value = 0.0;
    double lastDigit = 1.0; ///< the unit of its last digit: 0.01 for 1.50, 1000 for 3e3
};

/// Parses a number with ASCII's minus or U+2212, with or without the f of a C float.
/// @return empty if it is no finite number
std::optional<WrittenNumber> writtenNumber(std::string_view text);

/// Parses `count` numbers as programs print them: "1.5 2 -3", "1.5, 2, -3", "vec3(1.5, 2, -3)",
/// "[1.5 2. -3.]", "x=1.5 y=2 z=-3". Commas separate all of them or none. A further 1, the w of a
/// point, may follow three.
/// @param wanted  "the three coordinates as the program has printed them", for the error
/// @return the error and the remedy, in the language of base::tr(): a word that is no finite number,
///         another count, commas between some numbers only
geometry::Result<std::vector<WrittenNumber>, std::string> writtenNumbers(std::string_view text, std::size_t count,
                                                                         const std::string &wanted = {});

/// The unit of a depth's last digit, see WrongPoint. A depth of fewer than four decimals counts as
/// exact, as 0.5 does; one with more counts as rounded.
double depthLastDigit(const WrittenNumber &depth);

/// The names of a point's three texts, for messages.
struct PointTextNames {
    const char *pixel = "pixel", *depth = "depth", *got = "got";
};
/// Parses one point from the texts of its pixel, its depth and the wrong coordinate.
/// @param depth  empty: unknown
/// @return the message that names the wrong text, and what to give
geometry::Result<WrongPoint, std::string> wrongPointOf(const std::string &pixel, const std::string &depth,
                                                       const std::string &got, const PointTextNames &names = {});

/// The message that a depth lies outside the depth range, and the remedy.
std::string depthOutsideText(const std::string &depth, const geometry::DepthRange &range);

/// The column names of a table of wrong points.
constexpr std::array<std::string_view, 6> kPointColumns{"px", "py", "depth", "x", "y", "z"};

/// The largest number of a program's points that are examined; more would add no information.
constexpr std::size_t kMostWrongPoints = 100;

/// A row of the table, as written.
struct PointRow {
    std::array<std::string, kPointColumns.size()> cells; ///< in the order of kPointColumns; the depth's may be empty
    std::size_t line = 0;                                ///< line where it begins, counted from 1
    bool isTooLong = false; ///< no header exists, and the row has more cells than columns, as with decimal commas
};
/// Parses the rows of a table, CSV as in RFC 4180. A header's names may be in any order and case.
/// Without a header, the columns are kPointColumns.
/// @return why it cannot be read: an open quote, a missing column, or one that is there twice
geometry::Result<std::vector<PointRow>, base::CsvError> pointRows(std::string_view text);

/// Converts a row to a point.
/// @return index, in kPointColumns, of the first cell that is no number; the number of columns if
///         the row is too long
geometry::Result<WrongPoint, std::size_t> pointOf(const PointRow &row);

} // namespace unprojector::doctor
