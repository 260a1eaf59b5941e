// The doctor's diagnoses of wrong points. The points of the table were computed apart from this
// program, to four decimals: each mistake followed through the textbook formulas. Pairs go through
// the oracle.
#include "tests/support/test.h"

#include "core/base/resource.h"
#include "core/base/translation.h"
#include "core/doctor/diagnosis.h"
#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "core/doctor/variants.h"
#include "core/geometry/transform.h"
#include "core/unproject/exact_unprojection.h"
#include "core/unproject/unprojector.h"
#include "tests/core/doctor/doctor_oracle.h"
#include "tests/support/random_scene.h"

#include <nlohmann/json.hpp>

#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace unprojector;
using namespace unprojector::doctor;
using namespace unprojector::geometry;

namespace {

using doctor_oracle::oracleUnder;

const glm::dvec3 kTruth(0.5, 0.75, -0.25);

/// Viewport (100, 40, 800, 600) in a window of 1000 x 700; 45 degrees, near 1, far 100. The eye is
/// at (3, 2, 5); the model is moved by (2, 0, -1).
Case scene()
{
    Case result;
    result.setup = {{1000, 700, 1.0},
                    {100, 40, 800, 600},
                    {},
                    Projection(Perspective{std::numbers::pi / 4, 800.0 / 600.0, 1, 100}),
                    LookAt{WorldPoint(3, 2, 5), WorldPoint(0, 0, 0), {0, 1, 0}}};
    result.models = {{"box", worldFromObject({Translate{{2, 0, -1}}})}};
    return result;
}

double rounded(double number, int decimals)
{
    const double unit = std::pow(10.0, decimals);
    return std::round(number * unit) / unit;
}

WrongPoint pointAt(const Case &of, const WorldPoint &truth, const glm::dvec3 &got, int decimals = 4)
{
    const WindowPoint window = windowFromWorld(of.setup, truth).value();
    WrongPoint point;
    point.pixel = deviceFromWindow(of.setup.surface, window);
    point.depth = window.z;
    for (int axis = 0; axis < 3; ++axis)
        point.got[axis] = rounded(got[axis], decimals);
    point.lastDigit = glm::dvec3(std::pow(10.0, -decimals));
    return point;
}

Diagnosis diagnosed(const Case &of, const WrongPoint &point)
{
    return diagnose(of, {&point, 1}).value();
}

const Candidate *named(const Diagnosis &diagnosis, const std::string &id)
{
    const auto found = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                    [&](const Candidate &candidate) { return candidate.id == id; });
    return found == diagnosis.candidates.end() ? nullptr : &*found;
}

} // namespace

namespace {

/// Latin letters that Chinese texts have too: of formulas, names of functions and libraries, and
/// computed values.
bool hasEnglish(const std::string &text)
{
    static const QRegularExpression words(QStringLiteral("\\b[A-Za-z]{2,}[,;:]? [a-z]{2,}\\b"));
    return words.match(QString::fromStdString(text)).hasMatch();
}

} // namespace

namespace {

/// Five clicks, and the answers of the right program, or of one that forgets to flip y.
std::vector<WrongPoint> fiveClicks(bool isFlipped)
{
    std::vector<WrongPoint> points;
    for (int i = 0; i < 5; ++i) {
        WrongPoint point;
        point.pixel = DevicePoint(180.5 + 131.0 * i, 150.5 + 83.0 * i);
        point.depth = 0.8 + 0.03 * i;
        const glm::dvec3 got =
            oracleUnder(point.pixel.x, isFlipped ? 700.0 - point.pixel.y : point.pixel.y, *point.depth);
        point.got = {rounded(got.x, 4), rounded(got.y, 4), rounded(got.z, 4)};
        points.push_back(point);
    }
    return points;
}

} // namespace

class TestDoctor : public QObject {
    Q_OBJECT

private slots:
    void aMistakeIsNamed_data()
    {
        addColumn<QString>("id");
        addColumn<QList<double>>("got");
        const auto row = [](const char *name, const char *id, double x, double y, double z) {
            newRow(name) << QString(id) << QList<double>{x, y, z};
        };
        row("y not flipped", "y-not-flipped", 0.7051, -0.4122, 0.0918);
        row("row above", "row-above", 0.4986, 0.7577, -0.2523);
        row("pixel's corner", "pixel-corner", 0.4972, 0.7462, -0.2468);
        row("logical pixel, device height", "ratio-logical-in-device", -1.6654, 1.8035, 0.6279);
        row("logical pixel and height", "ratio-logical-both", -1.1911, -0.8846, 1.4185);
        row("device pixel, logical viewport", "ratio-device-in-logical", 3.8822, 4.0191, -3.5869);
        row("viewport's origin", "viewport-origin-ignored", 1.1420, 1.0572, -0.7581);
        row("viewport's height", "flipped-with-viewport-height", 0.6355, -0.0180, -0.0241);
        row("whole window", "viewport-is-window", 0.4326, 0.5902, -0.1456);
        row("integer aspect", "aspect-integer", 0.3805, 0.75, -0.1783);
        row("aspect 1.6 of another size", "aspect-stale", 0.5956, 0.75, -0.3074);
        row("degrees as radians", "fov-degrees-as-radians", 0.6255, 0.9781, -0.4165);
        row("half field of view", "fov-half", 0.3119, 0.4080, -0.0004);
        row("eye x and y mirrored", "eye-xy-mirrored", -0.2237, -0.5658, 0.7105);
        row("ortho formula", "ortho-formula", 0.1997, 0.2040, 0.1486);
        row("divided by far", "divided-by-far", 0.1418, 0.0987, 0.2255);
        row("linear angle", "linear-angle", 0.4654, 0.7185, -0.2166);
        row("x and y swapped", "xy-swapped", -0.6893, 1.8481, 0.0243);
        row("z_ndc = d", "depth-not-remapped", -1.7223, -0.3612, -4.9168);
        row("2d - 1 twice", "depth-remapped-twice", 1.7121, 1.3561, 2.2955);
        row("linear depth", "depth-linear", 2.5531, 1.7765, 4.0614);
        row("depth 0", "depth-zero", 2.5749, 1.7874, 4.1072);
        row("depth 1", "depth-one", -39.51, -19.26, -84.28);
        row("eye distance", "depth-is-eye-distance", 3.0882, 2.0441, 5.1852);
        row("reversed depth", "depth-reversed", 2.4939, 1.7469, 3.9371);
        row("near and far as depth range", "depth-range-is-planes", 2.5756, 1.7878, 4.1087);
        row("far times 10", "far-differs", 0.3839, 0.6920, -0.4937);
        row("z as ray length", "z-as-ray-length", 0.5282, 0.7641, -0.1907);
        row("ray length as z", "ray-length-as-z", 0.4714, 0.7357, -0.3100);
        row("no division", "no-w-divide", 0.0850, 0.1275, -0.0425);
        row("no view", "view-left-out", 0.5574, 0.6955, -5.8805);
        row("model left in", "model-left-in", -1.5, 0.75, 0.75);
        row("model left out", "model-left-out", 2.5, 0.75, -1.25);
        row("eye added", "eye-added", 3.5, 2.75, 4.75);
        row("view transposed", "view-transposed", -0.1383, -0.0869, 0.1686);
        row("projection transposed", "projection-transposed", 4.0449, 2.2838, 7.8147);
        row("both transposed", "both-transposed", -0.1580, -0.1100, 0.1491);
        row("product transposed", "product-transposed", -0.0545, 0.0108, -1.3291);
        row("inverses' order", "inverse-order", -0.8773, -0.4777, 0.4633);
        row("not inverted", "not-inverted", -0.0669, 0.0236, 0.6488);
        row("camera's matrix", "view-inverse-as-view", 3.5034, 2.2009, -10.4372);
        row("in place", "overwritten-in-place", 0.1684, 0.2526, 0.0006);
        row("eye z positive", "eye-z-positive", 6.2237, 4.5658, 9.2895);
    }

    void aMistakeIsNamed()
    {
        QFETCH(QString, id);
        QFETCH(QList<double>, got);
        const bool isCoarse = id == "depth-one"; // two decimals
        const Case of = scene();
        const Diagnosis diagnosis =
            diagnosed(of, pointAt(of, WorldPoint(kTruth), {got[0], got[1], got[2]}, isCoarse ? 2 : 4));
        QCOMPARE(QString::fromStdString(diagnosis.candidates.front().id), id);
        QCOMPARE(QString::fromStdString(diagnosis.verdict), id);
        QVERIFY(diagnosis.candidates.front().distance <= 0.6);
        QVERIFY(diagnosis.candidates.front().explains);
        QCOMPARE(diagnosis.candidates.front().digits, diagnosis.digitsGiven);
        QVERIFY(diagnosis.candidates.size() >= 5);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(diagnosis.candidates.front().point[axis] - got[axis]) < (isCoarse ? 0.6e-2 : 0.6e-4));
    }

    void theOracleAgreesOnPairs()
    {
        const Case of = scene();
        const WindowPoint window = windowFromWorld(of.setup, WorldPoint(kTruth)).value();
        const double x = window.x, y = window.y, d = window.z;
        const struct {
            const char *id;
            glm::dvec3 got;
        } rows[] = {
            {"y-not-flipped+depth-reversed", oracleUnder(x, 700 - y, 1 - d)},
            {"ratio-logical-in-device+depth-not-remapped", oracleUnder(x / 2, 700 - (700 - y) / 2, (1 + d) / 2)},
            {"ratio-logical-both+viewport-origin-ignored", oracleUnder(x / 2 + 100, y / 2 + 40, d)},
            {"pixel-corner+ratio-logical-in-device", oracleUnder(x / 2 - 0.5, 700 - (700 - y) / 2 - 0.5, d)},
            {"row-above+eye-added", oracleUnder(x, y + 1, d) + glm::dvec3(3, 2, 5)},
        };
        for (const auto &[id, got] : rows) {
            const Diagnosis diagnosis = diagnosed(of, pointAt(of, WorldPoint(kTruth), got));
            const Candidate *candidate = named(diagnosis, id);
            QVERIFY2(candidate, id);
            QVERIFY2(candidate->explains, id);
            QVERIFY2(candidate - diagnosis.candidates.data() < 3, id);
            QVERIFY2(diagnosis.verdict.find('+') != std::string::npos, id);
        }
    }

    void aRightPointIsRight_data()
    {
        addColumn<int>("decimals");
        for (const int decimals : {0, 1, 2, 4, 8})
            addRow("%d decimals", decimals) << decimals;
    }

    void aRightPointIsRight()
    {
        QFETCH(int, decimals);
        const Case of = scene();
        for (const glm::dvec3 &truth : {kTruth, glm::dvec3(0), glm::dvec3(1.23456789, -0.98765432, 0.11111111)}) {
            const Diagnosis diagnosis = diagnosed(of, pointAt(of, WorldPoint(truth), truth, decimals));
            QCOMPARE(diagnosis.verdict, std::string("right"));
            QCOMPARE(diagnosis.candidates.front().id, std::string("right"));
            QCOMPARE(diagnosis.candidates.front().digits, diagnosis.digitsGiven);
            QVERIFY(diagnosis.candidates.size() >= 5);
        }
    }

    void nothingExplainsRandomPoints()
    {
        const Case of = scene();
        oracle::Random random(12);
        int explained = 0;
        for (int i = 0; i < tests::rounds(100); ++i) {
            const glm::dvec3 got(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5));
            const Diagnosis diagnosis = diagnosed(of, pointAt(of, WorldPoint(kTruth), got));
            explained += diagnosis.verdict == "unknown" ? 0 : 1;
            QVERIFY(diagnosis.candidates.size() >= 5);
            QVERIFY(std::is_sorted(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                   [](const Candidate &a, const Candidate &b) { return a.distance < b.distance; }));
        }
        QVERIFY2(explained <= 1, qPrintable(QString::number(explained)));
    }

    /// Some mistake always explains a point of one digit, so an explanation means nothing.
    void fewDigitsAreNoVerdict()
    {
        const Case of = scene();
        const Diagnosis diagnosis = diagnosed(of, pointAt(of, WorldPoint(kTruth), {-1.2, 0.9, 1.4}, 0));
        QVERIFY(diagnosis.candidates.front().explains);
        QCOMPARE(diagnosis.verdict, std::string("unknown"));
        QVERIFY(diagnosis.chance > 0.2);
    }

    void theProjectedPointSortsMistakes()
    {
        const Case of = scene();
        const auto landing = [&](const glm::dvec3 &got) { return diagnosed(of, pointAt(of, WorldPoint(kTruth), got)); };
        QCOMPARE(landing(kTruth).wrong, ErrorKind::Right);
        QCOMPARE(landing({0.7051, -0.4122, 0.0918}).wrong, ErrorKind::Pixel);
        QCOMPARE(landing({2.4939, 1.7469, 3.9371}).wrong, ErrorKind::Depth);
        QCOMPARE(landing({-0.1383, -0.0869, 0.1686}).wrong, ErrorKind::Matrix);
        // y' = H - y
        const Diagnosis flipped = landing({0.7051, -0.4122, 0.0918});
        QVERIFY(std::abs(flipped.projected->x - 568.647) < 0.02);
        QVERIFY(std::abs(flipped.projected->y - 425.662) < 0.02);
        QVERIFY(std::abs(flipped.projected->z - 0.838331) < 1e-5);
    }

    void theNextClickTellsCandidatesApart()
    {
        // Close to the middle of the viewport a mirrored picture hardly differs.
        const Case of = scene();
        WrongPoint point = pointAt(of, WorldPoint(kTruth), kTruth, 1);
        point.pixel = DevicePoint(501, 359.5);
        const auto under = oracleUnder(499, 700 - 360.5, *point.depth);
        for (int axis = 0; axis < 3; ++axis)
            point.got[axis] = rounded(under[axis], 1);
        const Diagnosis diagnosis = diagnosed(of, point);
        QVERIFY(diagnosis.next);
        // It is in the viewport, at the centre of a pixel, and far from the middle.
        QCOMPARE(diagnosis.next->x - std::floor(diagnosis.next->x), 0.5);
        QCOMPARE(diagnosis.next->y - std::floor(diagnosis.next->y), 0.5);
        QVERIFY(diagnosis.next->x > 100 && diagnosis.next->x < 900);
        QVERIFY(diagnosis.next->y > 60 && diagnosis.next->y < 660);
        QVERIFY(std::hypot(diagnosis.next->x - 500, diagnosis.next->y - 360) > 150);
        QVERIFY(diagnosis.nextApart > 0.0);
    }

    /// One point to one decimal fits many mistakes; three points of one program fit one.
    void severalPointsSettleIt()
    {
        const Case of = scene();
        std::vector<WrongPoint> points;
        for (const glm::dvec3 &truth : {kTruth, glm::dvec3(-1, -0.5, 0.5), glm::dvec3(0.9, -1.1, 0.3)}) {
            const WindowPoint at = windowFromWorld(of.setup, WorldPoint(truth)).value();
            points.push_back(pointAt(of, WorldPoint(truth), oracleUnder(at.x, 700 - at.y, at.z), 1));
        }
        const Diagnosis settled = diagnose(of, points).value();
        QCOMPARE(settled.verdict, std::string("y-not-flipped"));
        // One point is of another program: no mistake explains all, and the point is named.
        points[1].got.x += 0.8;
        const Diagnosis ofOthers = diagnose(of, points).value();
        QCOMPARE(ofOthers.verdict, std::string("y-not-flipped"));
        QCOMPARE(ofOthers.except->point, std::size_t(1));
    }

    void aPointThatIsRepeatedCountsOnce()
    {
        const Case of = scene();
        const WrongPoint point = pointAt(of, WorldPoint(kTruth), {-1.2, 0.9, 1.4}, 1);
        const Diagnosis once = diagnosed(of, point);
        const Diagnosis often = diagnose(of, std::vector(5, point)).value();
        QCOMPARE(often.verdict, once.verdict);
        QCOMPARE(often.chance, once.chance);
        QCOMPARE(often.digitsGiven, once.digitsGiven);
    }

    void withoutADepthTheRayJudges()
    {
        const Case of = scene();
        const auto byRay = [&](const glm::dvec3 &got) {
            WrongPoint point = pointAt(of, WorldPoint(kTruth), got);
            point.depth.reset();
            return diagnosed(of, point);
        };
        const Diagnosis flipped = byRay({0.7051, -0.4122, 0.0918});
        QCOMPARE(flipped.candidates.front().id, std::string("y-not-flipped"));
        QCOMPARE(flipped.depthKnown, DepthKnown::ByRay);
        // Any depth on the ray is right as far as the ray can tell.
        QCOMPARE(byRay(kTruth).verdict, std::string("right"));
        QCOMPARE(byRay({0.3839, 0.6920, -0.4937}).verdict, std::string("right"));
        // A depth on one of the planes is wrong.
        QCOMPARE(byRay({2.5749, 1.7874, 4.1072}).verdict, std::string("depth-zero"));
        QCOMPARE(byRay({-39.5132, -19.2566, -84.2777}).verdict, std::string("depth-one"));
        // The eye's side of the near plane is no depth at all.
        const Diagnosis beyond = byRay({3.0882, 2.0441, 5.1852});
        QVERIFY(beyond.verdict != "right");
        QCOMPARE(beyond.wrong, ErrorKind::Depth);
    }

    void theMeshKnowsTheDepth()
    {
        Case of = scene();
        of.pointOnMesh = [](const DevicePoint &) { return std::optional(WorldPoint(kTruth)); };
        WrongPoint point = pointAt(of, WorldPoint(kTruth), {2.4939, 1.7469, 3.9371});
        point.depth.reset();
        const Diagnosis diagnosis = diagnosed(of, point);
        QCOMPARE(diagnosis.depthKnown, DepthKnown::FromMesh);
        QCOMPARE(diagnosis.verdict, std::string("depth-reversed"));
        QVERIFY(diagnosis.right == kTruth);
        // The background of the mesh reports no depth.
        of.pointOnMesh = [](const DevicePoint &) { return std::optional<WorldPoint>(); };
        QCOMPARE(diagnosed(of, point).depthKnown, DepthKnown::ByRay);
    }

    /// Worked out with 60 digits for the depth 0.8383 as it is given, in all three spaces. Points beside
    /// it, and any points, do not change it.
    void theRightPointIsThatOfTheDepth()
    {
        const Case of = scene();
        WrongPoint point = pointAt(of, WorldPoint(kTruth), kTruth);
        point.pixel = DevicePoint(390.725, 253.439);
        point.depth = 0.8383;
        point.depthLastDigit = 1e-4;
        const struct {
            PointSpace space;
            glm::dvec3 right;
        } rows[] = {
            {PointSpace::World, {-0.7663968487230713, 0.9106979590299927, 0.44684623479562785}},
            {PointSpace::Eye, {-0.887080367199543, 0.8650484649659166, -5.879482370372114}},
            {PointSpace::Object, {-2.7663968487230712, 0.9106979590299927, 1.446846234795628}},
        };
        oracle::Random random(17);
        for (const auto &[space, right] : rows) {
            point.space = space;
            for (int i = 0; i < tests::rounds(20); ++i) {
                const double size = i % 2 == 0 ? 0.01 : 3.0;
                for (int axis = 0; axis < 3; ++axis)
                    point.got[axis] = rounded(right[axis] + random.uniform(-size, size), 4);
                const Diagnosis diagnosis = diagnosed(of, point);
                QVERIFY(diagnosis.right);
                for (int axis = 0; axis < 3; ++axis)
                    QCOMPARE((*diagnosis.right)[axis], right[axis]);
            }
        }
        // A ray has no right point.
        point.depth.reset();
        QVERIFY(!diagnosed(of, point).right);
    }

    /// The steps of an object cancel; their product in doubles is wrong in the eleventh decimal.
    void theRightPointInAnObjectIsThatOfItsSteps()
    {
        using unproject::Extended;
        Case of = scene();
        of.models = {{"far", preciseWorldFromObject(
                                 {Translate{{1e6, 0, 0}}, Rotate{30.0, {0, 0, 1}}, Translate{{-1e6, 0.3, 0}}})}};
        WrongPoint point = pointAt(of, WorldPoint(kTruth), glm::dvec3(9.0));
        point.space = PointSpace::Object;
        const auto world = unproject::ExactUnprojection::of(of.setup)->at(point.pixel, *point.depth).value();
        const Extended half = 0.5, root = sqrt(Extended(3)) / 2, x = world[0] - 1e6, y = world[1];
        const std::array<Extended, 3> truth{root * x + half * y + 1e6, root * y - half * x - Extended(0.3), world[2]};
        const Diagnosis diagnosis = diagnosed(of, point);
        QVERIFY(diagnosis.right);
        for (int axis = 0; axis < 3; ++axis)
            QCOMPARE((*diagnosis.right)[axis], double(truth[std::size_t(axis)]));
    }

    /// A depth of three digits moves the point by hundredths.
    void aRoundedDepthIsAllowedFor()
    {
        const Case of = scene();
        WrongPoint point = pointAt(of, WorldPoint(kTruth), {0.7051, -0.4122, 0.0918});
        point.depth = 0.838;
        QVERIFY(diagnosed(of, point).candidates.front().id != "y-not-flipped");
        point.depthLastDigit = 1e-3;
        QCOMPARE(diagnosed(of, point).candidates.front().id, std::string("y-not-flipped"));
    }

    /// The window was 640 x 333 before: its viewport is still used, or its height.
    void anotherSizeIsTried()
    {
        Case of = scene();
        const WindowPoint window = windowFromWorld(of.setup, WorldPoint(kTruth)).value();
        const double yDown = 700 - window.y;
        // A viewport (0, 0, 640, 333) spreads NDC otherwise: the same NDC in the right one.
        const auto inRight = [](double x, double y) { return glm::dvec2(100 + x / 640 * 800, 40 + y / 333 * 600); };
        const glm::dvec2 withFlip = inRight(window.x, 333 - yDown);
        const WrongPoint both = pointAt(of, WorldPoint(kTruth), oracleUnder(withFlip.x, withFlip.y, window.z));
        const WrongPoint flip = pointAt(of, WorldPoint(kTruth), oracleUnder(window.x, 333 - yDown, window.z));
        QVERIFY(diagnosed(of, both).verdict != "viewport-stale");
        of.otherSize = Surface{640, 333, 1.0};
        QCOMPARE(diagnosed(of, both).verdict, std::string("viewport-stale"));
        QCOMPARE(diagnosed(of, flip).verdict, std::string("viewport-stale"));
        of.otherSize = Surface{0, 333, 1.0};
        QCOMPARE(diagnose(of, {&both, 1}).error().code, ErrorCode::EmptyFramebuffer);
    }

    void otherSpaces()
    {
        const Case of = scene();
        WrongPoint point = pointAt(of, WorldPoint(kTruth), {0.5574, 0.6955, -5.8805});
        point.space = PointSpace::Eye;
        QCOMPARE(diagnosed(of, point).verdict, std::string("right"));
        point.got = {-1.5, 0.75, 0.75};
        point.space = PointSpace::Object;
        QCOMPARE(diagnosed(of, point).verdict, std::string("right"));
        point.got = kTruth;
        QCOMPARE(diagnosed(of, point).verdict, std::string("model-left-out"));
    }

    void aMatrixIsAsGoodAsParameters()
    {
        Case of = scene();
        const Case byParameters = of;
        of.setup.lens = MatrixProjection{clipFromEye(of.setup).value(), {}};
        of.setup.pose = eyeFromWorld(byParameters.setup).value();
        for (const glm::dvec3 &got : {glm::dvec3(0.3119, 0.4080, -0.0004), glm::dvec3(0.3839, 0.6920, -0.4937),
                                      glm::dvec3(0.1997, 0.2040, 0.1486), glm::dvec3(2.5531, 1.7765, 4.0614)}) {
            const WrongPoint point = pointAt(byParameters, WorldPoint(kTruth), got);
            QCOMPARE(diagnosed(of, point).verdict, diagnosed(byParameters, point).verdict);
            QVERIFY(diagnosed(of, point).verdict != "unknown");
        }
    }

    void roundingIsNoMistake()
    {
        const Case of = scene();
        const auto unprojector = unproject::Unprojector::of(of.setup).value();
        for (int i = 0; i < tests::rounds(10); ++i) {
            WrongPoint point;
            point.pixel = DevicePoint(120.5 + 76.0 * i, 650.5 - 56.0 * i);
            point.depth = 0.3 + 0.0692 * i;
            const WindowPoint window = windowFromDevice(of.setup.surface, point.pixel, *point.depth);
            for (const unproject::Method method : unproject::kMethods) {
                point.got = unprojector.at(window).world[method].value().coordinates();
                point.lastDigit = glm::dvec3(1e-17); // all that is printed of a double
                QCOMPARE(QString::fromStdString(diagnosed(of, point).verdict), QStringLiteral("right"));
                QCOMPARE(diagnosed(of, point).isSinglePrecision, method == unproject::Method::MatrixInFloat);
            }
        }
    }

    void singlePrecisionIsNoMistake()
    {
        const Case of = scene();
        for (int i = 0; i < tests::rounds(10); ++i) {
            const double x = 120.5 + 76.0 * i, y = 650.5 - 56.0 * i, depth = 0.6 + 0.032 * i;
            WrongPoint point;
            point.pixel = DevicePoint(x, y);
            point.depth = depth;
            point.lastDigit = glm::dvec3(1e-9);
            const auto ask = [&](const glm::dvec3 &answered) {
                point.got = glm::dvec3(glm::vec3(answered));
                return diagnosed(of, point);
            };
            const Diagnosis right = ask(oracleUnder(x, 700.0 - y, depth)), flipped = ask(oracleUnder(x, y, depth));
            QCOMPARE(QString::fromStdString(right.verdict), QStringLiteral("right"));
            QVERIFY(right.isSinglePrecision);
            QCOMPARE(verdictSentence(right),
                     std::string("The point is right to the digits that single precision holds."));
            if (std::abs(y - 350.0) > 5.0)
                QCOMPARE(QString::fromStdString(flipped.verdict), QStringLiteral("y-not-flipped"));
        }
        // An arbitrary point gets no explanation.
        WrongPoint point = pointAt(of, WorldPoint(kTruth), {1.23456789, -2.3456789, 0.123456789}, 9);
        QCOMPARE(QString::fromStdString(diagnosed(of, point).verdict), QStringLiteral("unknown"));
    }

    void aPowerOfTenGivesNoDigits()
    {
        const Case of = scene();
        for (const glm::dvec3 &got : {glm::dvec3(0.5, 0.75, 1e9), glm::dvec3(1e300, 0.75, -0.25), glm::dvec3(1e3)}) {
            WrongPoint point = pointAt(of, WorldPoint(kTruth), kTruth);
            point.got = got;
            for (int axis = 0; axis < 3; ++axis) {
                if (got[axis] >= 1e3)
                    point.lastDigit[axis] = got[axis]; // "1e9" has one digit
            }
            QCOMPARE(QString::fromStdString(diagnosed(of, point).verdict), QStringLiteral("unknown"));
        }
    }

    /// A person writes the records: a key in a wrong spelling would be left out.
    void everyRecordHasTheKeysOfAMistake()
    {
        const nlohmann::json records = nlohmann::json::parse(base::resource("doctor/mistakes.json"));
        QCOMPARE(records.size(), mistakes().size());
        const std::set<std::string> known{"id",           "name", "sentence", "reports",
                                          "isOnlySolved", "code", "with",     "codeWith"};
        for (const nlohmann::json &record : records) {
            for (const auto &[key, value] : record.items())
                QVERIFY2(known.contains(key), key.c_str());
        }
    }

    void everyMistakeHasItsIdOnce()
    {
        std::vector<std::string> ids;
        for (const Mistake &mistake : mistakes()) {
            const std::string &id = mistake.id;
            ids.push_back(id);
            QVERIFY2(!id.empty() && !mistake.name.empty() && mistake.reports > 0, id.c_str());
            QVERIFY2(mistake.sentence.ends_with('.'), id.c_str());
            QVERIFY2(mistake.code.size() >= 3, id.c_str());
            QVERIFY2(mistake.with.empty() == mistake.codeWith.empty(), id.c_str());
            for (const std::vector<CodeChange> &code : {mistake.code, mistake.codeWith}) {
                for (const CodeChange &change : code)
                    QVERIFY2(!change.library.empty() && !change.wrong.empty() && !change.right.empty()
                                 && change.wrong != change.right,
                             id.c_str());
            }
        }
        QVERIFY(ids.size() >= 45);
        std::sort(ids.begin(), ids.end());
        QVERIFY(std::adjacent_find(ids.begin(), ids.end()) == ids.end());
        // Each can be made on some picture.
        Case of = scene();
        of.otherSize = Surface{640, 480, 1.0};
        std::vector<std::size_t> made;
        for (const bool isPerspective : {true, false}) {
            if (!isPerspective)
                of.setup.lens = Projection(Ortho{});
            of.setup.depthRange = {0.1, 0.9};
            for (const Variant &variant : variants(Given::of(of.setup, {0.1, 0.0, 0.0, 0.0, 0.0}).value(), of))
                made.push_back(variant.mistake);
        }
        std::string solving;
        for (const char *name : {"from_one", "from_several", "frames"}) {
            QFile source(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/core/doctor/solved_%1.cpp").arg(QLatin1String(name)));
            QVERIFY(source.open(QIODevice::ReadOnly));
            solving += source.readAll().toStdString();
        }
        for (std::size_t i = 0; i < mistakes().size(); ++i)
            QVERIFY2(mistakes()[i].isOnlySolved ? solving.find('"' + mistakes()[i].id + '"') != solving.npos
                                                : std::find(made.begin(), made.end(), i) != made.end(),
                     mistakes()[i].id.c_str());
    }

    void everyMistakeAndWayIsWordedInBothLanguages()
    {
        Case of = scene();
        of.otherSize = Surface{640, 480, 1.0};
        of.setup.depthRange = {0.1, 0.9};
        of.setup.viewport = Viewport{10.0, 20.0, 700.0, 500.0};
        std::vector<VariantName> ways;
        for (const bool isPerspective : {true, false}) {
            if (!isPerspective)
                of.setup.lens = Projection(Ortho{});
            for (const Variant &variant : variants(Given::of(of.setup).value(), of)) {
                if (!variant.name.isEmpty())
                    ways.push_back(variant.name);
            }
        }
        QVERIFY(ways.size() > 50);
        QCOMPARE(mistakeName("y-not-flipped+no-w-divide"), std::string("y not flipped + not divided by w"));
        QCOMPARE(waysText({{base::marked("ratio %1"), {"1.5"}}, {base::marked("x only")}}),
                 std::string("ratio 1.5; x only"));
        QCOMPARE(waysText({{nullptr, {"16:9"}}}), std::string("16:9"));

        base::setLanguage(base::Language::Chinese);
        for (const Mistake &mistake : mistakes()) {
            const std::string &id = mistake.id;
            QVERIFY2(mistakeName(id) != mistake.name && !hasEnglish(mistakeName(id)), id.c_str());
            QVERIFY2(mistakeSentence(id) != mistake.sentence && !hasEnglish(mistakeSentence(id)), id.c_str());
        }
        for (const VariantName &way : ways) {
            const std::string said = waysText({way});
            QVERIFY2(way.words == nullptr || (base::tr(way.words) != way.words && !hasEnglish(said)), said.c_str());
        }
        QCOMPARE(waysText({{base::marked("ratio %1"), {"1.5"}}, {base::marked("x only")}}),
                 std::string("像素比 1.5；只有 x"));
        base::setLanguage(base::Language::English);
    }

    void badInputIsRefused()
    {
        const Case of = scene();
        WrongPoint point = pointAt(of, WorldPoint(kTruth), kTruth);
        point.depth = 5.88;
        const Result<Diagnosis> outside = diagnose(of, {&point, 1});
        QVERIFY(!outside);
        QCOMPARE(outside.error().code, ErrorCode::DepthOutsideRange);
        QCOMPARE(outside.error().value, 5.88);
        point.depth = 0.5;
        point.got.y = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(diagnose(of, {&point, 1}).error().code, ErrorCode::NotFinite);
        Case empty = of;
        empty.setup.viewport.width = 0;
        QCOMPARE(diagnose(empty, {&point, 1}).error().code, ErrorCode::EmptyViewport);
    }

    void oneOfSeveralPointsIsTheException_data()
    {
        addColumn<int>("count");
        addColumn<int>("place");
        addColumn<bool>("isWrong");
        newRow("a typo") << 5 << 2 << true;
        newRow("a typo in the first") << 5 << 0 << true;
        newRow("a typo, three points") << 3 << 1 << true;
        newRow("a typo among right ones") << 5 << 3 << false;
    }

    void oneOfSeveralPointsIsTheException()
    {
        QFETCH(int, count);
        QFETCH(int, place);
        QFETCH(bool, isWrong);
        std::vector<WrongPoint> points = fiveClicks(!isWrong);
        points.resize(std::size_t(count));
        const std::string verdict = isWrong ? "y-not-flipped" : "right";
        QCOMPARE(diagnose(scene(), points).value().verdict, verdict);
        QVERIFY(!diagnose(scene(), points).value().except);
        points[std::size_t(place)].got.y += 1.0;
        points.insert(points.begin(), points.front()); // a repetition counts once, but keeps its number
        const Diagnosis diagnosis = diagnose(scene(), points).value();
        QCOMPARE(diagnosis.verdict, verdict);
        QVERIFY(diagnosis.except);
        QCOMPARE(diagnosis.except->point, std::size_t(place == 0 ? 0 : place + 1));
        QVERIFY(
            exceptSentence(diagnosis).find("but point " + std::to_string(diagnosis.except->point + 1) + ", at pixel")
            != std::string::npos);
    }

    void randomPointsHaveNoException()
    {
        oracle::Random random(31);
        for (int i = 0; i < tests::rounds(10); ++i) {
            std::vector<WrongPoint> points = fiveClicks(true);
            points.resize(3 + std::size_t(i % 3));
            for (WrongPoint &point : points)
                point.got = {rounded(random.uniform(-5, 5), 4), rounded(random.uniform(-5, 5), 4),
                             rounded(random.uniform(-5, 5), 4)};
            QCOMPARE(diagnose(scene(), points).value().verdict, std::string("unknown"));
        }
    }

    void twoAnswersToOneClickContradict()
    {
        std::vector<WrongPoint> points = fiveClicks(true);
        points.resize(2);
        points[1].pixel = points[0].pixel;
        points[1].depth = points[0].depth;
        const Diagnosis diagnosis = diagnose(scene(), points).value();
        QCOMPARE(diagnosis.verdict, std::string("unknown"));
        QVERIFY(verdictSentence(diagnosis).starts_with("Points 1 and 2 have the same pixel and depth"));
        points[1].pixel.x += 1.0;
        QVERIFY(!diagnose(scene(), points).value().contradiction);
    }

    void coordinatesOfAMapAreRoundedToFloats()
    {
        Case of = scene();
        const glm::dvec3 place(500000, 4500000, 100);
        of.setup.pose = LookAt{WorldPoint(place + glm::dvec3(3, 2, 5)), WorldPoint(place), {0, 1, 0}};
        for (const bool isWrong : {true, false}) {
            std::vector<WrongPoint> points = fiveClicks(!isWrong);
            for (WrongPoint &point : points) {
                point.got = glm::dvec3(glm::vec3(place + point.got));
                point.lastDigit = glm::dvec3(1e-4);
            }
            const Diagnosis diagnosis = diagnose(of, points).value();
            QCOMPARE(diagnosis.verdict, std::string(isWrong ? "y-not-flipped" : "right"));
            QVERIFY(diagnosis.isSinglePrecision);
        }
    }

    void fewDigitsAreNoKnownPoint()
    {
        Case of = scene();
        of.setup.pose = LookAt{WorldPoint(3.3, 2.2, 5.4), WorldPoint(0.4, 0.3, -0.2), {0, 1, 0}};
        WrongPoint point;
        point.pixel = DevicePoint(568.647, 274.338);
        point.depth = 0.838331;
        const auto ask = [&](const glm::dvec3 &got, double lastDigit) {
            point.got = got;
            point.lastDigit = glm::dvec3(lastDigit);
            return diagnosed(of, point);
        };
        QVERIFY(ask({1, 0, 0}, 1.0).known.empty()); // 1 is no rounding of 0.4
        const Diagnosis eye = ask({3, 2, 5}, 1.0);
        QCOMPARE(eye.verdict, std::string("unknown"));
        QCOMPARE(eye.known.size(), std::size_t(1));
        QVERIFY(verdictSentence(eye).starts_with("The point given may be the eye"));
        QCOMPARE(ask({3.30, 2.20, 5.40}, 0.01).verdict, std::string("known-point"));
    }

    void aBoxOfAnotherHeight()
    {
        Case of = scene();
        of.setup.lens = Projection(Ortho{-4, 4, -3, 3, 1, 100});
        Case half = of;
        half.setup.lens = Projection(Ortho{-2, 2, -1.5, 1.5, 1, 100});
        std::vector<WrongPoint> points = fiveClicks(true);
        const unproject::Unprojector program = unproject::Unprojector::of(half.setup).value();
        for (WrongPoint &point : points) {
            const WindowPoint window(point.pixel.x, 700.0 - point.pixel.y, *point.depth);
            const auto got = program.worldAt(unproject::Method::Matrix, window);
            QVERIFY(bool(got));
            for (int axis = 0; axis < 3; ++axis)
                point.got[axis] = rounded(got->coordinates()[axis], 4);
        }
        const Diagnosis diagnosis = diagnose(of, points).value();
        QCOMPARE(diagnosis.verdict, std::string("box-size-differs"));
        QCOMPARE(diagnosis.candidates.front().values.front().numbers, std::vector{3.0});
        QCOMPARE(candidateName(diagnosis.candidates.front()),
                 std::string("another box size (the box is 3 high, the scene's 6)"));
    }

    void coarseDigitsDoNotCount()
    {
        WrongPoint point = pointAt(scene(), WorldPoint(kTruth), kTruth);
        point.got = {1e12, -3e12, 2e12};
        point.lastDigit = glm::dvec3(1e12);
        const Diagnosis diagnosis = diagnosed(scene(), point);
        QCOMPARE(digitsText(diagnosis.candidates.front(), diagnosis),
                 std::string("none of the 3 digits given counts: each is coarser than the distance from the eye"));
    }
};

UNPROJECTOR_TEST(TestDoctor)
#include "test_doctor.moc"
