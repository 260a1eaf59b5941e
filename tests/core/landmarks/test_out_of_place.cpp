// Landmarks out of place: found in simulated series, and in series small enough to follow.

#include "tests/support/test.h"

#include "core/landmarks/out_of_place.h"
#include "core/landmarks/shape_variation.h"
#include "tests/core/landmarks/simulated_series.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

using namespace unprojector::landmarks;

namespace {

/// How often what was wrong was found, and what was found was right.
struct Rates {
    std::size_t wrong = 0, found = 0, displaced = 0, displacedFound = 0;
    std::size_t flagged = 0, falseFlags = 0, good = 0, swaps = 0, named = 0;

    double foundShare() const { return static_cast<double>(found) / static_cast<double>(wrong); }
    double displacedShare() const { return static_cast<double>(displacedFound) / static_cast<double>(displaced); }
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
            bool isOfSwap = false;
            for (const auto &[scan, a, b] : series.swapped) {
                isOfSwap = isOfSwap || (one.specimen == scan && (one.landmark == a || one.landmark == b));
                rates.named += one.specimen == scan && one.landmark == a && one.swappedWith == b ? 1 : 0;
            }
            rates.displaced += isWrong && !isOfSwap ? 1 : 0;
            rates.displacedFound += isWrong && !isOfSwap && one.isOutOfPlace ? 1 : 0;
        }
        rates.wrong += series.wrong.size();
        rates.swaps += series.swapped.size();
    }
    qInfo("wrong %zu, found %.4f; displaced %zu, found %.4f; false %.4f of the flagged, %.5f of the good; swaps %zu, "
          "named %.4f",
          rates.wrong, rates.foundShare(), rates.displaced, rates.displacedShare(), rates.falseShare(),
          rates.falseOfGood(), rates.swaps, rates.namedShare());
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

/// The rests by the covariance of all coordinates and its inverse, written out.
std::vector<glm::dvec3> restsByInverse(const std::vector<Offsets> &specimens, const Offsets &offsets,
                                       const std::vector<std::vector<double>> &smooth, const VarianceShares &shares)
{
    const std::size_t landmarks = offsets.size(), size = 3 * landmarks;
    const double count = static_cast<double>(specimens.size());
    std::vector<double> variances(landmarks, 0.0);
    double usual = 0.0;
    for (std::size_t j = 0; j < landmarks; ++j) {
        for (const Offsets &one : specimens)
            variances[j] += glm::dot(*one[j], *one[j]) / 3.0;
        usual += variances[j] / (count * static_cast<double>(landmarks));
    }
    std::vector<std::vector<double>> matrix(size, std::vector<double>(2 * size, 0.0));
    for (double &variance : variances)
        variance = (variance + 8.0 * usual) / (count + 8.0);
    for (std::size_t r = 0; r < size; ++r) {
        for (std::size_t c = 0; c < size; ++c) {
            double &value = matrix[r][c];
            for (const Offsets &one : specimens)
                value +=
                    (1.0 - shares.own - shares.smooth) / count * (*one[r / 3])[int(r % 3)] * (*one[c / 3])[int(c % 3)];
            for (const std::vector<double> &function : smooth) {
                if (r % 3 == c % 3)
                    value += shares.smooth * std::sqrt(variances[r / 3] * variances[c / 3]) * function[r / 3]
                             * function[c / 3];
            }
        }
        matrix[r][r] += shares.own * variances[r / 3];
        matrix[r][size + r] = 1.0;
    }
    for (std::size_t pivot = 0; pivot < size; ++pivot) { // Gauss and Jordan
        const double factor = matrix[pivot][pivot];
        for (double &value : matrix[pivot])
            value /= factor;
        for (std::size_t r = 0; r < size; ++r) {
            const double times = matrix[r][pivot];
            for (std::size_t c = 0; r != pivot && c < 2 * size; ++c)
                matrix[r][c] -= times * matrix[pivot][c];
        }
    }
    std::vector<glm::dvec3> rests;
    for (std::size_t j = 0; j < landmarks; ++j) {
        glm::dmat3 own(0.0);
        glm::dvec3 product(0.0);
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < size; ++c)
                product[int(r)] += matrix[3 * j + r][size + c] * (*offsets[c / 3])[int(c % 3)];
            for (std::size_t c = 0; c < 3; ++c)
                own[int(c)][int(r)] = matrix[3 * j + r][size + 3 * j + c];
        }
        rests.push_back(glm::inverse(own) * product);
    }
    return rests;
}

class TestOutOfPlace : public QObject {
    Q_OBJECT

private slots:
    void simulatedMistakesAreFound_data()
    {
        addColumn<int>("scans");
        addColumn<double>("missing");
        addColumn<double>("modeDeviation");
        addColumn<int>("count");
        addColumn<double>("displacedShare");
        addColumn<double>("falseShare");
        // bench_out_of_place measures more of them, with other random numbers.
        newRow("complete") << 12 << 0.0 << 2.0 << 80 << 0.95 << 0.02;
        newRow("a tenth missing") << 12 << 0.1 << 2.0 << 60 << 0.95 << 0.02;
        newRow("little shape") << 12 << 0.0 << 1.0 << 40 << 0.95 << 0.02;
        newRow("3 scans") << 3 << 0.0 << 2.0 << 100 << 0.6 << 0.06;
        newRow("5 scans") << 5 << 0.0 << 2.0 << 80 << 0.95 << 0.06;
    }

    void simulatedMistakesAreFound()
    {
        QFETCH(int, scans);
        QFETCH(double, missing);
        QFETCH(double, modeDeviation);
        QFETCH(int, count);
        QFETCH(double, displacedShare);
        QFETCH(double, falseShare);
        simulated::Kind kind;
        kind.scans = static_cast<std::size_t>(scans);
        kind.missing = missing;
        kind.modeDeviation = modeDeviation;
#ifdef UNPROJECTOR_IS_SANITIZED
        // All series take it longer than a test may take. A tenth tells no rates, but faults of memory.
        QVERIFY(ratesOf(kind, count / 10).displacedShare() > displacedShare / 2.0);
        Q_UNUSED(falseShare);
#else
        const Rates rates = ratesOf(kind, count);
        QVERIFY(rates.displacedShare() >= displacedShare);
        QVERIFY(rates.falseShare() < falseShare);
        QVERIFY(rates.falseOfGood() < 0.002);
        QVERIFY(rates.namedShare() > (scans < 12 ? 0.85 : 0.95));
#endif
    }

    void restsAreWhatTheOtherLandmarksDoNotPredict()
    {
        simulated::Random random(3);
        std::vector<Offsets> specimens(4, Offsets(5));
        Offsets offsets(5);
        Configuration shape(5);
        for (std::size_t j = 0; j < 5; ++j) {
            for (Offsets &one : specimens)
                one[j] = random.vector();
            offsets[j] = random.vector();
            shape[j] = random.vector();
        }
        const std::vector<std::vector<double>> smooth = smoothFunctionsOver(shape);
        const VarianceShares shares{0.3, 0.2};
        const ShapeVariation variation(specimens, smooth, shares);
        const Offsets rests = variation.rests(offsets, std::vector<bool>(5, false));
        const std::vector<glm::dvec3> expected = restsByInverse(specimens, offsets, smooth, shares);
        for (std::size_t j = 0; j < 5; ++j)
            QVERIFY(glm::distance(*rests[j], expected[j]) < 1e-10);
        // A landmark that is left out predicts no other; its own rest is the same.
        std::vector<bool> isLeftOut(5, false);
        isLeftOut[2] = true;
        Offsets moved = offsets;
        *moved[2] += glm::dvec3(1.0, 2.0, 3.0);
        const Offsets before = variation.rests(offsets, isLeftOut), after = variation.rests(moved, isLeftOut);
        QVERIFY(glm::distance(*before[2], *rests[2]) < 1e-10);
        QVERIFY(glm::distance(*after[0], *before[0]) < 1e-12);
        QVERIFY(glm::distance(*after[2] - *before[2], glm::dvec3(1.0, 2.0, 3.0)) < 1e-12);
        QCOMPARE(ShapeVariation().rests(offsets, isLeftOut), offsets);
    }

    void smoothFunctionsMakeTheKernel()
    {
        simulated::Random random(3);
        Configuration shape(8);
        for (std::size_t j = 0; j < 7; ++j)
            shape[j] = 100.0 * random.vector();
        const std::vector<std::vector<double>> functions = smoothFunctionsOver(shape);
        QVERIFY(functions.size() <= 10);
        const double size = centroidSizeOf(shape), radius = size / std::sqrt(7.0);
        for (std::size_t i = 0; i < 7; ++i) {
            for (std::size_t j = 0; j < 7; ++j) {
                double product = 0.0;
                for (const std::vector<double> &values : functions)
                    product += values[i] * values[j];
                const double share = glm::distance(*shape[i], *shape[j]) / radius;
                QVERIFY(std::abs(product - std::exp(-0.5 * share * share)) < 0.01);
            }
        }
        QVERIFY(smoothFunctionsOver(Configuration(3)).empty());
    }

    void aDisplacedLandmarkComesFirst()
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

    void distancesAreInTheSpecimensUnits()
    {
        std::vector<Configuration> all = boxes(6);
        *all[3][5] += glm::dvec3(0.0, 3.0, 0.0);
        const double before = deviationsOf(all).worstFirst.front().distance;
        for (auto &point : all[3])
            *point *= 1000.0;
        const Deviation worst = deviationsOf(all).worstFirst.front();
        QVERIFY(std::abs(worst.distance / before - 1000.0) < 1e-6);
    }

    void swappedNamesAreNamed()
    {
        std::vector<Configuration> all = boxes(5);
        std::swap(all[2][0], all[2][6]);
        const Deviations deviations = deviationsOf(all);
        QCOMPARE(outOfPlaceCount(deviations), std::size_t(2));
        QCOMPARE(deviationOf(deviations, 2, 0).swappedWith, std::optional<std::size_t>(6));
        QCOMPARE(deviationOf(deviations, 2, 6).swappedWith, std::optional<std::size_t>(0));
        QVERIFY(deviations.swappedSpecimens.empty());
    }

    void aSpecimenWithAllSidesSwappedIsNamed()
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

    void swappedSidesOfFewScansAreNamed_data()
    {
        addColumn<std::size_t>("scans");
        addColumn<std::vector<Pair>>("swapped");
        const auto [outer, mouth, inner] = std::tuple(Pair{4, 5}, Pair{8, 9}, Pair{6, 7});
        for (const std::size_t scans : std::initializer_list<std::size_t>{3, 4, 5}) {
            const auto row = [scans](const char *name, const std::vector<Pair> &swapped) {
                addRow("%zu scans, %s", scans, name) << scans << swapped;
            };
            row("none", {});
            row("the outer pair", {outer});
            row("the mouth", {mouth});
            row("the inner pair", {inner});
            row("all but the mouth", {outer, inner});
            row("all but the outer pair", {mouth, inner});
            row("all", {outer, mouth, inner});
        }
    }

    void swappedSidesOfFewScansAreNamed()
    {
        QFETCH(std::size_t, scans);
        QFETCH(std::vector<Pair>, swapped);
        std::set<simulated::Place> wrong;
        for (const Pair &pair : swapped)
            wrong.insert({{0, pair.left}, {0, pair.right}});
        simulated::Random random(17);
        for (int i = 0; i < 10; ++i) { // bench_out_of_place tries more of them, with other random numbers
            const Deviations deviations = deviationsOf(
                simulated::seriesOfFew(random, {.scans = scans, .swapped = swapped}), simulated::kPairsOfFew);
            std::set<simulated::Place> named;
            for (const Deviation &one : deviations.worstFirst) {
                if (one.swappedWith)
                    named.insert({one.specimen, one.landmark});
            }
            QVERIFY(named == wrong);
            QCOMPARE(outOfPlaceCount(deviations), wrong.size());
            QCOMPARE(deviations.swappedSpecimens.size(), std::size_t(swapped.size() == 3 ? 1 : 0));
            QVERIFY(deviations.undecidedSpecimens.empty());
        }
    }

    /// Faces that differ three times as much: the distance of an inner pair is about a spread.
    void sidesThatScansCannotTellAreReported()
    {
        simulated::Random random(17);
        std::size_t undecided = 0;
        for (int i = 0; i < 40; ++i) {
            const Deviations deviations =
                deviationsOf(simulated::seriesOfFew(random, {.swapped = {{8, 9}, {6, 7}}, .deviation = 1.0}),
                             simulated::kPairsOfFew);
            QVERIFY(deviations.swappedSpecimens.empty()); // the outer pair is right
            undecided += deviations.undecidedSpecimens.size();
            for (const Deviation &one : deviations.worstFirst) {
                const auto &open = deviations.undecidedSpecimens;
                if (std::find(open.begin(), open.end(), one.specimen) != open.end())
                    QVERIFY(!one.swappedWith);
            }
        }
        QVERIFY(undecided > 10);
    }

    void aCancelledComparisonIsEmpty()
    {
        simulated::Random random(17);
        const auto scans = simulated::seriesOfFew(random, {.swapped = {{8, 9}}});
        int asked = 0;
        QVERIFY(deviationsOf(scans, simulated::kPairsOfFew, [&asked] { return ++asked > 3; }).worstFirst.empty());
        QVERIFY(asked < 10);
        QVERIFY(!deviationsOf(scans, simulated::kPairsOfFew, [] { return false; }).worstFirst.empty());
    }

    void twoMistakesOfALandmarkDoNotHideEachOther()
    {
        std::vector<Configuration> all = boxes(8);
        *all[1][4] += glm::dvec3(0.0, 0.0, 5.0);
        *all[6][4] += glm::dvec3(0.0, 0.0, 5.0);
        const Deviations deviations = deviationsOf(all);
        QVERIFY(deviationOf(deviations, 1, 4).isOutOfPlace);
        QVERIFY(deviationOf(deviations, 6, 4).isOutOfPlace);
        QCOMPARE(outOfPlaceCount(deviations), std::size_t(2));
    }

    void whatCannotBeJudgedIsReported()
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

    void equalSpecimensHaveNoOutlier()
    {
        const std::vector<Configuration> all(5, boxes(1).front());
        const Deviations deviations = deviationsOf(all);
        QCOMPARE(deviations.worstFirst.size(), std::size_t(40));
        QCOMPARE(outOfPlaceCount(deviations), std::size_t(0));
    }
};

UNPROJECTOR_TEST(TestOutOfPlace)
#include "test_out_of_place.moc"
