// Expressions that a user may type for a number, and the errors where they are none. Expected
// numbers are literals.

#include "tests/support/test.h"

#include "core/text/expression.h"

#include <cmath>
#include <random>
#include <string>

using namespace unprojector;
using namespace unprojector::text;
using Code = ExpressionErrorCode;

Q_DECLARE_METATYPE(Code)

class TestExpression : public QObject {
    Q_OBJECT

private slots:
    void theValueIsComputed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("whole") << "12" << 12.0;
        QTest::newRow("decimal-point") << "0.25" << 0.25;
        QTest::newRow("decimal-comma") << "0,25" << 0.25;
        QTest::newRow("decimal-comma-behind-0") << "0,125" << 0.125;
        QTest::newRow("decimal-comma-behind-nothing") << ",125" << 0.125;
        QTest::newRow("two-decimals") << "1,25" << 1.25;
        QTest::newRow("four-decimals") << "1,2345" << 1.2345;
        QTest::newRow("no-thousands-have-four-digits") << "1234,567" << 1234.567;
        QTest::newRow("a-point-is-a-point") << "1.000" << 1.0;
        QTest::newRow("no-leading-zero") << ".5" << 0.5;
        QTest::newRow("nothing-after-the-point") << "5." << 5.0;
        QTest::newRow("all-digits-count") << "0.1000000000000000055511151231257827" << 0.1;
        QTest::newRow("exponent") << "-0.5e3" << -500.0;
        QTest::newRow("negative-exponent") << "1E-3" << 0.001;
        QTest::newRow("positive-exponent") << "1e+3" << 1000.0;
        QTest::newRow("smallest") << "5e-324" << 5e-324;
        QTest::newRow("blanks") << "  7 " << 7.0;
        QTest::newRow("with-its-line-end") << "7\n" << 7.0;
        QTest::newRow("with-its-line-end-crlf") << " 7\r\n" << 7.0;
        QTest::newRow("blanks-between") << " 1 / 4 " << 0.25;
        QTest::newRow("plus-sign") << "+3" << 3.0;
        QTest::newRow("two-signs") << "--3" << 3.0;
        QTest::newRow("typographic-minus") << QStringLiteral("−3.5e−1") << -0.35;
        QTest::newRow("third") << "1/3" << 0.3333333333333333;
        QTest::newRow("product") << "2*7" << 14.0;
        QTest::newRow("typographic-signs") << QStringLiteral("6×2÷3·5") << 20.0;
        QTest::newRow("product-before-sum") << "1+2*3" << 7.0;
        QTest::newRow("from-the-left") << "8-4-2" << 2.0;
        QTest::newRow("divided-from-the-left") << "8/4/2" << 1.0;
        QTest::newRow("minus-a-negative") << "2--3" << 5.0;
        QTest::newRow("times-a-negative") << "2*-3" << -6.0;
        QTest::newRow("parentheses") << "(1+2)*(3-(4+5))" << -18.0;
        QTest::newRow("sign-of-a-parenthesis") << "-(2+3)" << -5.0;
        QTest::newRow("pi") << "2*pi" << 6.283185307179586;
        QTest::newRow("pi-as-a-letter") << QStringLiteral("π/2") << 1.5707963267948966;
        QTest::newRow("root") << "sqrt(2)" << 1.4142135623730951;
        QTest::newRow("root-of-0") << "sqrt(0)" << 0.0;
        QTest::newRow("root-in-a-product") << "2 * sqrt (1+3) / 4" << 1.0;
        QTest::newRow("degrees") << "deg(pi/4)" << 45.0;
        QTest::newRow("radians") << "rad(180)" << 3.141592653589793;
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

    void whatIsNoNumberIsRefusedWithItsPlace_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<Code>("code");
        QTest::addColumn<int>("place");
        QTest::addColumn<QString>("part");
        QTest::newRow("empty") << "" << Code::Empty << 0 << "";
        QTest::newRow("blanks") << "   " << Code::Empty << 0 << "";
        QTest::newRow("word") << "abc" << Code::UnknownName << 0 << "abc";
        QTest::newRow("not-a-number") << "nan" << Code::UnknownName << 0 << "nan";
        QTest::newRow("infinity") << "-inf" << Code::UnknownName << 1 << "inf";
        QTest::newRow("name-with-a-digit") << "1+x2y" << Code::UnknownName << 2 << "x2y";
        QTest::newRow("only-a-minus") << "-" << Code::MissingNumber << 1 << "";
        QTest::newRow("only-a-point") << "." << Code::MissingNumber << 0 << ".";
        QTest::newRow("unfinished-exponent") << "1e" << Code::MissingNumber << 2 << "";
        QTest::newRow("unfinished-product") << "2*" << Code::MissingNumber << 2 << "";
        QTest::newRow("two-divisions") << "1//3" << Code::MissingNumber << 2 << "/";
        QTest::newRow("empty-parentheses") << "2*()" << Code::MissingNumber << 3 << ")";
        QTest::newRow("two-numbers") << "12 34" << Code::MissingOperator << 3 << "34";
        QTest::newRow("number-and-name") << "2pi" << Code::MissingOperator << 1 << "pi";
        QTest::newRow("number-and-parenthesis") << "2(3)" << Code::MissingOperator << 1 << "(";
        QTest::newRow("in-a-parenthesis") << "(1 2)" << Code::MissingOperator << 3 << "2";
        QTest::newRow("a-thousand-or-1") << "1,000" << Code::AmbiguousComma << 1 << ",000";
        QTest::newRow("in-a-product") << "2*12,500" << Code::AmbiguousComma << 4 << ",500";
        QTest::newRow("thousands") << "1,234.5" << Code::SecondPoint << 5 << ".";
        QTest::newRow("two-commas") << "1,2,3" << Code::SecondPoint << 3 << ",";
        QTest::newRow("two-points") << "1..2" << Code::SecondPoint << 2 << ".";
        QTest::newRow("unknown-sign") << "2^3" << Code::UnknownCharacter << 1 << "^";
        QTest::newRow("unknown-sign-first") << "$5" << Code::UnknownCharacter << 0 << "$";
        QTest::newRow("unknown-letter") << QStringLiteral("3 米") << Code::UnknownCharacter << 2
                                        << QStringLiteral("米");
        QTest::newRow("function-alone") << "sqrt 2" << Code::NotCalled << 0 << "sqrt";
        QTest::newRow("unclosed") << "2*(1+2" << Code::UnclosedParenthesis << 2 << "(";
        QTest::newRow("unopened") << "1)" << Code::UnopenedParenthesis << 1 << ")";
        QTest::newRow("unopened-first") << ")" << Code::UnopenedParenthesis << 0 << ")";
        QTest::newRow("division-by-0") << "1/(2-2)" << Code::DivisionByZero << 1 << "/";
        QTest::newRow("0-by-0") << QStringLiteral("0÷0") << Code::DivisionByZero << 1 << QStringLiteral("÷");
        QTest::newRow("root-of-a-negative") << "1+sqrt(-1)" << Code::RootOfNegative << 2 << "sqrt";
        QTest::newRow("too-large") << "2*1e999" << Code::OutOfRange << 2 << "1e999";
        QTest::newRow("too-small") << "1e-999" << Code::OutOfRange << 0 << "1e-999";
        QTest::newRow("product-too-large") << "1e300*1e300" << Code::OutOfRange << 0 << "1e300*1e300";
        QTest::newRow("too-deep") << QString(5000, u'(') << Code::TooDeep << 100 << "(";
        QTest::newRow("too-many-signs") << QString(5000, u'-') << Code::TooDeep << 100 << "-";
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
