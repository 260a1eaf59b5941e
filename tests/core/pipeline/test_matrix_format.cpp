// Matrices as text: exact strings.

#include "tests/support/test.h"

#include "core/pipeline/matrix_format.h"

#include <limits>

using namespace unprojector;
using namespace unprojector::pipeline;

Q_DECLARE_METATYPE(MatrixFormat)

namespace {

/// A matrix whose entries identify their row and column. Some need all digits of a double, or an
/// exponent.
glm::dmat4 example()
{
    glm::dmat4 m(0.0);
    m[0][0] = 0.1;
    m[1][1] = -12.5;
    m[2][2] = 1e-17;
    m[3] = {2, -3, -1.0 / 3.0, 1};
    return m;
}

} // namespace

class TestMatrixFormat : public QObject {
    Q_OBJECT

private slots:
    void numbersAreFormatted_data()
    {
        addColumn<std::vector<double>>("numbers");
        addColumn<MatrixSyntax>("syntax");
        addColumn<std::string>("expected");
        const std::vector<double> point{1.5, -2.0, 1e-17}, alone{0.1};
        using enum MatrixSyntax;
        newRow("text") << point << Text << std::string("1.5 -2 1e-17\n");
        newRow("C") << point << CArray << std::string("const double p[3] = {1.5, -2.0, 1e-17};\n");
        newRow("GLM") << point << Glm << std::string("const glm::dvec3 p(1.5, -2.0, 1e-17);\n");
        newRow("NumPy") << point << NumPy << std::string("p = np.array([1.5, -2.0, 1e-17])\n");
        newRow("LaTeX") << point << Latex
                        << std::string(
                               "\\mathrm{p} = \\begin{bmatrix} 1.5 \\\\ -2 \\\\ 1 \\cdot 10^{-17} \\end{bmatrix}\n");
        newRow("CSV") << point << Csv << std::string("1.5,-2,1e-17\n");
        newRow("text, alone") << alone << Text << std::string("0.1\n");
        newRow("C, alone") << alone << CArray << std::string("const double p = 0.1;\n");
        newRow("GLM, alone") << alone << Glm << std::string("const double p = 0.1;\n");
        newRow("NumPy, alone") << alone << NumPy << std::string("p = 0.1\n");
        newRow("LaTeX, alone") << alone << Latex << std::string("\\mathrm{p} = 0.1\n");
        newRow("GLM, two") << std::vector{3.0, 4.0} << Glm << std::string("const glm::dvec2 p(3.0, 4.0);\n");
    }

    void numbersAreFormatted()
    {
        QFETCH(std::vector<double>, numbers);
        QFETCH(MatrixSyntax, syntax);
        QFETCH(std::string, expected);
        QCOMPARE(formatted(numbers, syntax, "p"), expected);
    }

    void aMatrixIsFourLinesOfCommas()
    {
        glm::dmat4 matrix(1.0);
        matrix[3][0] = 0.1;
        QCOMPARE(formatted(matrix, {MatrixSyntax::Csv, MatrixLayout::Column, Digits::Double}, "m"),
                 std::string("1,0,0,0.1\n0,1,0,0\n0,0,1,0\n0,0,0,1\n"));
        QCOMPARE(formatted(matrix, {MatrixSyntax::Csv, MatrixLayout::Row, Digits::Double}, "m"),
                 std::string("1,0,0,0\n0,1,0,0\n0,0,1,0\n0.1,0,0,1\n"));
    }

    void numbersHaveTheFewestDigitsThatComeBack_data()
    {
        addColumn<double>("value");
        addColumn<bool>("isFloat");
        addColumn<int>("significant");
        addColumn<QString>("text");
        newRow("tenth") << 0.1 << false << 0 << "0.1";
        newRow("tenth, float") << 0.1 << true << 0 << "0.1";
        newRow("all digits") << 0.1 + 0.2 << false << 0 << "0.30000000000000004";
        newRow("all digits, float") << 0.1 + 0.2 << true << 0 << "0.3";
        newRow("fig. 2.12 as the watch window has it") << 2.414213562373095 << true << 0 << "2.4142137";
        newRow("six digits") << 2.414213562373095 << false << 6 << "2.41421";
        newRow("six digits, zeros dropped") << 2.5 << false << 6 << "2.5";
        newRow("six digits, large") << -1234567.0 << false << 6 << "-1.23457e+06";
        newRow("negative zero") << -0.0 << false << 0 << "0";
        newRow("negative zero, six digits") << -0.0 << false << 6 << "0";
        newRow("too small for float") << -1e-60 << true << 0 << "0";
        newRow("too large for float") << -1e60 << true << 0 << "-inf";
        newRow("largest double") << std::numeric_limits<double>::max() << false << 0 << "1.7976931348623157e+308";
    }

    void numbersHaveTheFewestDigitsThatComeBack()
    {
        QFETCH(double, value);
        QFETCH(bool, isFloat);
        QFETCH(int, significant);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(numberText(value, isFloat ? Digits::Float : Digits::Double, significant)),
                 text);
    }

    void decimalPointsLieUnderEachOther()
    {
        std::vector<std::string> texts{"0.1", "-12.5", "1e-17", "2", "-0.333"};
        QCOMPARE(alignAtDecimalPoint(texts), std::size_t(3));
        QCOMPARE(texts, (std::vector<std::string>{"  0.1  ", "-12.5  ", "  1e-17", "  2    ", " -0.333"}));
        std::vector<std::string> none;
        QCOMPARE(alignAtDecimalPoint(none), std::size_t(0));
        QVERIFY(none.empty());
    }

    void aTranslationEndsTheMemoryAndTheLastRowOfRowVectors()
    {
        const glm::dmat4 m = example();
        QCOMPARE(memoryOrder(m)[12], 2.0);
        QCOMPARE(memoryOrder(m)[13], -3.0);
        QCOMPARE(entryAt(m, MatrixLayout::Column, 0, 3), 2.0);
        QCOMPARE(entryAt(m, MatrixLayout::Row, 3, 0), 2.0);
        QCOMPARE(entryAt(m, MatrixLayout::Row, 0, 3), 0.0);
    }

    void everySyntaxIsWrittenExactly_data()
    {
        addColumn<MatrixFormat>("format");
        addColumn<QString>("text");

        const auto column = MatrixLayout::Column, row = MatrixLayout::Row;
        newRow("text") << MatrixFormat{MatrixSyntax::Text, column, Digits::Double}
                       << "0.1    0    0       2\n"
                          "0    -12.5  0      -3\n"
                          "0      0    1e-17  -0.3333333333333333\n"
                          "0      0    0       1\n";
        newRow("text, rows") << MatrixFormat{MatrixSyntax::Text, row, Digits::Double}
                             << "0.1    0     0                   0\n"
                                "0    -12.5   0                   0\n"
                                "0      0     1e-17               0\n"
                                "2     -3    -0.3333333333333333  1\n";
        const char *cArray = "const double clipFromEye[16] = {\n"
                             "    0.1, 0.0, 0.0, 0.0,\n"
                             "    0.0, -12.5, 0.0, 0.0,\n"
                             "    0.0, 0.0, 1e-17, 0.0,\n"
                             "    2.0, -3.0, -0.3333333333333333, 1.0\n"
                             "};\n";
        newRow("C array") << MatrixFormat{MatrixSyntax::CArray, column, Digits::Double} << cArray;
        newRow("C array, rows: the same memory") << MatrixFormat{MatrixSyntax::CArray, row, Digits::Double} << cArray;
        newRow("C array, float") << MatrixFormat{MatrixSyntax::CArray, column, Digits::Float}
                                 << "const float clipFromEye[16] = {\n"
                                    "    0.1f, 0.0f, 0.0f, 0.0f,\n"
                                    "    0.0f, -12.5f, 0.0f, 0.0f,\n"
                                    "    0.0f, 0.0f, 1e-17f, 0.0f,\n"
                                    "    2.0f, -3.0f, -0.33333334f, 1.0f\n"
                                    "};\n";
        newRow("GLM") << MatrixFormat{MatrixSyntax::Glm, column, Digits::Double}
                      << "const glm::dmat4 clipFromEye(\n"
                         "    0.1, 0.0, 0.0, 0.0,\n"
                         "    0.0, -12.5, 0.0, 0.0,\n"
                         "    0.0, 0.0, 1e-17, 0.0,\n"
                         "    2.0, -3.0, -0.3333333333333333, 1.0);\n";
        newRow("GLM, float") << MatrixFormat{MatrixSyntax::Glm, column, Digits::Float}
                             << "const glm::mat4 clipFromEye(\n"
                                "    0.1f, 0.0f, 0.0f, 0.0f,\n"
                                "    0.0f, -12.5f, 0.0f, 0.0f,\n"
                                "    0.0f, 0.0f, 1e-17f, 0.0f,\n"
                                "    2.0f, -3.0f, -0.33333334f, 1.0f);\n";
        newRow("NumPy") << MatrixFormat{MatrixSyntax::NumPy, column, Digits::Double}
                        << "clipFromEye = np.array([\n"
                           "    [0.1,   0.0, 0.0  ,  2.0               ],\n"
                           "    [0.0, -12.5, 0.0  , -3.0               ],\n"
                           "    [0.0,   0.0, 1e-17, -0.3333333333333333],\n"
                           "    [0.0,   0.0, 0.0  ,  1.0               ],\n"
                           "])\n";
        newRow("NumPy, rows, float") << MatrixFormat{MatrixSyntax::NumPy, row, Digits::Float}
                                     << "clipFromEye = np.array([\n"
                                        "    [0.1,   0.0,  0.0       , 0.0],\n"
                                        "    [0.0, -12.5,  0.0       , 0.0],\n"
                                        "    [0.0,   0.0,  1e-17     , 0.0],\n"
                                        "    [2.0,  -3.0, -0.33333334, 1.0],\n"
                                        "], dtype=np.float32)\n";
        newRow("LaTeX") << MatrixFormat{MatrixSyntax::Latex, column, Digits::Float}
                        << "\\mathrm{clipFromEye} =\n"
                           "\\begin{bmatrix}\n"
                           "  0.1 &   0   & 0                &  2 \\\\\n"
                           "  0   & -12.5 & 0                & -3 \\\\\n"
                           "  0   &   0   & 1 \\cdot 10^{-17} & -0.33333334 \\\\\n"
                           "  0   &   0   & 0                &  1\n"
                           "\\end{bmatrix}\n";
    }

    void everySyntaxIsWrittenExactly()
    {
        QFETCH(MatrixFormat, format);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(formatted(example(), format, "clipFromEye")), text);
    }

    void infinityIsWrittenAsTheSyntaxHasIt()
    {
        glm::dmat4 m(1.0);
        m[0][0] = -1e300;
        const auto text = [&](MatrixSyntax syntax) {
            return QString::fromStdString(formatted(m, {syntax, MatrixLayout::Column, Digits::Float}, "m"));
        };
        QVERIFY(text(MatrixSyntax::CArray).contains(QStringLiteral("    -INFINITY, 0.0f")));
        QVERIFY(text(MatrixSyntax::NumPy).contains(QStringLiteral("-np.inf")));
        QVERIFY(text(MatrixSyntax::Latex).contains(QStringLiteral("-\\infty")));
    }
};

UNPROJECTOR_TEST(TestMatrixFormat)
#include "test_matrix_format.moc"
