// The camera's axes and both transforms between eye and world.

#include "tests/support/test.h"

#include "core/geometry/camera.h"
#include "tests/support/core_scene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// Rounding of a unit vector's components and of the dot product that checks it.
constexpr double kOrthonormal = 4 * kEpsilon;
/// Three products, four roundings, each way; relative to the largest of eye, point and their
/// distance.
constexpr double kRoundTrip = 16 * kEpsilon;

double maxNorm(const Components<3> &v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

class TestCamera : public QObject {
    Q_OBJECT

private slots:
    void literalAxes_data()
    {
        addColumn<LookAt>("camera");
        addColumn<WorldVector>("side");
        addColumn<WorldVector>("upward");
        addColumn<WorldVector>("forward");

        const auto row = [](const char *name, const LookAt &camera, const WorldVector &side, const WorldVector &upward,
                            const WorldVector &forward) { newRow(name) << camera << side << upward << forward; };
        const WorldPoint origin;
        // World x points right when the camera looks down -z: the paper's figure has it to the left.
        row("from the front", {WorldPoint(0, 0, 5), origin, {0, 1, 0}}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1});
        row("from the back", {WorldPoint(0, 0, -5), origin, {0, 1, 0}}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1});
        row("from the right", {WorldPoint(5, 0, 0), origin, {0, 1, 0}}, {0, 0, -1}, {0, 1, 0}, {-1, 0, 0});
        row("from above, north up", {WorldPoint(0, 5, 0), origin, {0, 0, -1}}, {1, 0, 0}, {0, 0, -1}, {0, -1, 0});
        row("upside down", {WorldPoint(0, 0, 5), origin, {0, -2, 0}}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1});
        row("a tilted up is straightened", {WorldPoint(0, 0, 5), origin, {0, 3, 7}}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1});
        row("3-4-5", {WorldPoint(1, 1, 1), WorldPoint(4, 1, -3), {0, 1, 0}}, {0.8, 0, 0.6}, {0, 1, 0}, {0.6, 0, -0.8});
    }

    void literalAxes()
    {
        QFETCH(LookAt, camera);
        QFETCH(WorldVector, side);
        QFETCH(WorldVector, upward);
        QFETCH(WorldVector, forward);
        const EyeFrame frame = eyeFrame(camera).value();
        QVERIFY(maxNorm(frame.side - side) <= kEpsilon);
        QVERIFY(maxNorm(frame.upward - upward) <= kEpsilon);
        QVERIFY(maxNorm(frame.forward - forward) <= kEpsilon);
        QVERIFY(frame.eye == camera.eye);
    }

    void axesAreOrthonormalAndRightHanded_data()
    {
        addColumn<quint64>("seed");
        addColumn<double>("eyeHigh");
        newRow("eyes up to 10 away") << quint64(21) << 10.0;
        newRow("eyes up to 10^6 away") << quint64(22) << 1e6;
    }

    void axesAreOrthonormalAndRightHanded()
    {
        QFETCH(quint64, seed);
        QFETCH(double, eyeHigh);
        oracle::Random random(seed);
        oracle::SceneLimits limits;
        limits.eyeHigh = eyeHigh;
        for (int count = 0; count < 2000; ++count) {
            const oracle::Scene scene = oracle::randomScene(random, oracle::RandomKind::Ortho, limits);
            const EyeFrame frame = eyeFrame(oracle::coreView(scene.view)).value();
            const auto &[eye, s, u, f] = frame;
            for (const WorldVector &axis : {s, u, f})
                QVERIFY(std::abs(dot(axis, axis) - 1.0) <= kOrthonormal);
            QVERIFY(std::abs(dot(s, u)) <= kOrthonormal);
            QVERIFY(std::abs(dot(s, f)) <= kOrthonormal);
            QVERIFY(std::abs(dot(u, f)) <= kOrthonormal);
            QVERIFY(maxNorm(cross(s, f) - u) <= kOrthonormal);
            const WorldVector up(scene.view.up[0], scene.view.up[1], scene.view.up[2]);
            QVERIFY(dot(u, up) > 0.0);
        }
    }

    void worldFromEyeUndoesEyeFromWorld_data() { axesAreOrthonormalAndRightHanded_data(); }

    void worldFromEyeUndoesEyeFromWorld()
    {
        QFETCH(quint64, seed);
        QFETCH(double, eyeHigh);
        oracle::Random random(seed);
        oracle::SceneLimits limits;
        limits.eyeHigh = eyeHigh;
        for (int count = 0; count < 2000; ++count) {
            const oracle::Scene scene = oracle::randomScene(random, oracle::RandomKind::Ortho, limits);
            const EyeFrame frame = eyeFrame(oracle::coreView(scene.view)).value();
            const WorldPoint world(random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-100, 100));
            const double scale = std::max({maxNorm(world), maxNorm(frame.eye), distance(world, frame.eye)});
            QVERIFY(maxNorm(worldFromEye(frame, eyeFromWorld(frame, world)) - world) <= kRoundTrip * scale);

            const EyePoint eye(random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-100, 100));
            const double eyeScale = std::max(maxNorm(frame.eye), 100.0);
            QVERIFY(maxNorm(eyeFromWorld(frame, worldFromEye(frame, eye)) - eye) <= kRoundTrip * eyeScale);
        }
    }

    void theMatrixDoesWhatTheFunctionDoes()
    {
        const EyeFrame frame = eyeFrame({WorldPoint(1, 2, 3), WorldPoint(-4, 0, 1), {0, 1, 0}}).value();
        const glm::dmat4 matrix = eyeFromWorld(frame);
        for (const WorldPoint &world : {WorldPoint(0, 0, 0), WorldPoint(1, 2, 3), WorldPoint(-7, 8, 9)}) {
            const glm::dvec4 product = matrix * glm::dvec4(world.coordinates(), 1.0);
            QVERIFY(maxNorm(EyePoint(glm::dvec3(product)) - eyeFromWorld(frame, world)) <= 20 * kRoundTrip);
            QCOMPARE(product.w, 1.0);
        }
        QVERIFY(eyeFromWorld(frame, WorldPoint(1, 2, 3)) == EyePoint());
        QVERIFY(worldFromEye(frame, EyePoint()) == WorldPoint(1, 2, 3));
    }

    void theScaleOfUpDoesNotMatter()
    {
        const EyeFrame one = eyeFrame({WorldPoint(1, 2, 3), WorldPoint(-4, 0, 1), {0.25, 1, 0.5}}).value();
        for (const double scale : {0x1p-900, 0x1p-3, 0x1p+3, 0x1p+900}) {
            const WorldVector up = scale * WorldVector(0.25, 1, 0.5);
            const EyeFrame other = eyeFrame({WorldPoint(1, 2, 3), WorldPoint(-4, 0, 1), up}).value();
            QVERIFY(maxNorm(other.side - one.side) <= kEpsilon);
            QVERIFY(maxNorm(other.upward - one.upward) <= kEpsilon);
        }
    }
};

UNPROJECTOR_TEST(TestCamera)
#include "test_camera.moc"
