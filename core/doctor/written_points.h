#pragma once

#include "core/doctor/diagnosis.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Wrong points as people have them: printed by their program, one at a time or as a table.
namespace unprojector::doctor {

/// A number with the digits it was written with.
struct WrittenNumber {
    double value = 0.0;
    double lastDigit = 1.0; ///< its unit: 0.01 of 1.50, 1000 of 3e3
};

/// A number with ASCII's minus or U+2212, with the f of a C float behind it or not.
/// @return nothing for what is no finite number
std::optional<WrittenNumber> writtenNumber(std::string_view text);

/// So many numbers as programs print them: "1.5 2 -3", "1.5, 2, -3", "vec3(1.5, 2, -3)", "[1.5 2. -3.]", "x=1.5 y=2 z=-3". Between
/// all of them stand commas, or between none. A further 1, the w of a point, may stand behind three.
/// @return nothing where there are others, or anything that is no number
std::optional<std::vector<WrittenNumber>> writtenNumbers(std::string_view text, std::size_t count);

/// Why a text is not so many numbers.
struct NumbersFault {
    std::string word;            ///< the first that is no finite number; empty: their count or their commas are wrong
    std::size_t found = 0;       ///< numbers
    bool areCommasMixed = false; ///< between some of them and not between others, as decimal commas make it
    /// Whether the word is what programs print for no number or an infinite one: nan, -inf, 1.#IND.
    bool isNotFinite() const;
};
/// What is wrong with numbers that were given, and what to do, in the language of text::tr().
/// @param wanted  "the three coordinates as the program has printed them"
std::string faultText(const NumbersFault &fault, const std::string &wanted);
/// As writtenNumbers.
geometry::Result<std::vector<WrittenNumber>, NumbersFault> numbersOrFault(std::string_view text, std::size_t count);

/// The unit of a depth's last digit, see WrongPoint. One of fewer than four decimals is taken for exact, as 0.5 is; one of
/// more for rounded.
double depthLastDigit(const WrittenNumber &depth);

/// That a depth lies outside the range of a picture's depths, and what to do.
std::string depthOutsideText(const std::string &depth, const geometry::DepthRange &range);

/// The columns of a table of wrong points, by their names.
constexpr std::array<std::string_view, 6> kPointColumns{"px", "py", "depth", "x", "y", "z"};

/// A row of it as it is written.
struct PointRow {
    std::array<std::string, kPointColumns.size()> cells; ///< as kPointColumns; the depth's may be empty
    std::size_t line = 0;                                ///< counted from 1, where it begins
    bool isTooLong = false; ///< there is no header, and it has more cells than columns, as decimal commas make
};
/// Why a table cannot be read.
struct PointTableError {
    enum class Kind {
        NoColumn,      ///< the header lacks `column`
        DoubledColumn, ///< the header has `column` twice
        OpenQuote,     ///< a quote is not closed
    };
    Kind kind = Kind::NoColumn;
    std::size_t line = 0;
    std::string_view column;
};
/// The rows of a table, CSV as RFC 4180 has it. With a header, whose names are found in any order and capitals; without, its columns
/// are those of kPointColumns.
geometry::Result<std::vector<PointRow>, PointTableError> pointRows(std::string_view text);

/// @return the place, in kPointColumns, of the first cell that is no number; their number where the row is too long
geometry::Result<WrongPoint, std::size_t> pointOf(const PointRow &row);

} // namespace unprojector::doctor
