#pragma once

#include "core/base/expected.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

namespace unprojector::base {

/// The error of an expression; ExpressionError has its position.
enum class ExpressionErrorCode {
    Empty,               ///< nothing but blanks
    MissingNumber,       ///< an operator, parenthesis or name without operand: the part found in its place
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
    TooDeep              ///< parentheses and signs nested too deep, or variables of variables that have too many
                         ///< operands in all: the position where parsing stops
};

struct ExpressionError {
    ExpressionErrorCode code;
    std::size_t place = 0;  ///< bytes from the start of the text
    std::size_t length = 0; ///< bytes; 0 at the end of the text
};

/// Called with a name; returns its value, or nothing.
using Names = std::function<std::optional<double>(std::string_view name)>;

/// Evaluates an expression that a user types for a number, UTF-8: "1/3", "2*pi", "-0.5e3",
/// "sqrt(2)".
///
/// Supports + - * / as in C, signs, and parentheses; the typographic − × · ÷; pi (π); sqrt(x);
/// deg(x) and rad(x), which convert radians to degrees and back. A decimal comma counts as a point
/// unless it could separate thousands: "1,000" is rejected, "0,125" and "1,25" are not. A lone
/// number gives the nearest double.
/// @param names  additional ones: "ndc.x * 2", "projection[2][3]". A name starts with a letter and
///         continues with letters, digits and . [ ] : without blanks. pi and the functions keep
///         their meaning.
/// @return the value, always finite; UnknownName also for a name without a value
Expected<double, ExpressionError> evaluate(std::string_view text, const Names &names = {});

/// A number in the source text of a program.
struct SourceNumber {
    double value = 0.0;
    /// The source text of a division of whole numbers with a remainder; C, C++ and C# drop the
    /// remainder.
    std::string_view wholeQuotient{};
};

/// Called with a variable, "camera.fov"; returns the text of its value, or nothing.
using Variables = std::function<std::optional<std::string_view>(std::string_view variable)>;

/// Evaluates a number in the source text of a program in C, C++, C#, JavaScript, Python or Rust.
///
/// As evaluate, but deg(x), rad(x) and the decimal comma are not supported. Supports in addition suffixes (1.0f,
/// 1d, 45_f32), casts, the libraries' names of pi and its parts (Math.PI, XM_PIDIV4,
/// glm::pi<float>()), their functions (glm::radians, XMConvertToRadians, tan, atan, 45.0.to_radians()),
/// and variables.
/// @return nothing if the text is not a number
std::optional<SourceNumber> sourceNumber(std::string_view text, const Variables &variables);

} // namespace unprojector::base
