// The way forward against an independent oracle of 50 digits, over thousands of random cameras of
// every kind.

#include "tests/support/test.h"

#include "core/geometry/transform.h"
#include "core/geometry/way_forward.h"
#include "tests/support/core_scene.h"
#include "tests/support/random_kinds.h"

#include <boost/math/constants/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace unprojector::geometry;
using oracle::Extended;
using oracle::RandomKind;

namespace {

/// A number rounded once is half a unit in the last place off at most; the rest is for numbers that
/// two doubles are equally near to.
constexpr double kUlps = 0.51;
/// The shares below which a coordinate counts as cancelled: it is far smaller than the others of
/// its stage. Cancellation leaves it fewer of its 32 digits, and fewer still where the object's
/// place has cancelled before.
constexpr double kLeastShare = 1e-9, kLeastShareFarAway = 1e-5;

template <std::size_t count>
double worstUlps(const std::array<DoubleDouble, count> &actual, const std::array<Extended, count> &exact,
                 double leastShare)
{
    double largest = 0.0, worst = 0.0;
    for (const Extended &number : exact)
        largest = std::max(largest, std::abs(static_cast<double>(number)));
    for (std::size_t k = 0; k < count; ++k) {
        const double size = std::max(std::abs(static_cast<double>(exact[k])), leastShare * largest);
        const double ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
        worst = std::max(worst, static_cast<double>(abs(Extended(actual[k].value) - exact[k])) / ulp);
    }
    return worst;
}

double worstUlps(const PreciseStages &actual, const oracle::Stages &exact, double leastShare = kLeastShare)
{
    return std::max({worstUlps(actual.eye, exact.eye, leastShare), worstUlps(actual.clip, exact.clip, leastShare),
                     worstUlps(actual.ndc, exact.ndc, leastShare), worstUlps(actual.window, exact.window, leastShare)});
}

oracle::Vector3 exactProduct(const glm::dmat4 &m, const glm::dvec3 &p)
{
    oracle::Vector3 result;
    for (int row = 0; row < 3; ++row)
        result[std::size_t(row)] =
            Extended(m[0][row]) * p.x + Extended(m[1][row]) * p.y + Extended(m[2][row]) * p.z + Extended(m[3][row]);
    return result;
}

WorldPoint roundedPoint(const oracle::Vector3 &v)
{
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

constexpr int kScenes = 1500, kClicks = 4;

} // namespace

Q_DECLARE_METATYPE(oracle::RandomKind)

class TestWayForward : public QObject {
    Q_OBJECT

private slots:
    void randomScenes_data() { addKinds(); }

    void randomScenes()
    {
        QFETCH(RandomKind, kind);
        oracle::Random random(20261126);
        double worst = 0.0;
        for (int i = 0; i < kScenes; ++i) {
            const oracle::Scene scene = oracle::randomScene(random, kind, {});
            const oracle::Oracle exact(scene.view, scene.projection, scene.target);
            const Result<WayForward> way = WayForward::of(oracle::corePicture(scene));
            QVERIFY(way);
            for (int k = 0; k < kClicks; ++k) {
                const WorldPoint world = roundedPoint(exact.worldUnder(oracle::randomClick(random, scene.target)));
                const oracle::Vector3 point = oracle::extended(world);
                worst = std::max(worst, worstUlps(way->fromWorld({world.x, world.y, world.z}), exact.forward(point)));
                const Result<WindowPoint> window = windowFromWorld(oracle::corePicture(scene), world);
                QVERIFY(window && window->x == way->fromWorld({world.x, world.y, world.z}).window[0].value);
            }
        }
        QVERIFY2(worst <= kUlps, QByteArray::number(worst));
    }

    void objectsFarFromTheOrigin_data() { addKinds(); }

    void objectsFarFromTheOrigin()
    {
        QFETCH(RandomKind, kind);
        oracle::Random random(7);
        double worst = 0.0;
        for (int i = 0; i < kScenes; ++i) {
            const oracle::Scene scene = oracle::randomScene(random, kind, {});
            const oracle::Oracle exact(scene.view, scene.projection, scene.target);
            const WayForward way = WayForward::of(oracle::corePicture(scene)).value();
            const WorldPoint world = roundedPoint(exact.worldUnder(oracle::randomClick(random, scene.target)));
            const glm::dvec3 place(random.sign() * random.uniform(1e8, 2e8), random.uniform(-1e3, 1e3),
                                   random.sign() * random.uniform(1e8, 2e8));
            const glm::dmat4 matrix =
                worldFromObject({Translate{-place}, Rotate{random.uniform(-180.0, 180.0), {0.3, 1.0, -0.2}},
                                 Scale{glm::dvec3(random.uniform(0.5, 2.0))}});
            const glm::dvec3 point = glm::dvec3(glm::inverse(matrix) * glm::dvec4(world.coordinates(), 1.0));
            worst = std::max(worst, worstUlps(way.fromWorld(PreciseMatrix(matrix).at(point)),
                                              exact.forward(exactProduct(matrix, point)), kLeastShareFarAway));
        }
        QVERIFY2(worst <= kUlps, QByteArray::number(worst));
    }

    void matrices_data() { addKinds(); }

    /// Matrices as another program has them, their last row a multiple of (0, 0, 0, 1), for both kinds
    /// of depths.
    void matrices()
    {
        QFETCH(RandomKind, kind);
        oracle::Random random(11);
        const auto numbersOf = [](const glm::dmat4 &m) {
            std::array<double, 16> numbers{};
            for (std::size_t k = 0; k < 16; ++k)
                numbers[k] = m[int(k / 4)][int(k % 4)];
            return numbers;
        };
        double worst = 0.0;
        for (int i = 0; i < kScenes; ++i) {
            const oracle::Scene scene = oracle::randomScene(random, kind, {});
            Setup setup = oracle::corePicture(scene);
            const glm::dmat4 view = 3.0 * eyeFromWorld(setup).value();
            const glm::dmat4 projection = clipFromEye(setup).value();
            const bool isZeroToOne = random.chance(0.5);
            setup.pose = view;
            setup.lens = MatrixProjection{projection, isZeroToOne ? NdcDepth::ZeroToOne : NdcDepth::MinusOneToOne};
            const oracle::Oracle exact(numbersOf(view), numbersOf(projection), scene.target, isZeroToOne);
            const WayForward way = WayForward::of(setup).value();
            const WorldPoint world = roundedPoint(exact.worldUnder(oracle::randomClick(random, scene.target)));
            worst = std::max(
                worst, worstUlps(way.fromWorld({world.x, world.y, world.z}), exact.forward(oracle::extended(world))));
        }
        QVERIFY2(worst <= kUlps, QByteArray::number(worst));
    }

    void anglesInDegrees_data()
    {
        addColumn<double>("degrees");
        for (const double degrees :
             {179.9, 179.0, 178.56, 173.60000000000002, 132.91171418488918, 120.0, 60.1, 45.0, 1.0, 0.001})
            addRow("%.17g", degrees) << degrees;
    }

    /// A field of view and a shear in degrees: the tangent is computed from the given degrees, not from
    /// the rounded radians.
    void anglesInDegrees()
    {
        QFETCH(double, degrees);
        const Extended exact = Extended(degrees) * boost::math::constants::pi<Extended>() / 180;
        const PreciseEdges edges = preciseEdges(Perspective{Angle::fromDegrees(degrees), 1.0, 1.0, 2.0});
        const auto isSame = [](const DoubleDouble &number, const Extended &truth) {
            return abs(Extended(number.value) + number.rest - truth) <= 1e-28 * abs(truth);
        };
        QVERIFY(isSame(edges.top, tan(exact / 2)));
        QVERIFY(isSame(preciseCotangent(Angle::fromDegrees(degrees)), 1 / tan(exact)));
        QCOMPARE(Angle::fromDegrees(degrees).degrees(), degrees);
        // Radians are taken as they are, and shown as the degrees with the fewest digits.
        const Angle rounded = radiansFromDegrees(degrees);
        QVERIFY(isSame(preciseEdges(Perspective{rounded, 1.0, 1.0, 2.0}).top,
                       tan(Extended(radiansFromDegrees(degrees)) / 2)));
        QVERIFY(rounded != Angle::fromDegrees(degrees));
        QVERIFY(std::abs(rounded.degrees() - degrees) <= 1e-15 * degrees);
    }

    void thePlaneOfTheEye()
    {
        Setup setup;
        setup.surface = {800, 600, 1.0};
        setup.viewport = wholeSurface(setup.surface);
        setup.lens = Projection(Frustum{-1.0, 1.0, -0.75, 0.75, 1.0, 4.0});
        setup.pose = LookAt{WorldPoint(0, 0, 5), WorldPoint(0, 0, 0), {0, 1, 0}};
        const PreciseStages stages = WayForward::of(setup).value().fromWorld({1.0, 2.0, 5.0});
        QCOMPARE(stages.clip[3].value, 0.0);
        QCOMPARE(stages.eye[0].value, 1.0);
        QVERIFY(!std::isfinite(stages.window[0].value));
        QVERIFY(windowFromWorld(setup, WorldPoint(1, 2, 5)).error().code == ErrorCode::PointAtInfinity);
        setup.viewport.width = 0.0;
        QVERIFY(WayForward::of(setup).error().code == ErrorCode::EmptyViewport);
    }
};

UNPROJECTOR_TEST(TestWayForward)
#include "test_way_forward.moc"
