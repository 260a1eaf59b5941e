// Alignment of specimens. NumPy computed the literal numbers: similarities by its singular value
// decomposition (Umeyama 1991), superimpositions by plain iteration, neither with the code under test.

#include "tests/support/test.h"

#include "core/landmarks/procrustes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace unprojector::landmarks;

namespace {

using Points = Configuration;

Points points(std::initializer_list<glm::dvec3> list)
{
    return {list.begin(), list.end()};
}

/// Four specimens of six landmarks, turned, moved and scaled, with shape differences.
const std::vector<Points> &specimens()
{
    static const std::vector<Points> all{points({{-4.34, 12.61, -13.48},
                                                 {-16.38, 6.46, -5.1},
                                                 {-13.46, 13.53, 1.03},
                                                 {-5.38, 18.5, -7.69},
                                                 {-13.51, 15.47, -10.03},
                                                 {-8.51, 18.59, -8.03}}),
                                         points({{5.77, 16.86, 3.31},
                                                 {-3.32, 15.08, 11.38},
                                                 {-6.16, 8.22, 7.05},
                                                 {4.77, 11.29, -0.47},
                                                 {4.13, 9.63, 8.47},
                                                 {5.1, 9.76, 3.41}}),
                                         points({{-3.02, -0.02, 18.94},
                                                 {3.31, -18.15, 12.05},
                                                 {13.46, -16.11, 16.38},
                                                 {7.02, -0.1, 23.64},
                                                 {2.9, -12.58, 22.76},
                                                 {4.7, -6.64, 26.25}}),
                                         points({{5.44, 2.29, 5.13},
                                                 {-2.66, 7.76, 1.46},
                                                 {-4.12, 7.98, 7.45},
                                                 {4.04, 3.31, 11.14},
                                                 {2.41, 8.98, 7.49},
                                                 {3.72, 6.18, 9.47}})};
    return all;
}

bool isClose(double a, double b, double within = 1e-12)
{
    return std::abs(a - b) <= within * std::max(1.0, std::abs(b));
}

/// The distances of the mean's landmarks 0-1, 1-2, 4-5 and 0-4.
std::array<double, 4> distancesIn(const Points &mean)
{
    return {glm::distance(*mean[0], *mean[1]), glm::distance(*mean[1], *mean[2]), glm::distance(*mean[4], *mean[5]),
            glm::distance(*mean[0], *mean[4])};
}

double distanceOf(const Points &a, const Points &b)
{
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += a[i] ? glm::dot(*a[i] - *b[i], *a[i] - *b[i]) : 0.0;
    return std::sqrt(squares);
}

} // namespace

class TestProcrustes : public QObject {
    Q_OBJECT

private slots:
    void aSimilarityIsUmeyamas()
    {
        const auto s = similarityOf(specimens()[0], specimens()[1]);
        QVERIFY(s);
        QVERIFY(isClose(s->scale, 0.8914350284232101));
        QVERIFY(isClose(s->rotation[0][0], 0.11084349890123046));
        QVERIFY(isClose(s->rotation[1][0], 0.44930651268149135)); // row 0, column 1
        QVERIFY(isClose(s->rotation[0][2], -0.8998446943430399)); // row 2, column 0
        QVERIFY(isClose(s->translation.x, -8.6585631690284));
        QVERIFY(isClose(s->translation.y, 23.790686607811914));
        QVERIFY(isClose(s->translation.z, -0.301526845381753));
        QVERIFY(isClose(glm::determinant(s->rotation), 1.0));
        const glm::dvec3 back = s->inverse().mapped(s->mapped(glm::dvec3(1.0, 2.0, 3.0)));
        QVERIFY(glm::distance(back, glm::dvec3(1.0, 2.0, 3.0)) < 1e-12);
    }

    void weightsCount()
    {
        const std::vector<double> weights{1.0, 2.0, 3.0, 1.0, 0.5, 0.0};
        const auto s = similarityOf(specimens()[0], specimens()[1], Scaling::Regression, weights);
        QVERIFY(s);
        QVERIFY(isClose(s->scale, 0.8921046058412625));
        QVERIFY(isClose(s->rotation[0][0], 0.08339826672729472));
        QVERIFY(isClose(s->translation.x, -9.073984749365621));
    }

    void sizesGiveTheScale()
    {
        const auto s = similarityOf(specimens()[0], specimens()[1], Scaling::Sizes);
        QVERIFY(s);
        QVERIFY(isClose(s->scale, 0.9025009908153554));
        QVERIFY(isClose(s->scale, centroidSizeOf(specimens()[1]) / centroidSizeOf(specimens()[0])));
    }

    void aMirroredSpecimenIsNotReflected()
    {
        Points mirrored = specimens()[0];
        for (auto &point : mirrored)
            point->x = -point->x;
        const auto s = similarityOf(specimens()[0], mirrored);
        QVERIFY(s);
        QVERIFY(isClose(glm::determinant(s->rotation), 1.0));
        QVERIFY(isClose(s->scale, 0.8245607990035667));
        QVERIFY(isClose(s->translation.x, 23.46549642382829));
    }

    void aKnownMapComesBack()
    {
        Similarity known;
        known.scale = 2.5;
        known.rotation = glm::dmat3(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0); // a quarter turn about z
        known.translation = {7.0, -3.0, 11.0};
        // Three landmarks of a plane are enough.
        const Points three = points({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}});
        const auto s = similarityOf(three, known.mapped(three));
        QVERIFY(s);
        QVERIFY(isClose(s->scale, 2.5));
        QVERIFY(glm::distance(s->mapped(glm::dvec3(1.0, 2.0, 5.0)), known.mapped(glm::dvec3(1.0, 2.0, 5.0))) < 1e-12);
    }

    void coordinatesOfAMapKeepTheirDigits()
    {
        Similarity farAway;
        farAway.translation = {4e6, 5e5, 300.0};
        const auto s = similarityOf(farAway.mapped(specimens()[0]), specimens()[1]);
        QVERIFY(s);
        QVERIFY(isClose(s->scale, 0.8914350284232101, 1e-9)); // the last digits went with the translation
    }

    void tooLittleGivesNoSimilarity()
    {
        const Points two = points({{0, 0, 0}, {4, 0, 0}});
        QVERIFY(!similarityOf(two, two));
        const Points line = points({{0, 0, 0}, {4, 0, 0}, {10, 0, 0}, {20, 0.1, 0}}); // 0.5 % wide
        QVERIFY(!similarityOf(line, line));
        const Points wider = points({{0, 0, 0}, {4, 0, 0}, {10, 0, 0}, {20, 2, 0}});
        QVERIFY(similarityOf(wider, wider));
        QVERIFY(!similarityOf(wider, line));
        Points lacking = wider;
        lacking[0].reset();
        lacking[1].reset();
        QVERIFY(!similarityOf(wider, lacking));
        const std::vector<double> weights{0.0, 0.0, 1.0, 1.0};
        QVERIFY(!similarityOf(wider, wider, Scaling::Regression, weights));
        Points endless = wider;
        endless[2]->x = 1e300;
        QVERIFY(!similarityOf(endless, wider));
    }

    void aRobustFitIgnoresWhatIsOff()
    {
        Points from;
        for (int i = 0; i < 12; ++i)
            from.emplace_back(glm::dvec3(10.0 * std::cos(i), 10.0 * std::sin(i), 0.3 * i * i));
        Similarity known;
        known.scale = 0.5;
        known.translation = {3.0, 2.0, 1.0};
        Points to = known.mapped(from);
        std::swap(to[2], to[9]);
        *to[5] += glm::dvec3(4.0, -4.0, 4.0);
        const auto s = robustSimilarityOf(from, to);
        QVERIFY(s);
        QVERIFY(glm::distance(s->mapped(*from[0]), *to[0]) < 1e-9);
        QVERIFY(glm::distance(similarityOf(from, to)->mapped(*from[0]), *to[0]) > 0.5); // as least squares does not
    }

    void theMeanIsGowers()
    {
        const Superimposition all = superimposed(specimens());
        const auto distances = distancesIn(all.mean);
        QVERIFY(isClose(distances[0], 0.8094438586383408, 1e-10));
        QVERIFY(isClose(distances[1], 0.49269431876337183, 1e-10));
        QVERIFY(isClose(distances[2], 0.2980120932089953, 1e-10));
        QVERIFY(isClose(distances[3], 0.5670369943491065, 1e-10));
        QVERIFY(isClose(centroidSizeOf(all.mean), 1.0));
        const std::array expected{0.10146068598450853, 0.0850776935401559, 0.08418874520559844, 0.08701780663078708};
        for (std::size_t k = 0; k < 4; ++k) {
            QVERIFY(isClose(distanceOf(all.aligned[k], all.mean), expected[k], 1e-10));
            QVERIFY(isClose(centroidSizeOf(all.aligned[k]), 1.0)); // as in geomorph's gpagen
            QVERIFY(all.meanFromSpecimen[k]);
            QVERIFY(glm::distance(all.meanFromSpecimen[k]->mapped(*specimens()[k][3]), *all.aligned[k][3]) < 1e-14);
        }
    }

    void missingLandmarksAreLeftOut()
    {
        std::vector<Points> lacking = specimens();
        lacking[1][4].reset();
        lacking[3][0].reset();
        const Superimposition all = superimposed(lacking);
        const auto distances = distancesIn(all.mean);
        QVERIFY(isClose(distances[0], 0.822983837518415, 1e-10));
        QVERIFY(isClose(distances[1], 0.4925371759264438, 1e-10));
        QVERIFY(isClose(distances[2], 0.29782442388563385, 1e-10));
        QVERIFY(isClose(distances[3], 0.5637693930217964, 1e-10));
        const std::array sizes{1.0, 0.9703231897607314, 1.0, 0.8640256537093309};
        for (std::size_t k = 0; k < 4; ++k)
            QVERIFY(isClose(centroidSizeOf(all.aligned[k]), sizes[k], 1e-10));
        QVERIFY(!all.aligned[1][4]);
    }

    void aSpecimenWithTooFewIsNotAligned()
    {
        std::vector<Points> lacking = specimens();
        lacking[2] = {lacking[2][0], lacking[2][1]}; // shorter lists lack their ends
        const Superimposition all = superimposed(lacking);
        QVERIFY(!all.meanFromSpecimen[2]);
        QCOMPARE(all.aligned[2], Points(6));
        QVERIFY(all.meanFromSpecimen[3]);
        QCOMPARE(superimposed({}).aligned.size(), std::size_t(0));
        QCOMPARE(superimposed(std::vector<Points>{Points(3), Points(3)}).mean, Points(3));
    }

    void aRobustMeanStaysWithTheMany()
    {
        std::vector<Points> all = specimens();
        all.push_back(specimens()[0]);
        const Superimposition clean = superimposed(all, Estimate::Robust);
        *all[2][4] += glm::dvec3(30.0, 0.0, -20.0);
        const Superimposition robust = superimposed(all, Estimate::Robust);
        const Superimposition classic = superimposed(all);
        // The shape's distances between landmarks that did not move.
        QVERIFY(std::abs(distancesIn(robust.mean)[0] - distancesIn(clean.mean)[0]) < 0.02);
        QVERIFY(std::abs(distancesIn(classic.mean)[0] - distancesIn(clean.mean)[0]) > 0.03);
    }

    void mediansOfEvenAndOddCounts()
    {
        QCOMPARE(medianOf({3.0}), 3.0);
        QCOMPARE(medianOf({9.0, 1.0, 4.0}), 4.0);
        QCOMPARE(medianOf({9.0, 1.0, 4.0, 6.0}), 5.0);
        QVERIFY(isClose(kSpreadPerMedian, std::sqrt(3.0) / 1.5381722544550522, 1e-5)); // scipy.stats.chi(3).median()
    }
};

UNPROJECTOR_TEST(TestProcrustes)
#include "test_procrustes.moc"
