// Where the next landmark of a specimen is expected, from the others.

#include "tests/support/test.h"

#include "core/landmarks/expected_places.h"
#include "tests/core/landmarks/simulated_series.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace unprojector::landmarks;

namespace {

/// A tetrahedron with two landmarks more.
const Configuration kShape{glm::dvec3(0.0, 0.0, 0.0), glm::dvec3(10.0, 0.0, 0.0), glm::dvec3(0.0, 8.0, 0.0),
                           glm::dvec3(0.0, 0.0, 6.0), glm::dvec3(4.0, 4.0, 4.0),  glm::dvec3(9.0, 1.0, 3.0)};

Configuration firstOf(const Configuration &points, std::size_t count)
{
    Configuration first(points.size());
    for (std::size_t j = 0; j < count; ++j)
        first[j] = points[j];
    return first;
}

Similarity someMap()
{
    Similarity map;
    map.scale = 3.0;
    map.rotation = glm::dmat3(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    map.translation = {100.0, -50.0, 20.0};
    return map;
}

} // namespace

class TestExpectedPlaces : public QObject {
    Q_OBJECT

private slots:
    void equalSpecimensAreFoundExactly()
    {
        const Similarity map = someMap();
        const Configuration own = map.mapped(kShape);
        const PlaceExpectation expectation(std::vector<Configuration>{kShape, kShape});
        const ExpectedPlaces found = expectation.placesFor(firstOf(own, 3));
        QVERIFY(!found.reason);
        for (std::size_t j = 0; j < own.size(); ++j) {
            QCOMPARE(found.places[j].has_value(), j >= 3);
            if (j < 3)
                continue;
            QVERIFY(glm::distance(found.places[j]->place, *own[j]) < 1e-10);
            QVERIFY(*found.places[j]->spread < 1e-10);
        }
        // One other specimen knows no spread.
        const ExpectedPlaces one = PlaceExpectation(std::vector<Configuration>{kShape}).placesFor(firstOf(own, 3));
        QVERIFY(glm::distance(one.places[4]->place, *own[4]) < 1e-10);
        QVERIFY(!one.places[4]->spread);
    }

    void theSpreadIsThatOfTheOtherSpecimens()
    {
        // The first four landmarks agree; the fifth is 1 apart on both others: each finds it 1 off.
        Configuration other = kShape;
        *other[4] += glm::dvec3(0.0, 0.0, 1.0);
        const Configuration own = someMap().mapped(kShape);
        const PlaceExpectation expectation(std::vector<Configuration>{kShape, other});
        const ExpectedPlaces found = expectation.placesFor(firstOf(own, 4));
        QVERIFY(std::abs(*found.places[4]->spread - 3.0) < 0.05); // in the units of this specimen
        QVERIFY(glm::distance(found.places[4]->place, someMap().mapped(glm::dvec3(4.0, 4.0, 4.5))) < 0.1);
    }

    void theSpreadHoldsInSimulatedSeries()
    {
        // The root of the mean square of (distance / spread) is 1 if the spread is right; a spread from 11
        // others is itself uncertain, so it is a little more.
        simulated::Random random(3);
        for (const std::size_t known : {std::size_t(3), std::size_t(10)}) {
            double squares = 0.0, count = 0.0;
            for (int i = 0; i < tests::rounds(50); ++i) {
                simulated::Kind kind;
                kind.hasMistakes = false;
                const simulated::Series series = simulated::series(random, kind);
                Configuration placed(series.scans[0].size());
                for (std::size_t j = 0; j < known; ++j)
                    placed[placed.size() - 1 - 2 * j] = series.scans[0][placed.size() - 1 - 2 * j];
                placed[0] = series.scans[0][0];
                const PlaceExpectation expectation(std::span(series.scans).subspan(1));
                const ExpectedPlaces found = expectation.placesFor(placed);
                for (std::size_t j = 0; j < placed.size(); ++j) {
                    if (!found.places[j])
                        continue;
                    const double off =
                        glm::distance(found.places[j]->place, *series.scans[0][j]) / *found.places[j]->spread;
                    squares += off * off;
                    count += 1.0;
                }
            }
            const double ratio = std::sqrt(squares / count);
            qInfo("%zu placed: distance is %.3f spreads", known + 1, ratio);
            QVERIFY(ratio > 0.85 && ratio < 1.2);
        }
    }

    void aMistakeOnAnotherSpecimenChangesLittle()
    {
        std::vector<Configuration> others(5, kShape);
        std::swap(others[1][0], others[1][4]);
        const Configuration own = someMap().mapped(kShape);
        const ExpectedPlaces found = PlaceExpectation(others).placesFor(firstOf(own, 4));
        QVERIFY(glm::distance(found.places[4]->place, *own[4]) < 1e-6);
    }

    void reasonsAreGiven()
    {
        const std::vector<Configuration> others{kShape, kShape};
        QVERIFY(PlaceExpectation().placesFor(kShape).reason == NoExpectedPlaces::NoOthers);
        QVERIFY(PlaceExpectation(std::vector<Configuration>(2)).placesFor(kShape).reason == NoExpectedPlaces::NoOthers);
        QVERIFY(PlaceExpectation(others).placesFor(firstOf(kShape, 2)).reason == NoExpectedPlaces::TooFew);
        Configuration line(kShape.size());
        for (std::size_t j = 0; j < 3; ++j)
            line[j] = glm::dvec3(static_cast<double>(j), 0.0, 0.0);
        QVERIFY(PlaceExpectation(others).placesFor(line).reason == NoExpectedPlaces::OnALine);
        const ExpectedPlaces all = PlaceExpectation(others).placesFor(kShape);
        QVERIFY(!all.reason);
        QVERIFY(!all.places[0]);
    }
};

UNPROJECTOR_TEST(TestExpectedPlaces)
#include "test_expected_places.moc"
