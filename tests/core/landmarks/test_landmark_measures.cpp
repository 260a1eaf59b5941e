// Measurements between landmarks, and their errors.

#include "tests/support/test.h"

#include "core/landmarks/measure.h"
#include "core/landmarks/symmetry.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <random>

using namespace unprojector::geometry;
using namespace unprojector::landmarks;

namespace {

Landmark at(double x, double y, double z, std::optional<double> uncertainty = std::nullopt)
{
    Landmark landmark;
    landmark.world = WorldPoint(x, y, z);
    if (uncertainty)
        landmark.uncertainty = WorldVector(*uncertainty, *uncertainty, *uncertainty);
    return landmark;
}

Landmark named(const char *name, double x, double y, double z)
{
    Landmark landmark = at(x, y, z);
    landmark.name = name;
    return landmark;
}

const Landmark kMissing;

std::optional<MirrorPlane> mirrorPlaneOf(const std::vector<Landmark> &landmarks, const std::vector<Pair> &pairs)
{
    const auto symmetry = symmetryOf(landmarks, pairs);
    return symmetry ? std::optional(symmetry->plane) : std::nullopt;
}

using Points = std::vector<Landmark>;
using Measuring = std::function<Measured(const Points &)>;

Measured lengthOf(const Points &points)
{
    std::vector<const Landmark *> pointers;
    for (const Landmark &landmark : points)
        pointers.push_back(&landmark);
    return lengthAlong(pointers);
}

} // namespace

Q_DECLARE_METATYPE(Measuring)
Q_DECLARE_METATYPE(Points)

namespace {

/// Symmetric about a plane, far from the origin.
Points symmetric(const glm::dvec3 &normal, const glm::dvec3 &on)
{
    Points points;
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    const auto add = [&points](const std::string &name, const glm::dvec3 &p) {
        points.push_back(named(name.c_str(), p.x, p.y, p.z));
    };
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 p(anywhere(engine), anywhere(engine), anywhere(engine));
        const glm::dvec3 foot = p - glm::dot(p, normal) * normal;
        const double half = 0.2 + std::abs(anywhere(engine));
        add("L " + std::to_string(i), on + foot - half * normal);
        add("R " + std::to_string(i), on + foot + half * normal);
        add("mid " + std::to_string(i), on + foot * 0.5);
    }
    return points;
}

} // namespace

class TestLandmarkMeasures : public QObject {
    Q_OBJECT

private slots:
    void values()
    {
        QCOMPARE(distanceOf(at(1, 2, 3), at(4, 6, 3)).value().value, 5.0);
        QCOMPARE(lengthOf({at(0, 0, 0), at(3, 4, 0), at(3, 4, 2), at(3, 4, 0)}).value().value, 9.0);
        QCOMPARE(angleAt(at(1, 1, 1), at(5, 1, 1), at(1, 1, 9)).value().value, std::acos(0.0));
        QCOMPARE(angleAt(at(0, 0, 0), at(1, 0, 0), at(-2, 0, 0)).value().value, std::acos(-1.0));
        QCOMPARE(angleAt(at(0, 0, 0), at(1, 0, 0), at(1, 1e-9, 0)).value().value,
                 1e-9); // acos of the cosine would say 0
        QCOMPARE(heightOver(at(0, 0, 1), at(4, 0, 1), at(0, 5, 1), at(9, 9, 3)).value().value, 2.0);
        QCOMPARE(heightOver(at(0, 0, 1), at(0, 5, 1), at(4, 0, 1), at(9, 9, 3)).value().value, -2.0);
    }

    void valuesOfAnySize_data()
    {
        addColumn<double>("scale");
        for (const double scale : {1e-200, 1.0, 1e155, 1e200, 1e305})
            addRow("%g", scale) << scale;
    }

    /// Squares of these coordinates overflow or vanish.
    void valuesOfAnySize()
    {
        QFETCH(double, scale);
        const auto point = [scale](double x, double y, double z) { return at(x * scale, y * scale, z * scale, scale); };
        const Landmark a = point(0, 0, 0), b = point(300, 0, 0), c = point(0, 400, 0), over = point(10, 20, 50);
        const auto isNear = [](double value, double expected) { return std::abs(value - expected) < 1e-14 * expected; };
        const Measured distance = distanceOf(b, c), angle = angleAt(b, a, c), height = heightOver(a, b, c, over);
        QVERIFY(distance && angle && height);
        QVERIFY2(isNear(distance->value / scale, 500.0) && isNear(*distance->error / scale, 2.0 * (0.6 + 0.8)),
                 qPrintable(QString::number(distance->value)));
        QVERIFY(isNear(angle->value, std::atan2(4.0, 3.0)));
        QVERIFY(*angle->error > 0.0 && *angle->error < 0.1);
        QVERIFY(isNear(height->value / scale, 50.0));
        QVERIFY(isNear(*height->error / scale, 2.0));
    }

    void errorsAreTheWorstThatCanBe_data()
    {
        addColumn<Measuring>("measure");
        addColumn<int>("count");
        newRow("distance") << Measuring([](const Points &p) { return distanceOf(p[0], p[1]); }) << 2;
        newRow("polyline") << Measuring(lengthOf) << 5;
        newRow("angle") << Measuring([](const Points &p) { return angleAt(p[0], p[1], p[2]); }) << 3;
        newRow("height") << Measuring([](const Points &p) { return heightOver(p[0], p[1], p[2], p[3]); }) << 4;
    }

    /// Expected to first order: the worst case is at a corner, where each coordinate moves in the
    /// direction that increases the value.
    void errorsAreTheWorstThatCanBe()
    {
        QFETCH(Measuring, measure);
        QFETCH(int, count);
        std::mt19937_64 engine(4);
        std::uniform_real_distribution<double> anywhere(-1.0, 1.0), small(0.0, 1e-6);
        for (int round = 0; round < 200; ++round) {
            Points points;
            for (int i = 0; i < count; ++i) {
                points.push_back(at(anywhere(engine), anywhere(engine), anywhere(engine)));
                points.back().uncertainty = WorldVector(small(engine), small(engine), small(engine));
            }
            const Measured exact = measure(points);
            QVERIFY(exact && exact->error);
            Points worst = points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                for (int axis = 0; axis < 3; ++axis) {
                    Points moved = points;
                    (*moved[i].world)[axis] += 1e-6;
                    const double side = measure(moved).value().value > exact->value ? 1.0 : -1.0;
                    (*worst[i].world)[axis] += side * (*points[i].uncertainty)[axis];
                }
            }
            const double off = measure(worst).value().value - exact->value;
            QVERIFY2(std::abs(off - *exact->error) <= 1e-3 * *exact->error + 1e-9,
                     qPrintable(QString("%1 %2").arg(off).arg(*exact->error)));
        }
    }

    void noErrorIsLargerThanItsBound_data()
    {
        addColumn<Measuring>("measure");
        addColumn<Points>("points");
        const Measuring distance = [](const Points &p) { return distanceOf(p[0], p[1]); };
        const Measuring angle = [](const Points &p) { return angleAt(p[0], p[1], p[2]); };
        const auto off = [](Landmark landmark, double x, double y, double z) {
            landmark.uncertainty = WorldVector(x, y, z);
            return landmark;
        };
        newRow("closer than they are sure") << distance << Points{at(0, 0, 0, 0.0), off(at(1e-9, 0, 0), 0, 0.1, 0.2)};
        newRow("a way there and back") << Measuring(lengthOf)
                                       << Points{at(0, 0, 0, 0.0), off(at(0, 1e-9, 0), 0.1, 0, 0), at(0, 0, 0, 0.0)};
        newRow("nearly no angle") << angle
                                  << Points{at(0, 0, 0, 0.0), at(5, 0, 0, 0.0), off(at(5, 1e-9, 0), 0, 0, 0.1)};
        newRow("nearly a straight one") << angle
                                        << Points{at(0, 0, 0, 0.0), at(5, 0, 0, 0.0), off(at(-5, 1e-9, 0), 0, 0, 0.1)};
        newRow("a leg as short as it is sure")
            << angle << Points{at(0, 0, 0, 0.0), at(5, 0, 0, 0.0), at(0, 0.1, 0, 0.2)};
    }

    /// The bound holds wherever the points are within their uncertainties.
    void noErrorIsLargerThanItsBound()
    {
        QFETCH(Measuring, measure);
        QFETCH(Points, points);
        const Measured exact = measure(points);
        QVERIFY(exact && exact->error);
        std::mt19937_64 engine(5);
        std::uniform_real_distribution<double> share(-1.0, 1.0);
        double most = 0.0;
        for (int round = 0; round < 2000; ++round) {
            Points moved = points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                for (int axis = 0; axis < 3; ++axis)
                    (*moved[i].world)[axis] += share(engine) * (*points[i].uncertainty)[axis];
            }
            most = std::max(most, std::abs(measure(moved).value().value - exact->value));
        }
        QVERIFY(most > 0.0);
        QVERIFY2(most <= 1.01 * *exact->error, qPrintable(QString("%1 %2").arg(most).arg(*exact->error)));
    }

    /// Expected to first order: each coordinate moves in the direction that increases the value.
    void errorsOfTheMirrorPlane()
    {
        Points points = symmetric(glm::normalize(glm::dvec3(1, -2, 0.5)), {3, -4, 5});
        std::mt19937_64 engine(13);
        std::uniform_real_distribution<double> little(-0.05, 0.05), small(0.0, 1e-6);
        for (Landmark &landmark : points) {
            *landmark.world += WorldVector(little(engine), little(engine), little(engine));
            landmark.uncertainty = WorldVector(small(engine), small(engine), small(engine));
        }
        const std::vector<Pair> pairs = pairsByName(points);
        const auto exact = symmetryOf(points, pairs);
        QVERIFY(exact && exact->offsetError);
        const auto check = [&](const auto &valueOf, double error) {
            Points worst = points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                for (int axis = 0; axis < 3; ++axis) {
                    Points moved = points;
                    (*moved[i].world)[axis] += 1e-6;
                    const double side = valueOf(*symmetryOf(moved, pairs)) > valueOf(*exact) ? 1.0 : -1.0;
                    (*worst[i].world)[axis] += side * (*points[i].uncertainty)[axis];
                }
            }
            const double off = valueOf(*symmetryOf(worst, pairs)) - valueOf(*exact);
            QVERIFY2(std::abs(off - error) <= 1e-2 * error, qPrintable(QString("%1 %2").arg(off).arg(error)));
        };
        check([](const Symmetry &symmetry) { return symmetry.plane.offset; }, *exact->offsetError);
        for (std::size_t i = 0; i < points.size(); ++i)
            check([i](const Symmetry &symmetry) { return symmetry.asymmetries[i]->value; },
                  *exact->asymmetries[i]->error);
        for (std::size_t i = 0; i < points.size(); ++i)
            check([i](const Symmetry &symmetry) { return symmetry.distances[i]->value; }, *exact->distances[i]->error);
        const auto values = asymmetriesOf(points, pairs, *mirrorPlaneOf(points, pairs));
        for (std::size_t i = 0; i < points.size(); ++i)
            QCOMPARE(exact->asymmetries[i]->value, *values[i]);
        // Symmetric points have no direction of asymmetry, but its error is positive all the same.
        Points alike = symmetric({1, 0, 0}, {0, 0, 0});
        for (Landmark &landmark : alike)
            landmark.uncertainty = WorldVector(0.01, 0.01, 0.01);
        const auto open = symmetryOf(alike, pairs);
        QVERIFY(open);
        for (const std::optional<Measure> &one : open->asymmetries)
            QVERIFY(*one->error > 0.01);
        // A point without an uncertainty leaves every dependent error unknown.
        alike[3].uncertainty.reset();
        const auto unknown = symmetryOf(alike, pairs);
        QVERIFY(!unknown->offsetError && !unknown->asymmetries[0]->error && !unknown->distances[0]->error);
    }

    void errorsWithoutADirection()
    {
        const double length = std::sqrt(3.0);
        QCOMPARE(*distanceOf(at(1, 1, 1, 0.5), at(1, 1, 1, 0.25)).value().error, 0.75 * length);
        QCOMPARE(*angleAt(at(0, 0, 0, 0.0), at(2, 0, 0, 0.5), at(4, 0, 0, 0.5)).value().error,
                 0.5 * length / 2.0 + 0.5 * length / 4.0);
        QCOMPARE(*angleAt(at(0, 0, 0, 0.5), at(2, 0, 0, 0.0), at(4, 0, 0, 0.0)).value().error, 0.5 * length * 0.75);
    }

    void unknownUncertainties()
    {
        QVERIFY(!distanceOf(at(0, 0, 0, 1.0), at(1, 0, 0)).value().error);
        QVERIFY(!heightOver(at(0, 0, 1), at(4, 0, 1, 0.1), at(0, 5, 1, 0.1), at(9, 9, 3, 0.1)).value().error);
        QCOMPARE(*distanceOf(at(0, 0, 0, 0.0), at(1, 0, 0, 0.0)).value().error, 0.0);
    }

    void whatCannotBeMeasured()
    {
        using Code = MeasureError::Code;
        const auto is = [](const Measured &measured, Code code, std::size_t point) {
            return !measured && measured.error().code == code && measured.error().point == point;
        };
        QVERIFY(is(distanceOf(at(0, 0, 0), kMissing), Code::Missing, 1));
        QVERIFY(is(lengthOf({at(0, 0, 0)}), Code::TooFew, 0));
        QVERIFY(is(angleAt(at(1, 0, 0), at(2, 0, 0), at(1, 0, 0)), Code::SamePoint, 2));
        QVERIFY(is(heightOver(at(0, 0, 0), at(1, 1, 1), at(3, 3, 3), at(1, 0, 0)), Code::NoPlane, 0));
        // The points are on one line but for rounding, far from the origin too; or may be on one within
        // their uncertainties.
        QVERIFY(is(heightOver(at(0.1, 0.2, 0.3), at(0.7, 1.4, 2.1), at(1.1, 2.2, 3.3), at(1, 0, 0)), Code::NoPlane, 0));
        QVERIFY(is(heightOver(at(4e6, 5e5, 300), at(4e6 + 0.1, 5e5 + 0.1, 300.1), at(4e6 + 0.7, 5e5 + 0.7, 300.7),
                              at(4e6, 5e5, 301)),
                   Code::NoPlane, 0));
        QVERIFY(is(heightOver(at(0, 0, 0, 0.1), at(1, 0, 0, 0.1), at(0.5, 1e-6, 0, 0.1), at(0.5, 0, 1, 0.1)),
                   Code::NoPlane, 0));
        QVERIFY(heightOver(at(4e6, 5e5, 300), at(4e6 + 0.1, 5e5, 300), at(4e6, 5e5 + 0.1, 300), at(4e6, 5e5, 301)));
    }

    void pairsHaveNames()
    {
        const Points points{
            named("Nasion", 0, 0, 0),         named("L_eye", 0, 0, 0),         named("R_eye", 0, 0, 0),
            named("Orbitale right", 0, 0, 0), named("orbitale LEFT", 0, 0, 0), named("ear (l)", 0, 0, 0),
            named("ear (r)", 0, 0, 0),        named("lip", 0, 0, 0),           named("rip", 0, 0, 0),
            named("left brow", 0, 0, 0),      named("brow right", 0, 0, 0),    named("R", 0, 0, 0),
            named("jaw-l", 0, 0, 0),          named("jaw-r", 0, 0, 0),         named("jaw-r", 0, 0, 0),
            named("cheek.L", 0, 0, 0),        named("cheek.l", 0, 0, 0),       named("cheek.R", 0, 0, 0)};
        const std::vector<Pair> expected{{1, 2}, {4, 3}, {5, 6}};
        QVERIFY(pairsByName(points) == expected);

        const Points chinese{named("左外眼角", 0, 0, 0),     named("右外眼角", 0, 0, 0), named("耳屏点（右）", 0, 0, 0),
                             named("耳屏点（左）", 0, 0, 0), named("左右中点", 0, 0, 0), named("鼻尖", 0, 0, 0),
                             named("颧点左", 0, 0, 0)};
        const std::vector<Pair> expectedOfChinese{{0, 1}, {3, 2}};
        QVERIFY(pairsByName(chinese) == expectedOfChinese);
        QVERIFY(isSided("颧点左") && !isSided("左右中点") && !isSided("左"));
    }

    void aMirrorPlaneIsFound()
    {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(1, -2, 0.5)), on(1000, 2000, -300);
        Points points = symmetric(normal, on);
        points.push_back(named("L gone", 5, 5, 5));
        points.push_back(kMissing);
        points.back().name = "R gone";
        const std::vector<Pair> pairs = pairsByName(points);
        QCOMPARE(pairs.size(), std::size_t(7));
        const auto plane = mirrorPlaneOf(points, pairs);
        QVERIFY(plane);
        QVERIFY(glm::length(plane->normal.coordinates() - normal) < 1e-11);
        QVERIFY(std::abs(plane->offset - glm::dot(normal, on)) < 1e-8);
        const auto off = asymmetriesOf(points, pairs, *plane);
        for (std::size_t i = 0; i < 18; ++i)
            QVERIFY(off[i] && *off[i] < 1e-10);
        QVERIFY(!off[18] && !off[19]);
    }

    void asymmetryIsMeasured()
    {
        // A given plane: a point moved by (3, 4, 0) square to its normal is 5 off, on both sides.
        const MirrorPlane plane{WorldVector(0, 0, 1), 2.0};
        const Points points{named("L a", 0, 0, 1), named("R a", 3, 4, 3), named("mid", 7, 7, 2.25)};
        const auto off = asymmetriesOf(points, pairsByName(points), plane);
        QCOMPARE(*off[0], 5.0);
        QCOMPARE(*off[1], 5.0);
        QCOMPARE(*off[2], 0.5);

        // A landmark of the middle is as far from its mirror image as from the plane and back.
        const MirrorPlane almostX{normalized(WorldVector(1, -0.0011826, 0)), 44.98397};
        const Points middle{named("mid3", 45.4, 70, 0)};
        QCOMPARE(std::round(1e4 * almostX.distanceTo(*middle[0].world)), 3332.0);
        QCOMPARE(std::round(1e4 * *asymmetriesOf(middle, {}, almostX)[0]), 6664.0);

        // A fitted plane: no plane near it is better.
        Points moved = symmetric({1, 0, 0}, {0, 0, 0});
        std::mt19937_64 engine(12);
        std::uniform_real_distribution<double> little(-0.05, 0.05);
        for (Landmark &landmark : moved)
            *landmark.world += WorldVector(little(engine), little(engine), little(engine));
        const std::vector<Pair> pairs = pairsByName(moved);
        const auto best = mirrorPlaneOf(moved, pairs);
        QVERIFY(best);
        const auto sumOf = [&](const MirrorPlane &other) {
            double sum = 0.0;
            for (const auto &one : asymmetriesOf(moved, pairs, other))
                sum += *one * *one;
            return sum;
        };
        const double least = sumOf(*best);
        for (int i = 0; i < 500; ++i) {
            MirrorPlane other = *best;
            other.normal = normalized(other.normal + 0.1 * WorldVector(little(engine), little(engine), little(engine)));
            other.offset += 0.1 * little(engine);
            QVERIFY(sumOf(other) >= least);
        }
    }

    /// Three pairs about the plane x = 1, and two landmarks of the middle at x = 1.3 and x = 0.7.
    void theMiddleIsMeasuredFromThePlane()
    {
        const Points points{named("L a", -2, 0, 0),   named("R a", 4, 0, 0),   named("L b", -1, 3, 1),
                            named("R b", 3, 3, 1),    named("L c", -4, 1, 5),  named("R c", 6, 1, 5),
                            named("top", 1.3, 9, 2),  named("tip", 0.7, 9, 2), named("L d", 0, 2, 7),
                            named("tail", 99, 0, 0.5)};
        Points placed = points;
        placed.back().world.reset();
        const auto symmetry = symmetryOf(placed, pairsByName(placed));
        QVERIFY(symmetry);
        QVERIFY(std::abs(symmetry->plane.normal.x - 1.0) < 1e-15 && std::abs(symmetry->plane.offset - 1.0) < 1e-14);
        const std::array<double, 8> distances{3, 3, 2, 2, 5, 5, 0.3, 0.3}, asymmetries{0, 0, 0, 0, 0, 0, 0.6, 0.6};
        for (std::size_t i = 0; i < distances.size(); ++i) {
            QVERIFY(std::abs(symmetry->distances[i]->value - distances[i]) < 1e-14);
            QVERIFY(std::abs(symmetry->asymmetries[i]->value - asymmetries[i]) < 1e-14);
        }
        QVERIFY(!symmetry->distances[8] && !symmetry->distances[9]); // no partner; no position
        // The rectangle of the plane: y from 0 to 9, z from 0 to 5, and a tenth of 9 around.
        const auto corners = rectangleOf(symmetry->plane, placed, symmetry->counted);
        const std::array<glm::dvec3, 4> expected{{{1, -0.9, -0.9}, {1, 9.9, -0.9}, {1, 9.9, 5.9}, {1, -0.9, 5.9}}};
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY(glm::length(corners[i].coordinates() - expected[i]) < 1e-13);
    }

    void noMirrorPlane()
    {
        QVERIFY(!mirrorPlaneOf({}, {}));
        const Points midline{named("a", 0, 0, 0), named("b", 1, 0, 0), named("c", 0, 1, 0)};
        QVERIFY(!mirrorPlaneOf(midline, pairsByName(midline)));
        // An additional pair gives a plane: only the pair was missing above.
        Points withPair = midline;
        withPair.push_back(named("L d", 0, 0, -1));
        withPair.push_back(named("R d", 0, 0, 1));
        QVERIFY(mirrorPlaneOf(withPair, pairsByName(withPair)));
        const Points one{named("L a", 1, 1, 1), named("R a", 1, 1, 1)};
        QVERIFY(!mirrorPlaneOf(one, pairsByName(one)));
    }
};

UNPROJECTOR_TEST(TestLandmarkMeasures)
#include "test_landmark_measures.moc"
