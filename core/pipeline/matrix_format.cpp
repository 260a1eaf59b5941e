#include "core/pipeline/matrix_format.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace unprojector::pipeline {
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

/// Adds a decimal point: a literal of C, C++ and Python must not read as an integer.
std::string withPoint(const std::string &text)
{
    return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

/// The number with its power of ten written out.
std::string withPower(const std::string &text)
{
    const std::size_t e = text.find('e');
    if (e == text.npos)
        return text;
    int exponent = 0;
    const char *digitsBegin = text.data() + e + (text[e + 1] == '+' ? 2 : 1);
    std::from_chars(digitsBegin, text.data() + text.size(), exponent);
    return text.substr(0, e) + " \\cdot 10^{" + std::to_string(exponent) + "}";
}

std::string written(double value, MatrixSyntax syntax, Digits digits)
{
    const std::string text = numberText(value, digits), sign = value < 0.0 ? "-" : "";
    const bool isInfinite = text.find("inf") != text.npos;
    switch (syntax) {
    case MatrixSyntax::Text:
    case MatrixSyntax::Csv: break;
    case MatrixSyntax::CArray:
    case MatrixSyntax::Glm:
        return isInfinite ? sign + "INFINITY" : withPoint(text) + (digits == Digits::Float ? "f" : "");
    case MatrixSyntax::NumPy: return isInfinite ? sign + "np.inf" : withPoint(text);
    case MatrixSyntax::Latex: return isInfinite ? sign + "\\infty" : withPower(text);
    }
    return text;
}

/// Lines of four entries, each column aligned at its decimal points.
std::array<std::array<std::string, 4>, 4> alignedRows(const glm::dmat4 &matrix, const MatrixFormat &format)
{
    std::array<std::array<std::string, 4>, 4> rows;
    for (int column = 0; column < 4; ++column) {
        std::vector<std::string> texts;
        texts.reserve(4);
        for (int row = 0; row < 4; ++row)
            texts.push_back(written(entryAt(matrix, format.layout, row, column), format.syntax, format.digits));
        alignAtDecimalPoint(texts);
        for (std::size_t row = 0; row < 4; ++row)
            rows[row][static_cast<std::size_t>(column)] = std::move(texts[row]);
    }
    return rows;
}

/// @tparam Texts  of the entries
template <class Texts>
std::string joined(const Texts &entries, std::string_view separator)
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
std::string columnLines(const glm::dmat4 &matrix, const MatrixFormat &format)
{
    std::string lines;
    for (int column = 0; column < 4; ++column) {
        lines += "    ";
        for (int row = 0; row < 4; ++row) {
            lines += written(matrix[column][row], format.syntax, format.digits);
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
    case MatrixSyntax::Text:
        for (const auto &row : alignedRows(matrix, format))
            text += trimmedRight(joined(row, "  ")) + '\n';
        break;
    case MatrixSyntax::CArray:
        text = std::string("const ") + (isFloat ? "float " : "double ") + variable + "[16] = {\n"
               + columnLines(matrix, format) + "\n};\n";
        break;
    case MatrixSyntax::Glm:
        text = std::string("const glm::") + (isFloat ? "mat4 " : "dmat4 ") + variable + "(\n"
               + columnLines(matrix, format) + ");\n";
        break;
    case MatrixSyntax::NumPy:
        text = variable + " = np.array([\n";
        for (const auto &row : alignedRows(matrix, format))
            text += "    [" + joined(row, ", ") + "],\n";
        text += isFloat ? "], dtype=np.float32)\n" : "])\n";
        break;
    case MatrixSyntax::Latex: {
        text = "\\mathrm{" + variable + "} =\n\\begin{bmatrix}\n";
        const auto rows = alignedRows(matrix, format);
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
    std::vector<std::string> texts;
    for (const double number : numbers)
        texts.push_back(written(number, syntax, Digits::Double));
    switch (syntax) {
    case MatrixSyntax::Text: return joined(texts, " ") + '\n';
    case MatrixSyntax::Csv: return joined(texts, ",") + '\n';
    case MatrixSyntax::CArray:
    case MatrixSyntax::Glm:
        if (isAlone)
            return "const double " + variable + " = " + texts[0] + ";\n";
        return syntax == MatrixSyntax::Glm
                   ? "const glm::dvec" + count + ' ' + variable + '(' + joined(texts, ", ") + ");\n"
                   : "const double " + variable + '[' + count + "] = {" + joined(texts, ", ") + "};\n";
    case MatrixSyntax::NumPy:
        return variable + " = " + (isAlone ? texts[0] : "np.array([" + joined(texts, ", ") + "])") + '\n';
    case MatrixSyntax::Latex:
        return "\\mathrm{" + variable + "} = "
               + (isAlone ? texts[0] : "\\begin{bmatrix} " + joined(texts, " \\\\ ") + " \\end{bmatrix}") + '\n';
    }
    return {};
}

} // namespace unprojector::pipeline
