// The arithmetic that carries the closed form, against 50 digits.

#include "tests/support/test.h"

#include "core/geometry/numbers.h"
#include "core/geometry/unit_in_last_place.h"
#include "tests/support/oracle.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

using namespace unprojector;
using namespace unprojector::geometry;
using oracle::Extended;

namespace {

using Operation = std::function<DoubleDouble(const DoubleDouble &, const DoubleDouble &)>;
using Truth = std::function<Extended(const Extended &, const Extended &)>;

Extended exact(const DoubleDouble &number)
{
    return Extended(number.value) + number.rest;
}

/// @return |actual - truth|, as a share of `scale`
double share(const DoubleDouble &actual, const Extended &truth, const Extended &scale)
{
    return static_cast<double>(abs(exact(actual) - truth) / abs(scale));
}

/// The rest is smaller than the double's precision: adding it does not change the double.
bool isNormal(const DoubleDouble &number)
{
    return number.value + number.rest == number.value;
}

constexpr double kPromise = 0x1p-100;

} // namespace

class TestDoubleDouble : public QObject {
    Q_OBJECT

private slots:
    void productsAreRoundedBeforeTheyAreAdded()
    {
        // The factors are volatile, so the processor multiplies them and not the compiler.
        volatile double above = 1.0 + 0x1p-30, below = 1.0 - 0x1p-30, one = 1.0;
        const double a = above, b = below, c = one;
        QVERIFY(a * b - c == 0.0); // contracted into one rounding: -2^-60
        QVERIFY(std::fma(a, b, -c) == -0x1p-60);
    }

    void operationsKeepThirtyDigits_data()
    {
        addColumn<Operation>("operation");
        addColumn<Truth>("truth");
        addColumn<bool>("ofLargerOperand");
        newRow("sum") << Operation([](const auto &a, const auto &b) { return a + b; })
                      << Truth([](const auto &a, const auto &b) { return a + b; }) << true;
        newRow("difference") << Operation([](const auto &a, const auto &b) { return a - b; })
                             << Truth([](const auto &a, const auto &b) { return a - b; }) << true;
        newRow("product") << Operation([](const auto &a, const auto &b) { return a * b; })
                          << Truth([](const auto &a, const auto &b) { return a * b; }) << false;
        newRow("quotient") << Operation([](const auto &a, const auto &b) { return a / b; })
                           << Truth([](const auto &a, const auto &b) { return a / b; }) << false;
        newRow("root") << Operation([](const auto &a, const auto &) { return sqrt(a * a + 1.0); })
                       << Truth([](const auto &a, const auto &) { return sqrt(a * a + 1); }) << false;
    }

    void operationsKeepThirtyDigits()
    {
        QFETCH(Operation, operation);
        QFETCH(Truth, truth);
        QFETCH(bool, ofLargerOperand);
        std::mt19937_64 random(5);
        const auto number = [&] {
            const double mantissa = 1.0 + static_cast<double>(random() >> 11) * 0x1p-53;
            const double value = std::ldexp(random() % 2 ? mantissa : -mantissa, static_cast<int>(random() % 40) - 20);
            return DoubleDouble(value) + value * static_cast<double>(random() >> 11) * 0x1p-110;
        };
        for (int i = 0; i < 20000; ++i) {
            const DoubleDouble a = number(), b = number();
            const DoubleDouble result = operation(a, b);
            const Extended right = truth(exact(a), exact(b));
            const Extended larger = std::max(abs(exact(a)), abs(exact(b)));
            QVERIFY(isNormal(result));
            QVERIFY(share(result, right, ofLargerOperand ? larger : right) <= kPromise);
        }
    }

    void tangentsKeepTheirDigits_data()
    {
        addColumn<double>("radians");
        newRow("half of 45 degrees") << std::numbers::pi / 8.0;
        newRow("a thousandth") << 1e-3;
        newRow("1e-200") << 1e-200;
        newRow("1") << 1.0;
        newRow("half of 179.9 degrees") << 179.9 / 360.0 * std::numbers::pi;
        newRow("obtuse") << 2.5;
        newRow("almost pi") << 3.14;
        newRow("negative") << -0.7;
    }

    void tangentsKeepTheirDigits()
    {
        QFETCH(double, radians);
        constexpr double kTangentPromise = 0x1p-86; // close to pi/2 and pi the sine or the cosine has fewer digits
        const Extended truth = tan(Extended(radians));
        QVERIFY(share(preciseTangent(radians), truth, truth) <= kTangentPromise);
    }

    void whatCancelsIsStillThere()
    {
        const DoubleDouble third = DoubleDouble(1.0) / 3.0;
        const double dropped = (third - 1.0 / 3.0).value;
        QVERIFY(dropped != 0.0 && share(dropped, Extended(1) / 3 - 1.0 / 3.0, dropped) <= 0x1p-46);
        QCOMPARE((DoubleDouble(1.0) + 1e-30 - 1.0).value, 1e-30);
        QCOMPARE(sqrt(DoubleDouble(0.0)).value, 0.0);
    }

    void beyondTheRangeNothingIsFinite()
    {
        QVERIFY(!std::isfinite((DoubleDouble(1e300) * 1e300).value));
        QVERIFY(!std::isfinite((DoubleDouble(1e308) + 1e308).value));
        QVERIFY(!std::isfinite((DoubleDouble(1.0) / 0.0).value));
    }

    void theUnitInTheLastPlaceIsThatOfThePrecision()
    {
        QCOMPARE(unitInLastPlace(1.0), 0x1p-52);
        QCOMPARE(unitInLastPlace(1.0f), 0x1p-23f);
        QCOMPARE(unitInLastPlace(std::nextafter(2.0, 1.0)), 0x1p-52);
        QCOMPARE(unitInLastPlace(2.0), 0x1p-51);
        QCOMPARE(unitInLastPlace(0.0), 0x1p-1074);
        QVERIFY(std::isinf(unitInLastPlace(std::numeric_limits<double>::max())));
        QVERIFY(std::isnan(unitInLastPlace(std::numeric_limits<double>::infinity())));
    }
};

UNPROJECTOR_TEST(TestDoubleDouble)
#include "test_double_double.moc"
