#include "core/matrices/matrix_format.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace unprojector::matrices {
namespace {

/// The shortest form of a double has at most 24 characters.
constexpr std::size_t kNumberLength = 64;

template <class Number>
std::string charsOf(Number value, int significant)
{
    char buffer[kNumberLength];
    char *const end = buffer + kNumberLength;
    const std::to_chars_result result =
        significant > 0 ? std::to_chars(buffer, end, value, std::chars_format::general, significant)
        : base::isWrittenOut(static_cast<double>(value)) ? std::to_chars(buffer, end, value, std::chars_format::fixed)
                                                         : std::to_chars(buffer, end, value);
    return {buffer, result.ptr};
}

/// The double in single precision; infinity beyond its range, where the language leaves the
/// conversion undefined.
float rounded(double value)
{
    if (std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()) || !std::isfinite(value))
        return static_cast<float>(value);
    return std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(std::copysign(1.0, value)));
}

bool isInfinite(const std::string &text)
{
    return text.find("inf") != std::string::npos;
}

/// Adds a decimal point: a literal of C, C++ and Python must not read as an integer.
std::string withPoint(std::string text)
{
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text;
}

std::string cNumber(double value, Digits digits)
{
    const std::string text = numberText(value, digits);
    if (isInfinite(text))
        return value < 0.0 ? "-INFINITY" : "INFINITY";
    return withPoint(text) + (digits == Digits::Float ? "f" : "");
}

std::string numPyNumber(double value, Digits digits)
{
    const std::string text = numberText(value, digits);
    if (isInfinite(text))
        return value < 0.0 ? "-np.inf" : "np.inf";
    return withPoint(text);
}

std::string latexNumber(double value, Digits digits)
{
    std::string text = numberText(value, digits);
    if (isInfinite(text))
        return value < 0.0 ? "-\\infty" : "\\infty";
    const std::size_t e = text.find('e');
    if (e == std::string::npos)
        return text;
    int exponent = 0;
    const char *digitsBegin = text.data() + e + (text[e + 1] == '+' ? 2 : 1);
    std::from_chars(digitsBegin, text.data() + text.size(), exponent);
    return text.substr(0, e) + " \\cdot 10^{" + std::to_string(exponent) + "}";
}

using NumberWriter = std::string (*)(double, Digits);

/// Lines of four entries, each column aligned at its decimal points.
std::array<std::array<std::string, 4>, 4> alignedRows(const glm::dmat4 &matrix, MatrixLayout layout, Digits digits,
                                                      NumberWriter write)
{
    std::array<std::array<std::string, 4>, 4> rows;
    for (int column = 0; column < 4; ++column) {
        std::vector<std::string> texts;
        texts.reserve(4);
        for (int row = 0; row < 4; ++row)
            texts.push_back(write(entryAt(matrix, layout, row, column), digits));
        alignAtDecimalPoint(texts);
        for (std::size_t row = 0; row < 4; ++row)
            rows[row][static_cast<std::size_t>(column)] = std::move(texts[row]);
    }
    return rows;
}

std::string joined(const std::array<std::string, 4> &entries, std::string_view separator)
{
    std::string line;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i > 0)
            line += separator;
        line += entries[i];
    }
    return line;
}

std::string trimmedRight(std::string line)
{
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

/// Four numbers a line, one line a column of the matrix, as OpenGL and GLM take them.
std::string columnLines(const glm::dmat4 &matrix, Digits digits)
{
    std::string lines;
    for (int column = 0; column < 4; ++column) {
        lines += "    ";
        for (int row = 0; row < 4; ++row) {
            lines += cNumber(matrix[column][row], digits);
            if (row < 3)
                lines += ", ";
        }
        lines += column < 3 ? ",\n" : "";
    }
    return lines;
}

} // namespace

std::array<double, 16> memoryOrder(const glm::dmat4 &matrix)
{
    std::array<double, 16> m{};
    for (int i = 0; i < 16; ++i)
        m[static_cast<std::size_t>(i)] = matrix[i / 4][i % 4];
    return m;
}

double entryAt(const glm::dmat4 &matrix, MatrixLayout layout, int row, int column)
{
    return layout == MatrixLayout::Column ? matrix[column][row] : matrix[row][column];
}

std::string numberText(double value, Digits digits, int significant)
{
    std::string text = digits == Digits::Float ? charsOf(rounded(value), significant) : charsOf(value, significant);
    return text == "-0" ? "0" : text;
}

std::size_t alignAtDecimalPoint(std::vector<std::string> &texts)
{
    const auto wholeLength = [](const std::string &text) { return std::min(text.find_first_of(". e"), text.size()); };
    std::size_t whole = 0, rest = 0;
    for (const std::string &text : texts) {
        whole = std::max(whole, wholeLength(text));
        rest = std::max(rest, text.size() - wholeLength(text));
    }
    for (std::string &text : texts) {
        const std::size_t before = whole - wholeLength(text);
        text.insert(0, before, ' ');
        text.resize(whole + rest, ' ');
    }
    return whole;
}

std::string formatted(const glm::dmat4 &matrix, const MatrixFormat &format, std::string_view name)
{
    const bool isFloat = format.digits == Digits::Float;
    const std::string variable(name);
    std::string text;
    switch (format.syntax) {
    case MatrixSyntax::Text: {
        const auto plain = [](double value, Digits digits) { return numberText(value, digits); };
        for (const auto &row : alignedRows(matrix, format.layout, format.digits, plain))
            text += trimmedRight(joined(row, "  ")) + '\n';
        break;
    }
    case MatrixSyntax::CArray:
        text = std::string("const ") + (isFloat ? "float " : "double ") + variable + "[16] = {\n"
               + columnLines(matrix, format.digits) + "\n};\n";
        break;
    case MatrixSyntax::Glm:
        text = std::string("const glm::") + (isFloat ? "mat4 " : "dmat4 ") + variable + "(\n"
               + columnLines(matrix, format.digits) + ");\n";
        break;
    case MatrixSyntax::NumPy: {
        text = variable + " = np.array([\n";
        for (const auto &row : alignedRows(matrix, format.layout, format.digits, numPyNumber))
            text += "    [" + joined(row, ", ") + "],\n";
        text += isFloat ? "], dtype=np.float32)\n" : "])\n";
        break;
    }
    case MatrixSyntax::Latex: {
        text = "\\mathrm{" + variable + "} =\n\\begin{bmatrix}\n";
        const auto rows = alignedRows(matrix, format.layout, format.digits, latexNumber);
        for (std::size_t row = 0; row < rows.size(); ++row)
            text += "  " + trimmedRight(joined(rows[row], " & ")) + (row + 1 < rows.size() ? " \\\\\n" : "\n");
        text += "\\end{bmatrix}\n";
        break;
    }
    case MatrixSyntax::Csv:
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column)
                text +=
                    (column > 0 ? "," : "") + numberText(entryAt(matrix, format.layout, row, column), format.digits);
            text += '\n';
        }
        break;
    }
    return text;
}

std::string formatted(const std::vector<double> &numbers, MatrixSyntax syntax, std::string_view name)
{
    const std::string variable(name), count = std::to_string(numbers.size());
    const bool isAlone = numbers.size() == 1;
    const auto listed = [&numbers](NumberWriter write, std::string_view separator) {
        std::string list;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            list += (i > 0 ? std::string(separator) : std::string()) + write(numbers[i], Digits::Double);
        return list;
    };
    const auto plain = [](double value, Digits digits) { return numberText(value, digits); };
    switch (syntax) {
    case MatrixSyntax::Text: return listed(plain, " ") + '\n';
    case MatrixSyntax::Csv: return listed(plain, ",") + '\n';
    case MatrixSyntax::CArray:
        return "const double " + variable
               + (isAlone ? " = " + listed(cNumber, "") : "[" + count + "] = {" + listed(cNumber, ", ") + "}") + ";\n";
    case MatrixSyntax::Glm:
        return isAlone ? "const double " + variable + " = " + listed(cNumber, "") + ";\n"
                       : "const glm::dvec" + count + ' ' + variable + '(' + listed(cNumber, ", ") + ");\n";
    case MatrixSyntax::NumPy:
        return variable + " = " + (isAlone ? listed(numPyNumber, "") : "np.array([" + listed(numPyNumber, ", ") + "])")
               + '\n';
    case MatrixSyntax::Latex:
        return "\\mathrm{" + variable + "} = "
               + (isAlone ? listed(latexNumber, "")
                          : "\\begin{bmatrix} " + listed(latexNumber, " \\\\ ") + " \\end{bmatrix}")
               + '\n';
    }
    return {};
}

} // namespace unprojector::matrices
