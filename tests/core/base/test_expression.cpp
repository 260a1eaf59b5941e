// Expressions that a user may type for a number, and the errors where they are none. Expected
// numbers are literals.

#include "tests/support/test.h"

#include "core/base/expression.h"
#include "core/base/source_text.h"

#include <cmath>
#include <random>
#include <string>

using namespace unprojector;
using namespace unprojector::base;
using Code = ExpressionErrorCode;

Q_DECLARE_METATYPE(Code)

namespace {

/// The variables of a program.
Variables variables()
{
    return [](std::string_view name) -> std::optional<std::string_view> {
        if (name == "camera.fov")
            return "60.0";
        if (name == "half")
            return "camera.fov / 2";
        if (name == "width")
            return "800";
        if (name == "height")
            return "600";
        return name == "itself" ? std::optional<std::string_view>("itself + 1") : std::nullopt;
    };
}

} // namespace

class TestExpression : public QObject {
    Q_OBJECT

private slots:
    void theValueIsComputed_data()
    {
        addColumn<QString>("text");
        addColumn<double>("value");
        newRow("whole") << "12" << 12.0;
        newRow("decimal-point") << "0.25" << 0.25;
        newRow("decimal-comma") << "0,25" << 0.25;
        newRow("decimal-comma-behind-0") << "0,125" << 0.125;
        newRow("decimal-comma-behind-nothing") << ",125" << 0.125;
        newRow("two-decimals") << "1,25" << 1.25;
        newRow("four-decimals") << "1,2345" << 1.2345;
        newRow("no-thousands-have-four-digits") << "1234,567" << 1234.567;
        newRow("a-point-is-a-point") << "1.000" << 1.0;
        newRow("no-leading-zero") << ".5" << 0.5;
        newRow("nothing-after-the-point") << "5." << 5.0;
        newRow("all-digits-count") << "0.1000000000000000055511151231257827" << 0.1;
        newRow("exponent") << "-0.5e3" << -500.0;
        newRow("negative-exponent") << "1E-3" << 0.001;
        newRow("positive-exponent") << "1e+3" << 1000.0;
        newRow("smallest") << "5e-324" << 5e-324;
        newRow("blanks") << "  7 " << 7.0;
        newRow("with-its-line-end") << "7\n" << 7.0;
        newRow("with-its-line-end-crlf") << " 7\r\n" << 7.0;
        newRow("blanks-between") << " 1 / 4 " << 0.25;
        newRow("plus-sign") << "+3" << 3.0;
        newRow("two-signs") << "--3" << 3.0;
        newRow("typographic-minus") << QStringLiteral("−3.5e−1") << -0.35;
        newRow("third") << "1/3" << 0.3333333333333333;
        newRow("product") << "2*7" << 14.0;
        newRow("typographic-signs") << QStringLiteral("6×2÷3·5") << 20.0;
        newRow("product-before-sum") << "1+2*3" << 7.0;
        newRow("from-the-left") << "8-4-2" << 2.0;
        newRow("divided-from-the-left") << "8/4/2" << 1.0;
        newRow("minus-a-negative") << "2--3" << 5.0;
        newRow("times-a-negative") << "2*-3" << -6.0;
        newRow("parentheses") << "(1+2)*(3-(4+5))" << -18.0;
        newRow("sign-of-a-parenthesis") << "-(2+3)" << -5.0;
        newRow("pi") << "2*pi" << 6.283185307179586;
        newRow("pi-as-a-letter") << QStringLiteral("π/2") << 1.5707963267948966;
        newRow("root") << "sqrt(2)" << 1.4142135623730951;
        newRow("root-of-0") << "sqrt(0)" << 0.0;
        newRow("root-in-a-product") << "2 * sqrt (1+3) / 4" << 1.0;
        newRow("degrees") << "deg(pi/4)" << 45.0;
        newRow("radians") << "rad(180)" << 3.141592653589793;
    }

    void theValueIsComputed()
    {
        QFETCH(QString, text);
        QFETCH(double, value);
        const auto result = evaluate(text.toStdString());
        QVERIFY2(result, qPrintable(text));
        QVERIFY2(*result == value, qPrintable(QString::number(*result, 'g', 17)));
    }

    void namesStandForNumbers()
    {
        const Names names = [](std::string_view name) -> std::optional<double> {
            if (name == "a.b[2][3]")
                return 6.0;
            return name == "step:x" ? std::optional(0.5) : std::nullopt;
        };
        QCOMPARE(evaluate("-2 * (a.b[2][3] - step:x) + sqrt(4)", names).value(), -9.0);
        QCOMPARE(evaluate("pi", names).value(), evaluate("pi").value());
        const auto unknown = evaluate("1 + a.b[2]*3", names);
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().code, ExpressionErrorCode::UnknownName);
        QCOMPARE(unknown.error().place, std::size_t(4));
        QCOMPARE(unknown.error().length, std::size_t(6));
        QVERIFY(!evaluate("step:x"));
    }

    void numbersOfAProgramAreRead_data()
    {
        addColumn<QString>("text");
        addColumn<double>("value");
        newRow("float") << "1.5f" << 1.5;
        newRow("double-of-c#") << "2d" << 2.0;
        newRow("rust") << "0.5_f32" << 0.5;
        newRow("rust-degrees") << "180.0_f64.to_radians()" << 3.141592653589793;
        newRow("cast") << "(GLfloat)3 / 2" << 1.5;
        newRow("cast-to-whole") << "(int)1.75 * 2" << 2.0;
        newRow("cast-by-name") << "static_cast<float>(1 + 2)" << 3.0;
        newRow("pi") << "Math.PI" << 3.141592653589793;
        newRow("part-of-pi") << "DirectX::XM_PIDIV4" << 0.7853981633974483;
        newRow("pi-by-call") << "glm::half_pi<float>()" << 1.5707963267948966;
        newRow("radians") << "glm::radians(180)" << 3.141592653589793;
        newRow("factor") << "180 * DEG2RAD" << 3.141592653589793;
        newRow("variable") << "camera.fov / 2" << 30.0;
        newRow("variable-of-a-variable") << "-half" << -30.0;
    }

    void numbersOfAProgramAreRead()
    {
        QFETCH(QString, text);
        QFETCH(double, value);
        const auto number = sourceNumber(text.toStdString(), variables());
        QVERIFY2(number, qPrintable(text));
        QVERIFY2(number->value == value, qPrintable(QString::number(number->value, 'g', 17)));
        QVERIFY(number->wholeQuotient.empty());
    }

    void aWholeQuotientIsReported()
    {
        const auto quotient = [](const char *text) {
            const auto number = sourceNumber(text, variables());
            return number ? std::string(number->wholeQuotient) : "none";
        };
        QCOMPARE(quotient("800 / 600 "), "800 / 600");
        QCOMPARE(quotient("1 + 800L/600 * 2"), "800L/600");
        QCOMPARE(quotient("width / height"), "width / height");
        QCOMPARE(quotient("800 / 400"), "");
        QCOMPARE(quotient("800 / 600."), "");
        QCOMPARE(quotient("800 / 600f"), "");
        QCOMPARE(quotient("(float)800 / 600"), "");
    }

    void fieldsAndProgramsDiffer()
    {
        for (const char *text : {"1f", "(float)1", "M_PI", "radians(1)", "tan(1)", "tau", "width"})
            QVERIFY2(!evaluate(text), text);
        for (const char *text :
             {"0,5", "deg(1)", "rad(1)", "itself", "twice", "1_000", "2(3)", "1/0", "", "pi(1)", "tan"})
            QVERIFY2(!sourceNumber(text, variables()), text);
    }

    /// Six variables, each the sum of twenty times the next one.
    void variablesOfVariablesEnd()
    {
        std::string sum = "next";
        for (int i = 1; i < 20; ++i)
            sum += "+next";
        int asked = 0;
        const Variables deep = [&](std::string_view name) -> std::optional<std::string_view> {
            ++asked;
            return name == "next" ? std::optional<std::string_view>(sum) : std::nullopt;
        };
        QVERIFY(!sourceNumber("next", deep));
        QVERIFY(asked <= 1000);
        const Variables flat = [](std::string_view) { return std::optional<std::string_view>("2"); };
        QCOMPARE(sourceNumber(sum, flat).value().value, 40.0);
        std::string longer = sum;
        for (int i = 1; i < 60; ++i)
            longer += '+' + sum;
        QVERIFY(!sourceNumber(longer, flat));
    }

    void assignmentsInAssignmentsAreFound()
    {
        const auto valuesOf = [](const std::string &text) {
            std::string values;
            for (const SourceCall &call : sourceCalls(text))
                values +=
                    std::string(call.written) + ':' + (call.isAssignment ? std::string(call.arguments[0]) : "") + ' ';
            return values;
        };
        QCOMPARE(valuesOf("a = b = 5; c = (1, 2), d =\n"), "a:b = 5 b:5 c:(1, 2) ");
        const std::string digits(500, '1');
        QCOMPARE(valuesOf("a = " + digits), "a:" + digits + ' ');
        QCOMPARE(valuesOf("a = b = " + digits), "a:b = " + digits + ' ');
        std::string chain;
        while (chain.size() < 400000)
            chain += "a=";
        QCOMPARE(sourceCalls(chain + '1').size(), std::size_t(201));
    }

    void whatIsNoNumberIsRefusedWithItsPlace_data()
    {
        addColumn<QString>("text");
        addColumn<Code>("code");
        addColumn<int>("place");
        addColumn<QString>("part");
        newRow("empty") << "" << Code::Empty << 0 << "";
        newRow("blanks") << "   " << Code::Empty << 0 << "";
        newRow("word") << "abc" << Code::UnknownName << 0 << "abc";
        newRow("not-a-number") << "nan" << Code::UnknownName << 0 << "nan";
        newRow("infinity") << "-inf" << Code::UnknownName << 1 << "inf";
        newRow("name-with-a-digit") << "1+x2y" << Code::UnknownName << 2 << "x2y";
        newRow("only-a-minus") << "-" << Code::MissingNumber << 1 << "";
        newRow("only-a-point") << "." << Code::MissingNumber << 0 << ".";
        newRow("unfinished-exponent") << "1e" << Code::MissingNumber << 2 << "";
        newRow("unfinished-product") << "2*" << Code::MissingNumber << 2 << "";
        newRow("two-divisions") << "1//3" << Code::MissingNumber << 2 << "/";
        newRow("empty-parentheses") << "2*()" << Code::MissingNumber << 3 << ")";
        newRow("two-numbers") << "12 34" << Code::MissingOperator << 3 << "34";
        newRow("number-and-name") << "2pi" << Code::MissingOperator << 1 << "pi";
        newRow("number-and-parenthesis") << "2(3)" << Code::MissingOperator << 1 << "(";
        newRow("in-a-parenthesis") << "(1 2)" << Code::MissingOperator << 3 << "2";
        newRow("a-thousand-or-1") << "1,000" << Code::AmbiguousComma << 1 << ",000";
        newRow("in-a-product") << "2*12,500" << Code::AmbiguousComma << 4 << ",500";
        newRow("thousands") << "1,234.5" << Code::SecondPoint << 5 << ".";
        newRow("two-commas") << "1,2,3" << Code::SecondPoint << 3 << ",";
        newRow("two-points") << "1..2" << Code::SecondPoint << 2 << ".";
        newRow("unknown-sign") << "2^3" << Code::UnknownCharacter << 1 << "^";
        newRow("unknown-sign-first") << "$5" << Code::UnknownCharacter << 0 << "$";
        newRow("unknown-letter") << QStringLiteral("3 米") << Code::UnknownCharacter << 2 << QStringLiteral("米");
        newRow("function-alone") << "sqrt 2" << Code::NotCalled << 0 << "sqrt";
        newRow("unclosed") << "2*(1+2" << Code::UnclosedParenthesis << 2 << "(";
        newRow("unopened") << "1)" << Code::UnopenedParenthesis << 1 << ")";
        newRow("unopened-first") << ")" << Code::UnopenedParenthesis << 0 << ")";
        newRow("division-by-0") << "1/(2-2)" << Code::DivisionByZero << 1 << "/";
        newRow("0-by-0") << QStringLiteral("0÷0") << Code::DivisionByZero << 1 << QStringLiteral("÷");
        newRow("root-of-a-negative") << "1+sqrt(-1)" << Code::RootOfNegative << 2 << "sqrt";
        newRow("too-large") << "2*1e999" << Code::OutOfRange << 2 << "1e999";
        newRow("too-small") << "1e-999" << Code::OutOfRange << 0 << "1e-999";
        newRow("product-too-large") << "1e300*1e300" << Code::OutOfRange << 0 << "1e300*1e300";
        newRow("too-deep") << QString(5000, u'(') << Code::TooDeep << 100 << "(";
        newRow("too-many-signs") << QString(5000, u'-') << Code::TooDeep << 100 << "-";
    }

    void whatIsNoNumberIsRefusedWithItsPlace()
    {
        QFETCH(QString, text);
        const auto result = evaluate(text.toStdString());
        QVERIFY2(!result, qPrintable(text));
        const ExpressionError error = result.error();
        QTEST(error.code, "code");
        QTEST(static_cast<int>(error.place), "place");
        QTEST(QString::fromStdString(text.toStdString().substr(error.place, error.length)), "part");
    }

    void anyTextIsEitherANumberOrRefusedInside()
    {
        const char *const kParts[] = {"1",  "2.5",  "-", "+", "*", "/",        "(",   ")",
                                      "pi", "sqrt", "e", ",", " ", "\xe2\x88", "\xff"};
        std::mt19937 random(1);
        for (int i = 0; i < 20000; ++i) {
            std::string text;
            for (auto parts = random() % 12; parts > 0; --parts)
                text += kParts[random() % std::size(kParts)];
            const auto result = evaluate(text);
            if (result)
                QVERIFY(std::isfinite(*result));
            else
                QVERIFY2(result.error().place + result.error().length <= text.size(), text.c_str());
        }
    }
};

UNPROJECTOR_TEST(TestExpression)
#include "test_expression.moc"
