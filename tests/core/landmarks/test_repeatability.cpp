// The error of measurement of landmarks that were placed several times. The expected numbers were
// computed with NumPy: superimposition by singular values, and the sums of the analysis of variance by
// their definition.

#include "tests/support/test.h"

#include "core/landmark_files/repeats_table.h"
#include "core/landmarks/repeatability.h"

#include <array>
#include <cmath>
#include <limits>

namespace {
using namespace unprojector::geometry;
using namespace unprojector::landmark_files;
using namespace unprojector::landmarks;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN(); ///< not placed
constexpr double kDigits = 1e-9;                                   ///< the numbers have ten digits

struct PlacedFive {
    std::size_t specimen;
    int placing;
    std::array<std::array<double, 3>, 5> landmarks;
};

/// Four specimens of other sizes, turned and moved; the last one lacks the third placing.
const std::array<PlacedFive, 11> kFive{{
    {0,
     1,
     {{{2.8, -4.3, -50.56}, {3.5, 6.05, -50.31}, {1.99, -3.9, -57.54}, {-1.18, -4.96, -48.52}, {-1.36, 2.7, -56.05}}}},
    {0,
     2,
     {{{2.55, -4.38, -50.53},
       {3.22, 6.09, -50.53},
       {1.64, -3.83, -57.66},
       {-1.37, -5.13, -48.3},
       {-1.36, 2.72, -56.17}}}},
    {0,
     3,
     {{{2.88, -3.98, -50.91},
       {3.28, 6.5, -50.3},
       {1.94, -3.85, -57.19},
       {-1.05, -4.68, -48.62},
       {-0.98, 2.65, -56.24}}}},
    {1,
     1,
     {{{-25.73, 6.12, -33.37},
       {-32.73, 16.97, -37.92},
       {-28.54, 8.43, -22.64},
       {-19.92, 11.5, -31.86},
       {kNone, kNone, kNone}}}},
    {1,
     2,
     {{{-25.76, 6.75, -33.67},
       {-32.31, 16.92, -38.13},
       {-28.73, 8.51, -22.93},
       {-19.7, 11.09, -31.99},
       {-30.71, 18.12, -27.05}}}},
    {1,
     3,
     {{{-25.8, 7.04, -33.67},
       {-32.06, 17.25, -38.78},
       {-29.03, 8.83, -22.93},
       {-19.85, 11.64, -32.07},
       {-30.69, 18.62, -27.37}}}},
    {2,
     1,
     {{{-0.65, 2.1, -15.24},
       {-11.71, -1.01, -23.61},
       {5.72, -8.33, -17.21},
       {-7.71, -2.44, -9.62},
       {-5.98, -10.88, -21.53}}}},
    {2,
     2,
     {{{-0.76, 1.64, -15.47},
       {-11.84, -0.94, -23.86},
       {5.18, -8.4, -17.46},
       {-7.86, -2.92, -10.02},
       {-5.51, -11.11, -21.95}}}},
    {2,
     3,
     {{{-0.86, 1.6, -15.34},
       {-11.57, -1.49, -25.15},
       {6.12, -8.27, -17.29},
       {-7.28, -2.45, -10.41},
       {-5.64, -10.93, -21.25}}}},
    {3,
     1,
     {{{-8.86, 15.5, -3.07},
       {-11.18, 4.46, -15.93},
       {-8.95, 5.44, 9.44},
       {-21.65, 14.77, -4.08},
       {-14.12, -3.65, -1.4}}}},
    {3,
     2,
     {{{-8.45, 15.36, -3.11},
       {-11.54, 3.43, -15.49},
       {-8.91, 4.08, 10.07},
       {-22.05, 15.16, -4.38},
       {-14.78, -3.23, -2.3}}}},
}};

std::vector<std::vector<LandmarkSet>> fiveLandmarks()
{
    std::vector<std::vector<LandmarkSet>> specimens(4);
    for (const PlacedFive &placed : kFive) {
        LandmarkSet &set = specimens[placed.specimen].emplace_back();
        set.placing = placed.placing;
        for (std::size_t i = 0; i < placed.landmarks.size(); ++i) {
            const auto &[x, y, z] = placed.landmarks[i];
            Landmark &landmark = set.landmarks.emplace_back();
            landmark.name = "L" + std::to_string(i + 1);
            if (!std::isnan(x))
                landmark.world = WorldPoint(x, y, z);
        }
    }
    return specimens;
}

bool isClose(const std::optional<double> &value, double expected)
{
    return value && std::abs(*value - expected) <= kDigits * std::abs(expected);
}

} // namespace

class TestRepeatability : public QObject {
    Q_OBJECT

private slots:
    void numbersOfNumPy_data()
    {
        addColumn<int>("landmark");
        addColumn<double>("error");
        addColumn<double>("icc1");
        addColumn<double>("icc2");
        addColumn<QList<double>>("errors");
        addColumn<QList<double>>("biases");
        using L = QList<double>;
        newRow("L1") << 0 << 0.3855947787 << 0.8739774999 << 0.8691192065 << L{0.4407474712, 0.2749696953, 0.4199338572}
                     << L{0.3124873411, 0.09898509126, 0.2553707944};
        newRow("L2") << 1 << 0.6729236141 << 0.6801106973 << 0.6322736752 << L{0.6596937421, 0.5244123695, 0.867925368}
                     << L{0.2090281469, 0.1887632539, 0.3773442496};
        newRow("L3") << 2 << 0.543986607 << 0.7503252238 << 0.8189315712 << L{0.5820008591, 0.648189787, 0.4596012765}
                     << L{0.1607038383, 0.1825853583, 0.1163792085};
        newRow("L4") << 3 << 0.425046216 << 0.8893182339 << 0.8900446422 << L{0.3676275289, 0.4396447429, 0.4774061862}
                     << L{0.1009330478, 0.1696854067, 0.2685193044};
        newRow("L5, not in every placing")
            << 4 << 0.4830573925 << 0.1175229861 << 0.2875219239 << L{0.5406528975, 0.550071965, 0.3901139435}
            << L{0.2141657327, 0.2188615013, 0.1833882297};
        newRow("all") << -1 << 0.5129709696 << 0.7851747003 << 0.8100406256 << L{} << L{};
    }

    void numbersOfNumPy()
    {
        QFETCH(int, landmark);
        QFETCH(double, error);
        QFETCH(double, icc1);
        QFETCH(double, icc2);
        QFETCH(QList<double>, errors);
        QFETCH(QList<double>, biases);
        const auto specimens = fiveLandmarks();
        const MeasurementError found = measurementErrorOf(specimens);
        QCOMPARE(found.placings, (std::vector<int>{1, 2, 3}));
        QCOMPARE(found.notAligned, std::size_t(0));
        const LandmarkError &of = landmark < 0 ? found.all : found.landmarks[static_cast<std::size_t>(landmark)];
        QVERIFY2(isClose(of.error, error), qPrintable(QString::number(of.error.value_or(-1.0), 'g', 10)));
        QVERIFY2(isClose(of.icc1, icc1), qPrintable(QString::number(of.icc1.value_or(-1.0), 'g', 10)));
        QVERIFY2(isClose(of.icc2, icc2), qPrintable(QString::number(of.icc2.value_or(-1.0), 'g', 10)));
        for (int j = 0; j < errors.size(); ++j) {
            QVERIFY(isClose(of.byPlacing[static_cast<std::size_t>(j)].error, errors[j]));
            QVERIFY(isClose(of.byPlacing[static_cast<std::size_t>(j)].bias, biases[j]));
            const auto own = std::count_if(kFive.begin(), kFive.end(), [&](const PlacedFive &placed) {
                return placed.placing == j + 1 && !std::isnan(placed.landmarks[std::size_t(landmark)][0]);
            });
            QCOMPARE(of.byPlacing[static_cast<std::size_t>(j)].specimens, static_cast<std::size_t>(own));
        }
    }

    /// sqrt(sum of d^2 / 2n): distances 2, 0 and 4 of three specimens give sqrt(20 / 6).
    void twoPlacingsGiveDahlbergsError()
    {
        std::vector<std::vector<LandmarkSet>> specimens(3, std::vector<LandmarkSet>(2));
        const std::array<double, 3> apart{2.0, 0.0, 4.0};
        for (std::size_t i = 0; i < specimens.size(); ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                specimens[i][j].placing = static_cast<int>(j) + 1;
                Landmark &landmark = specimens[i][j].landmarks.emplace_back();
                landmark.name = "a";
                landmark.world = WorldPoint(100.0 * double(i), apart[i] * double(j), 7.0);
            }
        }
        const MeasurementError found = measurementErrorOf(specimens);
        QVERIFY(isClose(found.landmarks.front().error, std::sqrt(20.0 / 6.0)));
        QCOMPARE(found.landmarks.front().specimens, std::size_t(3));
        QCOMPARE(found.landmarks.front().placings, std::size_t(6));
        // One landmark cannot be aligned.
        QVERIFY(!found.landmarks.front().icc1 && !found.landmarks.front().byPlacing[0].bias);
        QCOMPARE(found.notAligned, std::size_t(3));
    }

    void framesOfTheScansDoNotMatter()
    {
        auto specimens = fiveLandmarks();
        const MeasurementError before = measurementErrorOf(specimens);
        for (LandmarkSet &set : specimens[1]) { // a scan in other axes, far away
            for (Landmark &landmark : set.landmarks) {
                if (landmark.world)
                    landmark.world = WorldPoint(1e4 - landmark.world->y, landmark.world->x, landmark.world->z + 5e5);
            }
        }
        const MeasurementError after = measurementErrorOf(specimens);
        for (std::size_t i = 0; i < before.landmarks.size(); ++i) {
            // Coordinates of 5e5 keep eleven digits behind the point.
            QVERIFY(std::abs(*after.landmarks[i].icc1 - *before.landmarks[i].icc1) < 1e-8);
            QVERIFY(std::abs(*after.landmarks[i].error - *before.landmarks[i].error) < 1e-8);
            QVERIFY(std::abs(*after.landmarks[i].byPlacing[1].bias - *before.landmarks[i].byPlacing[1].bias) < 1e-8);
        }
    }

    void whatCannotBeComputedIsEmpty()
    {
        QVERIFY(measurementErrorOf(std::vector<std::vector<LandmarkSet>>()).landmarks.empty());
        auto specimens = fiveLandmarks();
        for (auto &placings : specimens)
            placings.resize(1);
        const MeasurementError once = measurementErrorOf(specimens);
        QVERIFY(!once.all.error && !once.all.icc1 && !once.all.icc2 && once.all.specimens == 0);
        specimens = fiveLandmarks();
        specimens.resize(1);
        const MeasurementError alone = measurementErrorOf(specimens);
        QVERIFY(alone.all.error && !alone.all.icc1 && !alone.all.icc2);
        // Equal placings of equal specimens have no variance at all.
        specimens = fiveLandmarks();
        for (auto &placings : specimens) {
            placings = {specimens[0][0], specimens[0][0]};
            placings[1].placing = 2;
        }
        const MeasurementError same = measurementErrorOf(specimens);
        QVERIFY(isClose(same.all.error, 0.0));
    }

    void theTable()
    {
        std::vector<RepeatedSpecimen> specimens;
        for (auto &placings : fiveLandmarks()) {
            RepeatedSpecimen &specimen = specimens.emplace_back();
            specimen.name = "s" + std::to_string(specimens.size());
            specimen.files.resize(placings.size(), "file");
            specimen.placings = std::move(placings);
        }
        const auto table = errorsTable(specimens);
        QVERIFY(table);
        const QStringList lines = QString::fromStdString(table->text).split(u'\n');
        QCOMPARE(lines.size(), 8);
        QCOMPARE(lines[0], QString("landmark,specimens,placings,error,icc1,icc2,error_1,bias_1,error_2,bias_2,error_3,"
                                   "bias_3"));
        QVERIFY2(lines[1].startsWith("L1,4,11,0.38559477"), qPrintable(lines[1]));
        QVERIFY2(lines[5].startsWith("L5,4,10,0.4830573"), qPrintable(lines[5]));
        QVERIFY2(lines[6].startsWith("(all),4,11,0.51297096"), qPrintable(lines[6]));
        QVERIFY(lines[6].endsWith(",NA")); // the bias of all landmarks together has no direction
        QVERIFY(errorRemarks(measurementErrorOf(specimens)).empty());
        // The specimens' units differ, though each one's placings agree.
        for (auto &placing : specimens[0].placings)
            placing.unit = "mm";
        for (auto &placing : specimens[1].placings)
            placing.unit = "cm";
        QVERIFY(!errorsTable(specimens));
        specimens.resize(1);
        specimens[0].placings.resize(1);
        QCOMPARE(errorRemarks(measurementErrorOf(specimens)).size(), std::size_t(1));
    }
};

UNPROJECTOR_TEST(TestRepeatability)
#include "test_repeatability.moc"
