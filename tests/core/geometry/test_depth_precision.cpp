// The error that rounding a depth leaves, against rounded depths.

#include "tests/support/test.h"

#include "core/unproject/certainty.h"
#include "core/unproject/depth_precision.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using namespace unprojector::unproject;
using namespace unprojector::geometry;

namespace {

/// Rounding by hand: whole steps of an unsigned integer, or a float.
long double stored(const DepthFormat &format, long double depth)
{
    if (format.isFloat)
        return static_cast<float>(depth);
    const long double most = std::ldexp(1.0L, format.bits) - 1.0L;
    return static_cast<long double>(static_cast<std::uint64_t>(depth * most + 0.5L)) / most;
}

long double depthOf(const DepthScale &s, long double z)
{
    const long double n = s.nearDistance, f = s.farDistance;
    const long double unit = !s.isPerspective            ? (z - n) / (f - n)
                             : std::isinf(s.farDistance) ? 1.0L - n / z
                                                         : (1.0L / n - 1.0L / z) / (1.0L / n - 1.0L / f);
    return s.range.atNear + unit * (static_cast<long double>(s.range.atFar) - s.range.atNear);
}

long double distanceOf(const DepthScale &s, long double depth)
{
    const long double n = s.nearDistance, f = s.farDistance;
    const long double unit = (depth - s.range.atNear) / (static_cast<long double>(s.range.atFar) - s.range.atNear);
    if (!s.isPerspective)
        return n + unit * (f - n);
    return std::isinf(s.farDistance) ? n / (1.0L - unit) : 1.0L / (1.0L / n - unit * (1.0L / n - 1.0L / f));
}

Setup pictureWith(const Projection &projection)
{
    return {{800, 600, 1.0}, {0, 0, 800, 600}, {}, projection, LookAt{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}}};
}

} // namespace

Q_DECLARE_METATYPE(DepthScale)
Q_DECLARE_METATYPE(DepthFormat)

class TestDepthPrecision : public QObject {
    Q_OBJECT

private slots:
    void noRoundedDepthIsFartherOff_data()
    {
        addColumn<DepthScale>("scale");
        addColumn<DepthFormat>("format");
        const double infinite = std::numeric_limits<double>::infinity();
        const std::array formats{std::pair("16 bits", DepthFormat(16)), std::pair("24 bits", DepthFormat(24)),
                                 std::pair("32 bits", DepthFormat(32)),
                                 std::pair("floats", DepthFormat::floatingPoint())};
        const std::array scales{std::pair("perspective", DepthScale{true, 0.1, 100.0, {}}),
                                std::pair("reversed", DepthScale{true, 0.1, 100.0, {1.0, 0.0}}),
                                std::pair("partial", DepthScale{true, 2.0, 50.0, {0.25, 0.75}}),
                                std::pair("infinite", DepthScale{true, 0.5, infinite, {}}),
                                std::pair("infinite, reversed", DepthScale{true, 0.5, infinite, {1.0, 0.0}}),
                                std::pair("box", DepthScale{false, -3.0, 40.0, {}}),
                                std::pair("box, reversed", DepthScale{false, -3.0, 40.0, {1.0, 0.0}})};
        for (const auto &[scaleName, scale] : scales)
            for (const auto &[formatName, format] : formats)
                addRow("%s, %s", scaleName, formatName) << scale << format;
    }

    /// No distance comes back farther off than the bound, and over many some come close to it.
    void noRoundedDepthIsFartherOff()
    {
        QFETCH(DepthScale, scale);
        QFETCH(DepthFormat, format);
        std::mt19937 engine(11);
        const double last = std::isinf(scale.farDistance) ? 100.0 : scale.farDistance;
        double greatest = 0.0;
        for (int i = 0; i < 4000; ++i) {
            const double share = (0.01 + 0.98 * double(engine()) / 4294967296.0);
            const double z = scale.nearDistance + share * (last - scale.nearDistance);
            const double said = halfDepthStepAt(scale, format, z);
            const long double back = distanceOf(scale, stored(format, depthOf(scale, z)));
            const double ratio = double(std::abs(back - static_cast<long double>(z))) / said;
            greatest = std::max(greatest, ratio);
            // The bound is first order: the next term is as large as the step is relative to the
            // distance.
            QVERIFY2(ratio <= 1.0 + 4.0 * said / std::abs(z) + 1e-6,
                     qPrintable(QStringLiteral("%1 at %2").arg(ratio).arg(z)));
        }
        QVERIFY2(greatest > 0.95, qPrintable(QString::number(greatest)));
    }

    /// A click reports the same number for its rounding.
    void aClickSaysTheSame()
    {
        for (const Projection &projection :
             {Projection(Perspective{0.8, 1.5, 0.1, 70.0}), Projection(Ortho{-1, 1, -1, 1, 2, 9})}) {
            const Setup setup = pictureWith(projection);
            const DepthScale scale = depthScaleOf(setup);
            const DepthFormat format(24);
            const Certainty certainty = Certainties(setup).at(4.5, {format.halfStep(unitDepthAt(scale, 4.5)), 0.0});
            QVERIFY(std::abs(halfDepthStepAt(scale, format, 4.5) / certainty.halfDepthStep - 1.0) < 1e-12);
        }
    }

    void tenTimesTheNearIsTenTimesAsGood()
    {
        const DepthFormat format(24);
        const double before = halfDepthStepAt({true, 0.1, 1e4, {}}, format, 20.0);
        const double after = halfDepthStepAt({true, 1.0, 1e4, {}}, format, 20.0);
        QVERIFY(std::abs(before / after - 10.0) < 1e-3);
        // 20^2 / 0.1 / 2^25
        QVERIFY(std::abs(before - 1.19e-4) < 1e-6);
    }

    void theNearestBoxCounts()
    {
        const Setup setup = pictureWith(Perspective{0.8, 1.5, 0.1, 70.0}); // the eye at z = 5 looks down -z
        const std::array boxes{Box{{-1, -1, -4}, {1, 1, 2}}, Box{{50, 0, 0}, {60, 1, 3.5}}, Box{},
                               Box{{0, 0, 6}, {1, 1, 9}}};
        QCOMPARE(nearestDistance(setup, boxes), std::optional(1.5));
        const std::array around{Box{{-1, -1, -4}, {1, 1, 2}}, Box{{-9, -9, -9}, {9, 9, 9}}};
        QCOMPARE(nearestDistance(setup, around), std::nullopt);
        QCOMPARE(nearestDistance(setup, {}), std::nullopt);
    }

    void noNearThatWouldCutIsSuggested()
    {
        const auto better = [](double nearDistance, double nearestZ) {
            const std::array box{Box{{0, 0, -1}, {1, 1, nearestZ}}};
            return betterNear(pictureWith(Perspective{0.8, 1.5, nearDistance, 70.0}), box);
        };
        QCOMPARE(better(0.1, 3.5), std::optional(1.0)); // the box is 1.5 away
        QCOMPARE(better(0.1, 2.0), std::optional(2.0)); // 3 away, less a hundredth
        QCOMPARE(better(0.1, 4.75), std::optional(0.2));
        QCOMPARE(better(1.0, 3.5), std::nullopt); // it has that
        QCOMPARE(better(0.9, 3.5), std::nullopt); // hardly better
        QCOMPARE(better(0.1, 5.5), std::nullopt); // the eye is in the box
        std::mt19937 engine(3);
        for (int i = 0; i < 1000; ++i) {
            const double distance = std::pow(10.0, -8.0 + 9.0 * double(engine()) / 4294967296.0);
            const auto found = better(1e-9, 5.0 - distance);
            QVERIFY(found && *found<distance && * found> 0.4 * distance);
        }
        QCOMPARE(betterNear(pictureWith(Ortho{-1, 1, -1, 1, 0.1, 70}), std::array{Box{{0, 0, 0}, {1, 1, 1}}}),
                 std::nullopt);
    }
};

UNPROJECTOR_TEST(TestDepthPrecision)
#include "test_depth_precision.moc"
