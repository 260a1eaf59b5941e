#pragma once

#include "core/geometry/result.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

namespace unprojector::text {

/// What is wrong with an expression; ExpressionError says where.
enum class ExpressionErrorCode {
    Empty,         ///< nothing but blanks
    MissingNumber, ///< an operator, a parenthesis or a name with nothing to work on: the part that stands there instead
    MissingOperator,     ///< a number right after another one: the second
    AmbiguousComma,      ///< "1,000", which may be 1 or a thousand: the comma and what follows
    SecondPoint,         ///< "1,234.5": the second decimal point or comma
    UnknownName,         ///< the name
    UnknownCharacter,    ///< the character
    NotCalled,           ///< a function without its parenthesis: the name
    UnclosedParenthesis, ///< the parenthesis
    UnopenedParenthesis, ///< the parenthesis
    DivisionByZero,      ///< the division sign
    RootOfNegative,      ///< the name of the root
    OutOfRange,          ///< a number, or the result, that no double holds: that number, or the whole text
    TooDeep              ///< more parentheses and signs inside each other than anybody types: where it is given up
};

struct ExpressionError {
    ExpressionErrorCode code;
    std::size_t place = 0;  ///< bytes from the start of the text
    std::size_t length = 0; ///< bytes; 0 at the end of the text
};

/// The value of what a person types for a number, UTF-8: "1/3", "2*pi", "-0.5e3", "sqrt(2)".
///
/// + - * / as in C, signs, parentheses; the typographic − × · ÷ as well; pi (π); sqrt(x), deg(x) and rad(x), which turn
/// radians into degrees and back. A decimal comma is read like a point, unless it could as well
/// stand between thousands: "1,000" is refused, "0,125" and "1,25" are not. A lone number is the nearest double.
/// @return the value, always finite
geometry::Result<double, ExpressionError> evaluate(std::string_view text);

/// What a name stands for, or nothing.
using Names = std::function<std::optional<double>(std::string_view name)>;

/// The same with names besides: "ndc.x * 2", "projection[2][3]". A name starts with a letter and goes on with letters, digits and
/// . [ ] : as far as they stand together; pi and the functions stay what they are.
/// @return UnknownName as well, of a name that stands for nothing
geometry::Result<double, ExpressionError> evaluate(std::string_view text, const Names &names);

} // namespace unprojector::text
