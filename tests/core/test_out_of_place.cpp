// Landmarks out of place: found in simulated series, and in series small enough to follow.

#include "core/landmarks/out_of_place.h"
#include "simulated_series.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace unprojector::landmarks;

namespace {

/// How often what was wrong was found, and what was found was right.
struct Rates {
    std::size_t wrong = 0, found = 0, flagged = 0, falseFlags = 0, good = 0, swaps = 0, named = 0;

    double foundShare() const { return static_cast<double>(found) / static_cast<double>(wrong); }
    double falseShare() const { return static_cast<double>(falseFlags) / static_cast<double>(flagged); }
    double falseOfGood() const { return static_cast<double>(falseFlags) / static_cast<double>(good); }
    double namedShare() const { return static_cast<double>(named) / static_cast<double>(swaps); }
};

Rates ratesOf(const simulated::Kind &kind, int count)
{
    simulated::Random random(29);
    Rates rates;
    for (int i = 0; i < count; ++i) {
        const simulated::Series series = simulated::series(random, kind);
        const Deviations deviations = deviationsOf(series.scans, series.pairs);
        for (const Deviation &one : deviations.worstFirst) {
            const bool isWrong = series.wrong.contains({one.specimen, one.landmark});
            rates.good += isWrong ? 0 : 1;
            rates.flagged += one.isOutOfPlace ? 1 : 0;
            rates.found += one.isOutOfPlace && isWrong ? 1 : 0;
            rates.falseFlags += one.isOutOfPlace && !isWrong ? 1 : 0;
            for (const auto &[scan, a, b] : series.swapped)
                rates.named += one.specimen == scan && one.landmark == a && one.swappedWith == b ? 1 : 0;
        }
        rates.wrong += series.wrong.size();
        rates.swaps += series.swapped.size();
    }
    qInfo("wrong %zu, found %.4f; false %.4f of the flagged, %.5f of the good; swaps %zu, named %.4f", rates.wrong,
          rates.foundShare(), rates.falseShare(), rates.falseOfGood(), rates.swaps, rates.namedShare());
    return rates;
}

/// Eight landmarks: the corners of a box, not symmetric.
std::vector<Configuration> boxes(std::size_t count)
{
    simulated::Random random(5);
    std::vector<Configuration> all;
    for (std::size_t k = 0; k < count; ++k) {
        Configuration &box = all.emplace_back();
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner((i & 1) != 0 ? 30.0 : 0.0, (i & 2) != 0 ? 20.0 : 0.0,
                                    (i & 4) != 0 ? 11.0 : 1.0 * i);
            box.emplace_back(corner + 0.1 * random.vector());
        }
    }
    return all;
}

const Deviation &deviationOf(const Deviations &deviations, std::size_t specimen, std::size_t landmark)
{
    return *std::find_if(deviations.worstFirst.begin(), deviations.worstFirst.end(),
                         [&](const Deviation &one) { return one.specimen == specimen && one.landmark == landmark; });
}

std::size_t outOfPlaceCount(const Deviations &deviations)
{
    return static_cast<std::size_t>(std::count_if(deviations.worstFirst.begin(), deviations.worstFirst.end(),
                                                  [](const Deviation &one) { return one.isOutOfPlace; }));
}

} // namespace

class TestOutOfPlace : public QObject {
    Q_OBJECT

private slots:
    void simulatedMistakesAreFound_data();
    void simulatedMistakesAreFound();
    void aDisplacedLandmarkComesFirst();
    void distancesAreInTheSpecimensUnits();
    void swappedNamesAreNamed();
    void aSpecimenWithAllSidesSwappedIsNamed();
    void twoMistakesOfALandmarkDoNotHideEachOther();
    void whatCannotBeJudgedIsReported();
    void equalSpecimensHaveNoOutlier();
};

void TestOutOfPlace::simulatedMistakesAreFound_data()
{
    QTest::addColumn<double>("missing");
    QTest::addColumn<double>("modeDeviation");
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("foundShare");
    QTest::addColumn<double>("falseShare");
    QTest::newRow("complete") << 0.0 << 2.0 << 200 << 0.9781 << 0.0058;
    QTest::newRow("a tenth missing") << 0.1 << 2.0 << 200 << 0.9736 << 0.0055;
    QTest::newRow("little shape") << 0.0 << 1.0 << 50 << 0.9877 << 0.0102;
}

void TestOutOfPlace::simulatedMistakesAreFound()
{
    QFETCH(double, missing);
    QFETCH(double, modeDeviation);
    QFETCH(int, count);
    QFETCH(double, foundShare);
    QFETCH(double, falseShare);
    simulated::Kind kind;
    kind.missing = missing;
    kind.modeDeviation = modeDeviation;
    const Rates rates = ratesOf(kind, count);
    QVERIFY(rates.foundShare() >= 0.95);
    QVERIFY(rates.falseShare() < 0.02);
    QVERIFY(rates.falseOfGood() < 0.001);
    QVERIFY(rates.namedShare() > 0.95);
    // The measured rates; other mathematical libraries round differently.
    QVERIFY(std::abs(rates.foundShare() - foundShare) < 0.003);
    QVERIFY(std::abs(rates.falseShare() - falseShare) < 0.003);
}

void TestOutOfPlace::aDisplacedLandmarkComesFirst()
{
    std::vector<Configuration> all = boxes(6);
    QCOMPARE(outOfPlaceCount(deviationsOf(all)), std::size_t(0));
    *all[3][5] += glm::dvec3(0.0, 3.0, 0.0);
    const Deviations deviations = deviationsOf(all);
    QCOMPARE(deviations.worstFirst.size(), std::size_t(48));
    const Deviation &worst = deviations.worstFirst.front();
    QCOMPARE(worst.specimen, std::size_t(3));
    QCOMPARE(worst.landmark, std::size_t(5));
    QVERIFY(worst.isOutOfPlace);
    QVERIFY(!worst.swappedWith);
    QVERIFY(std::abs(worst.distance - 3.0) < 0.5);
    QCOMPARE(outOfPlaceCount(deviations), std::size_t(1));
    QVERIFY(std::is_sorted(deviations.worstFirst.begin(), deviations.worstFirst.end(),
                           [](const Deviation &a, const Deviation &b) { return a.spreads() > b.spreads(); }));
}

void TestOutOfPlace::distancesAreInTheSpecimensUnits()
{
    std::vector<Configuration> all = boxes(6);
    *all[3][5] += glm::dvec3(0.0, 3.0, 0.0);
    const double before = deviationsOf(all).worstFirst.front().distance;
    for (auto &point : all[3])
        *point *= 1000.0;
    const Deviation worst = deviationsOf(all).worstFirst.front();
    QVERIFY(std::abs(worst.distance / before - 1000.0) < 1e-6);
}

void TestOutOfPlace::swappedNamesAreNamed()
{
    std::vector<Configuration> all = boxes(5);
    std::swap(all[2][0], all[2][6]);
    const Deviations deviations = deviationsOf(all);
    QCOMPARE(outOfPlaceCount(deviations), std::size_t(2));
    QCOMPARE(deviationOf(deviations, 2, 0).swappedWith, std::optional<std::size_t>(6));
    QCOMPARE(deviationOf(deviations, 2, 6).swappedWith, std::optional<std::size_t>(0));
    QVERIFY(deviations.swappedSpecimens.empty());
}

void TestOutOfPlace::aSpecimenWithAllSidesSwappedIsNamed()
{
    simulated::Random random(11);
    simulated::Series series = simulated::series(random, {});
    for (const Pair &pair : series.pairs)
        std::swap(series.scans[4][pair.left], series.scans[4][pair.right]);
    const Deviations deviations = deviationsOf(series.scans, series.pairs);
    QCOMPARE(deviations.swappedSpecimens, std::vector<std::size_t>{4});
    const Pair &first = series.pairs.front();
    QCOMPARE(deviationOf(deviations, 4, first.left).swappedWith, std::optional(first.right));
    QVERIFY(deviationsOf(series.scans).swappedSpecimens.empty()); // pairs are needed
}

void TestOutOfPlace::twoMistakesOfALandmarkDoNotHideEachOther()
{
    std::vector<Configuration> all = boxes(8);
    *all[1][4] += glm::dvec3(0.0, 0.0, 5.0);
    *all[6][4] += glm::dvec3(0.0, 0.0, 5.0);
    const Deviations deviations = deviationsOf(all);
    QVERIFY(deviationOf(deviations, 1, 4).isOutOfPlace);
    QVERIFY(deviationOf(deviations, 6, 4).isOutOfPlace);
    QCOMPARE(outOfPlaceCount(deviations), std::size_t(2));
}

void TestOutOfPlace::whatCannotBeJudgedIsReported()
{
    std::vector<Configuration> all = boxes(4);
    for (std::size_t j = 4; j < 8; ++j)
        all[1][j].reset(); // four are too few
    all[2][7].reset();
    const Deviations deviations = deviationsOf(all);
    QCOMPARE(deviations.notAligned, std::vector<std::size_t>{1});
    QCOMPARE(deviations.tooRare, std::vector<std::size_t>{7}); // on two specimens
    QVERIFY(std::none_of(deviations.worstFirst.begin(), deviations.worstFirst.end(),
                         [](const Deviation &one) { return one.specimen == 1 || one.landmark == 7; }));
    const std::vector<Configuration> two = boxes(2);
    QVERIFY(deviationsOf(two).worstFirst.empty());
    QCOMPARE(deviationsOf(two).tooRare.size(), std::size_t(8));
    QVERIFY(deviationsOf({}).worstFirst.empty());
}

void TestOutOfPlace::equalSpecimensHaveNoOutlier()
{
    const std::vector<Configuration> all(5, boxes(1).front());
    const Deviations deviations = deviationsOf(all);
    QCOMPARE(deviations.worstFirst.size(), std::size_t(40));
    QCOMPARE(outOfPlaceCount(deviations), std::size_t(0));
}

QTEST_GUILESS_MAIN(TestOutOfPlace)
#include "test_out_of_place.moc"
