#pragma once

#include <glm/mat4x4.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::pipeline {

/// The vector convention: columns, M * v (OpenGL), or rows, v * M (opencascade-transforms), where
/// every matrix is transposed and products are in reverse order.
enum class MatrixLayout { Column, Row };

/// Double: all digits. Float: the entry after rounding to single precision, as glGetFloatv returns
/// it.
enum class Digits { Double, Float };

enum class MatrixSyntax { Text, CArray, Glm, NumPy, Latex, Csv };

struct MatrixFormat {
    MatrixSyntax syntax = MatrixSyntax::Text;
    MatrixLayout layout = MatrixLayout::Column;
    Digits digits = Digits::Double;
};

/// The entries as OpenGL stores them: m[4 * column + row], the translation in m[12..14]. A
/// row-vector matrix stored row by row has the same sixteen numbers.
std::array<double, 16> memoryOrder(const glm::dmat4 &matrix);

/// The entry at a row and column of a layout, both counted from 0.
double entryAt(const glm::dmat4 &matrix, MatrixLayout layout, int row, int column);

/// The fewest digits that read back to the same double (or float): "0.1", "1e-17"; 0 for -0.
/// @param significant  at most this many significant digits, trailing zeros dropped; 0: as many as
///         needed
std::string numberText(double value, Digits digits, int significant = 0);

/// Pads the texts with blanks on both sides to equal length, and aligns their decimal points (or
/// the last digits of whole numbers).
/// @return characters before the decimal points
std::size_t alignAtDecimalPoint(std::vector<std::string> &texts);

/// Formats a matrix for the clipboard or the command line, ending in a newline. `name` is the
/// variable's name; Text and Csv don't use it.
///
///   Text    four aligned lines in the layout
///   CArray  const double name[16] = {…}; the memory order in either layout
///   Glm     const glm::dmat4 name(…); columns of the column-vector matrix in either layout
///   NumPy   name = np.array([[…]]) in the layout
///   Latex   name = \begin{bmatrix}…\end{bmatrix} in the layout, powers of ten written out
///   Csv     four lines of four numbers in the layout, separated by commas
///
/// With float digits the types are float, glm::mat4 and np.float32. An entry beyond the range of
/// float is written in the syntax's notation for infinity.
/// @pre the entries are not NaN
std::string formatted(const glm::dmat4 &matrix, const MatrixFormat &format, std::string_view name);

/// Formats a point, or a single number, on one line that ends in a newline, with all digits of the
/// doubles:
///
///   Text    1.5 2 3
///   CArray  const double name[3] = {1.5, 2.0, 3.0};
///   Glm     const glm::dvec3 name(1.5, 2.0, 3.0);
///   NumPy   name = np.array([1.5, 2.0, 3.0])
///   Latex   \mathrm{name} = \begin{bmatrix} 1.5 \\ 2 \\ 3 \end{bmatrix}
///   Csv     1.5,2,3
///
/// A single number is not an array: const double name = 1.5; name = 1.5.
/// @pre one to four numbers, none of them NaN
std::string formatted(const std::vector<double> &numbers, MatrixSyntax syntax, std::string_view name);

} // namespace unprojector::pipeline
