// Points that are one of the scene's, and mistakes that cannot be told apart. The programs' points
// are computed apart from this program, as in test_doctor, or by the oracle.
#include "tests/support/test.h"

#include "core/base/translation.h"
#include "core/doctor/diagnosis.h"
#include "core/doctor/known_points.h"
#include "core/doctor/report_text.h"
#include "core/geometry/transform.h"
#include "tests/core/doctor/doctor_oracle.h"
#include "tests/support/mesh_model.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace unprojector;
using namespace unprojector::doctor;
using namespace unprojector::geometry;

namespace {

using Kind = KnownPoint::Kind;

/// The scene of test_doctor: viewport (100, 40, 800, 600) in 1000 x 700; 45 degrees, near 1, far
/// 100. The eye is at (3, 2, 5); the box is moved by (2, 0, -1).
Case testScene()
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

/// A click on (0.5, 0.75, -0.25) in that scene.
WrongPoint wrongPoint(const glm::dvec3 &got, double lastDigit = 1e-4)
{
    WrongPoint point;
    point.pixel = DevicePoint(568.6475, 274.3378);
    point.depth = 0.838330516;
    point.got = got;
    point.lastDigit = glm::dvec3(lastDigit);
    return point;
}

Diagnosis diagnosed(const Case &of, const WrongPoint &point)
{
    return diagnose(of, {&point, 1}).value();
}

std::vector<Kind> kindsOf(const Diagnosis &diagnosis)
{
    std::vector<Kind> kinds;
    for (const KnownPoint &known : diagnosis.known)
        kinds.push_back(known.kind);
    return kinds;
}

glm::dvec3 inFourDecimals(const glm::dvec3 &p)
{
    return glm::dvec3(std::round(p.x * 1e4), std::round(p.y * 1e4), std::round(p.z * 1e4)) / 1e4;
}

/// A program's answer for the window position (y up) in the scene, to four decimals.
glm::dvec3 answerUnder(double x, double y, double depth)
{
    return inFourDecimals(doctor_oracle::oracleUnder(x, y, depth));
}

const Candidate *named(const Diagnosis &diagnosis, const std::string &id)
{
    const auto found = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                    [&](const Candidate &candidate) { return candidate.id == id; });
    return found == diagnosis.candidates.end() ? nullptr : &*found;
}

} // namespace

Q_DECLARE_METATYPE(std::vector<unprojector::doctor::KnownPoint::Kind>)

class TestDoctorVerdicts : public QObject {
    Q_OBJECT

private slots:
    void aPointOfTheSceneIsNamed_data()
    {
        addColumn<glm::dvec3>("got");
        addColumn<double>("lastDigit");
        addColumn<std::vector<Kind>>("kinds");
        const auto row = [](const char *name, const glm::dvec3 &got, double lastDigit, const std::vector<Kind> &kinds) {
            newRow(name) << got << lastDigit << kinds;
        };
        row("the eye, six decimals", {3, 2, 5}, 1e-6, {Kind::Eye});
        row("the eye, two decimals", {3, 2, 5}, 1e-2, {Kind::Eye});
        row("the eye, in whole numbers", {3, 2, 5}, 1.0, {Kind::Eye});
        row("the eye, in single precision", {3.0000002, 1.9999999, 5}, 1e-7, {Kind::Eye});
        row("the origin, at which the camera looks", {0, 0, 0}, 1e-4, {Kind::CameraCentre, Kind::WorldOrigin});
        row("the origin, as zeros alone", {0, 0, 0}, 1.0, {Kind::CameraCentre, Kind::WorldOrigin});
        row("the box", {2, 0, -1}, 1e-4, {Kind::ObjectOrigin});
        row("the view's last column", {0, 0, -6.1644}, 1e-4, {Kind::ViewTranslation});
    }

    void aPointOfTheSceneIsNamed()
    {
        QFETCH(glm::dvec3, got);
        QFETCH(double, lastDigit);
        QFETCH(std::vector<Kind>, kinds);
        const Diagnosis diagnosis = diagnosed(testScene(), wrongPoint(got, lastDigit));
        QCOMPARE(diagnosis.verdict, std::string("known-point"));
        QVERIFY(!diagnosis.namesMistake());
        QVERIFY(kindsOf(diagnosis) == kinds);
        QVERIFY(diagnosis.candidates.size() >= 5);
    }

    void itsDigitsMayBeCutOff()
    {
        Case scene = testScene();
        scene.setup.pose = LookAt{WorldPoint(3.12349, 2.98768, 5.55558), WorldPoint(0, 0, 0), {0, 1, 0}};
        QVERIFY(kindsOf(diagnosed(scene, wrongPoint({3.1234, 2.9876, 5.5555}))) == std::vector{Kind::Eye});
        QVERIFY(kindsOf(diagnosed(scene, wrongPoint({3.1235, 2.9877, 5.5556}))) == std::vector{Kind::Eye});
        // Away from zero, a digit is neither rounded nor cut off.
        QVERIFY(kindsOf(diagnosed(scene, wrongPoint({3.1236, 2.9877, 5.5556}))).empty());
    }

    /// Close to the eye a last digit spans the whole picture.
    void whereItLandsTellsNothing()
    {
        Case scene = testScene();
        scene.setup.pose = LookAt{WorldPoint(3.12349, 2.98768, 5.55558), WorldPoint(0, 0, 0), {0, 1, 0}};
        const Diagnosis eye = diagnosed(scene, wrongPoint({3.1235, 2.9877, 5.5556}));
        QVERIFY(eye.projected && !eye.tellsWrong());
        const Diagnosis flipped = diagnosed(testScene(), wrongPoint({0.7051, -0.4122, 0.0918}));
        QVERIFY(flipped.tellsWrong());
        const Diagnosis right = diagnosed(testScene(), wrongPoint({0.5, 0.75, -0.25}));
        QCOMPARE(right.verdict, std::string("right"));
        QVERIFY(right.tellsWrong());
    }

    void aPointBesideItIsNot()
    {
        QVERIFY(diagnosed(testScene(), wrongPoint({3.0002, 2, 5})).known.empty());
        // Any point might be the eye at this coarseness.
        QVERIFY(diagnosed(testScene(), wrongPoint({10, 0, 10}, 10.0)).known.empty());
    }

    void itIsTakenToTheSpaceOfThePoints()
    {
        WrongPoint inEye = wrongPoint({0, 0, 0});
        inEye.space = PointSpace::Eye;
        QVERIFY(kindsOf(diagnosed(testScene(), inEye)) == std::vector{Kind::Eye});
        WrongPoint inObject = wrongPoint({1, 2, 6});
        inObject.space = PointSpace::Object;
        QVERIFY(kindsOf(diagnosed(testScene(), inObject)) == std::vector{Kind::Eye});
    }

    void aRightPointStaysRight()
    {
        const Case of = testScene();
        WrongPoint point = wrongPoint({0, 0, 0});
        point.pixel = DevicePoint(500, 360);
        point.depth = windowFromWorld(of.setup, WorldPoint(0, 0, 0)).value().z;
        const Diagnosis diagnosis = diagnosed(of, point);
        QCOMPARE(diagnosis.verdict, std::string("right"));
        QVERIFY(diagnosis.known.empty());
    }

    /// The near plane is so close that a depth of 0 is the eye, as far as four decimals tell.
    void aMistakeThatExplainsAsWellIsNamed()
    {
        Case of = testScene();
        // The far plane is at infinity: with another one, too many mistakes come that close to the eye.
        glm::dmat4 clipFromEye = geometry::clipFromEye(of.setup).value();
        clipFromEye[2][2] = -1.0;
        clipFromEye[3][2] = -2e-6;
        of.setup.lens = MatrixProjection{clipFromEye, {}};
        WrongPoint point = wrongPoint({3, 2, 5});
        point.depth = windowFromWorld(of.setup, WorldPoint(0.5, 0.75, -0.25)).value().z;
        const Diagnosis diagnosis = diagnosed(of, point);
        QVERIFY2(diagnosis.namesMistake(), diagnosis.verdict.c_str());
        QVERIFY(kindsOf(diagnosis) == std::vector{Kind::Eye});
    }

    void allPointsHaveToBeIt()
    {
        std::vector<WrongPoint> points{wrongPoint({3, 2, 5}), wrongPoint({3, 2, 5})};
        points[1].pixel = DevicePoint(300.5, 500.5);
        QCOMPARE(diagnose(testScene(), points).value().verdict, std::string("known-point"));
        points[1].got = {1.2345, 2.3456, 3.4567};
        QCOMPARE(diagnose(testScene(), points).value().verdict, std::string("unknown"));
    }

    void aVertexHasToBeAlone()
    {
        const glm::dvec3 at(1.2345, -2.3456, 0.1234);
        Case of = testScene();
        std::vector<KnownPoint> vertices{{Kind::Vertex, at, "scan", 7}, {Kind::Vertex, at, "scan", 8}};
        Box asked;
        of.verticesIn = [&](const Box &world) {
            asked = world;
            return vertices;
        };
        const Diagnosis alone = diagnosed(of, wrongPoint(at));
        QCOMPARE(alone.verdict, std::string("known-point"));
        QCOMPARE(alone.known.size(), std::size_t(1));
        QCOMPARE(alone.known.front().vertex, std::size_t(7));
        QVERIFY(asked.diagonal() > 1e-4 && asked.diagonal() < 1e-2);
        // Every point on a dense mesh is a vertex in so few digits.
        vertices.push_back({Kind::Vertex, at + glm::dvec3(2e-4, 0, 0), "scan", 9});
        QCOMPARE(diagnosed(of, wrongPoint(at)).verdict, std::string("unknown"));
        vertices = {{Kind::Vertex, at + glm::dvec3(2e-4, 0, 0), "scan", 9}};
        QCOMPARE(diagnosed(of, wrongPoint(at)).verdict, std::string("unknown"));
    }

    void theVerticesInABoxAreFound()
    {
        mesh::Mesh mesh;
        mesh.origin = {1000, 0, 0};
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
        mesh.indices = {0, 1, 2, 1, 3, 2};
        const auto model = modelOf(mesh);
        model->meshes.push_back(mesh);
        const std::vector<scene::SceneObject> objects{{"hidden", {}, model, {}, true},
                                                      {"shown", {}, model, {Translate{{0, 0, 5}}}, false}};
        Box box;
        box.add(glm::dvec3(1000.9, 0.9, 4.9));
        box.add(glm::dvec3(1001.0, 1.0, 5.0));
        const std::vector<KnownPoint> found = verticesIn(objects, box);
        QCOMPARE(found.size(), std::size_t(1)); // the second mesh has the same place
        QCOMPARE(found[0].vertex, std::size_t(3));
        QCOMPARE(found[0].object, std::string("shown"));
        QCOMPARE(found[0].point, glm::dvec3(1001, 1, 5));
    }

    /// The middle row of the window, not flipped, is the row above.
    void whatComesToOneWindowPosition()
    {
        WrongPoint point = wrongPoint(answerUnder(300.5, 350.5, 0.83));
        point.pixel = DevicePoint(300.5, 350.5);
        point.depth = 0.83;
        const Diagnosis diagnosis = diagnosed(testScene(), point);
        QCOMPARE(diagnosis.verdict, std::string("y-not-flipped"));
        const Candidate *row = named(diagnosis, "row-above");
        QVERIFY(row);
        QCOMPARE(row->alike, Alike::Here);
        QVERIFY(row->shared == Shared::Window);
        // The suggested click tells them apart.
        QVERIFY(diagnosis.next && std::abs(diagnosis.next->y - 350.5) > 50.0);
    }

    void whatComesToOneProjection()
    {
        const Diagnosis diagnosis = diagnosed(testScene(), wrongPoint({0.3805, 0.75, -0.1783}));
        QCOMPARE(diagnosis.verdict, std::string("aspect-integer"));
        const Candidate *leftOut = named(diagnosis, "aspect-left-out");
        QVERIFY(leftOut);
        QCOMPARE(leftOut->alike, Alike::Always);
        QVERIFY(leftOut->shared == Shared::Projection);
    }

    void whatComesToOneMatrix()
    {
        const Diagnosis diagnosis = diagnosed(testScene(), wrongPoint({-0.0545, 0.0108, -1.3291}));
        QCOMPARE(diagnosis.verdict, std::string("product-transposed"));
        const Candidate *pair = named(diagnosis, "both-transposed+inverse-order");
        QVERIFY(pair);
        QCOMPARE(pair->alike, Alike::Always);
        QVERIFY(pair->shared == Shared::Matrix);
    }

    /// The transpose of a view that only turns is its inverse.
    void whatComesToOneView()
    {
        Case of = testScene();
        of.setup.pose = LookAt{WorldPoint(0, 0, 0), WorldPoint(-3, -2, -5), {0, 1, 0}};
        WrongPoint point = wrongPoint({0, 0, 0});
        const glm::dvec3 eye(0.5, 0.4, -4.0);
        const glm::dmat4 view = eyeFromWorld(of.setup).value();
        const glm::dvec3 right = glm::transpose(glm::dmat3(view)) * eye;
        const WindowPoint window = windowFromWorld(of.setup, WorldPoint(right)).value();
        point.pixel = deviceFromWindow(of.setup.surface, window);
        point.depth = window.z;
        point.got = inFourDecimals(glm::dmat3(view) * eye);
        const Diagnosis diagnosis = diagnosed(of, point);
        QVERIFY2(diagnosis.verdict == "view-transposed" || diagnosis.verdict == "view-inverse-as-view",
                 diagnosis.verdict.c_str());
        const Candidate *other =
            named(diagnosis, diagnosis.verdict == "view-transposed" ? "view-inverse-as-view" : "view-transposed");
        QVERIFY(other);
        QCOMPARE(other->alike, Alike::Always);
        QVERIFY(other->shared == Shared::View);
    }

    /// Transposing both and the projection once more transposes the view, and a reversed depth 0 is
    /// depth 1.
    void whatUndoesItselfIsNoOtherMistake()
    {
        for (const glm::dvec3 &got : {glm::dvec3(-0.1383, -0.0869, 0.1686), glm::dvec3(2.5749, 1.7874, 4.1072)}) {
            const Diagnosis diagnosis = diagnosed(testScene(), wrongPoint(got));
            QVERIFY(diagnosis.verdict == "view-transposed" || diagnosis.verdict == "depth-zero");
            QVERIFY(diagnosis.alike().empty());
            QVERIFY(!named(diagnosis, "projection-transposed+both-transposed"));
            QVERIFY(!named(diagnosis, "depth-one+depth-reversed"));
        }
    }

    /// The near plane is at 1/1000: depth 0 and a reversed depth differ in the seventh decimal.
    void whatFewDigitsLeaveAlikeIsSaid()
    {
        Case of = testScene();
        of.setup.lens = Projection(Perspective{std::numbers::pi / 4, 800.0 / 600.0, 1e-3, 100});
        const glm::dvec3 eye(3, 2, 5), truth(0.5, 0.75, -0.25);
        constexpr double kDistance = 5.8805;
        WrongPoint point = wrongPoint(inFourDecimals(10.0 * (eye + 1e-3 / kDistance * (truth - eye))) / 10.0, 1e-5);
        point.depth = windowFromWorld(of.setup, WorldPoint(truth)).value().z;
        const Diagnosis diagnosis = diagnosed(of, point);
        QCOMPARE(diagnosis.verdict, std::string("depth-zero"));
        const Candidate *reversed = named(diagnosis, "depth-reversed");
        QVERIFY(reversed);
        QCOMPARE(reversed->alike, Alike::InDigits);
        QVERIFY(!reversed->shared);
        QCOMPARE(alikeSentence(*reversed),
                 std::string("These digits cannot separate them: give more digits, or another click."));
    }

    /// Two mistakes with the same result cast no doubt on either.
    void theRayTellsWhatGivesTheSame()
    {
        WrongPoint point = wrongPoint(answerUnder(300.5, 350.5, 0.83));
        point.pixel = DevicePoint(300.5, 350.5);
        point.depth.reset();
        const Diagnosis diagnosis = diagnosed(testScene(), point);
        QCOMPARE(diagnosis.verdict, std::string("y-not-flipped"));
        QVERIFY(named(diagnosis, "row-above"));
        QCOMPARE(named(diagnosis, "row-above")->alike, Alike::Here);
    }

    void theFirstThatCanBeToldIsTheRunnerUp()
    {
        const Diagnosis diagnosis = diagnosed(testScene(), wrongPoint({0.3805, 0.75, -0.1783}));
        const std::vector<Candidate> alike = diagnosis.alike();
        QVERIFY(!alike.empty());
        QCOMPARE(alike.front().id, std::string("aspect-left-out"));
        const Candidate *next = diagnosis.runnerUp();
        QVERIFY(next);
        QCOMPARE(next->alike, Alike::No);
        // An unambiguous mistake has the second of the list.
        const Diagnosis flipped = diagnosed(testScene(), wrongPoint({0.7051, -0.4122, 0.0918}));
        QVERIFY(flipped.alike().empty());
        QCOMPARE(flipped.runnerUp(), &flipped.candidates[1]);
    }

    void digitsAreSaidAsTheyCount()
    {
        Candidate candidate;
        Diagnosis diagnosis;
        candidate.digits = diagnosis.digitsGiven = 9;
        diagnosis.digitsWritten = 12;
        QCOMPARE(digitsText(candidate, diagnosis), std::string("all 9 digits that count of the 12 given"));
        candidate.digits = 7;
        QCOMPARE(digitsText(candidate, diagnosis), std::string("7 of the 9 digits that count of the 12 given"));
        candidate.digits = diagnosis.digitsWritten = 9;
        candidate.isCutOff = true;
        QCOMPARE(digitsText(candidate, diagnosis), std::string("all 9 digits given, the last not rounded but cut off"));
    }

    /// A transposed view from the origin is its inverse: the second of two such candidates is no other
    /// answer.
    void whatAnswersTheSameIsNoRunnerUp()
    {
        Case scene = testScene();
        scene.setup.pose = LookAt{WorldPoint(0, 0, 0), WorldPoint(1, -2, -3), {0, 1, 0}};
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> anywhere(-4.0, 4.0);
        int count = 0;
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 got = inFourDecimals({anywhere(engine), anywhere(engine), anywhere(engine)});
            const Diagnosis diagnosis = diagnosed(scene, wrongPoint(got));
            if (diagnosis.verdict != "unknown")
                continue;
            ++count;
            const Candidate *next = diagnosis.runnerUp();
            QVERIFY(next);
            QVERIFY(glm::distance(next->point, diagnosis.candidates.front().point) > 1e-9);
            for (const Candidate &candidate : diagnosis.candidates) {
                const auto &digits = candidate.digitsOfFirst;
                QCOMPARE(digits[0] + digits[1] + digits[2], candidate.digits);
            }
        }
        QVERIFY(count > 10);
    }

    void theyAreWordedInBothLanguages()
    {
        const std::vector<KnownPoint> two{{Kind::CameraCentre, glm::dvec3(0.0), {}, 0},
                                          {Kind::Vertex, glm::dvec3(0.0), "cube", 5}};
        QCOMPARE(knownPointName(two), std::string("the camera's centre and vertex 5 of \"cube\""));
        QVERIFY(knownPointSentence(two).starts_with(
            "The point given is the camera's centre and vertex 5 of \"cube\". Usually"));
        Candidate candidate;
        candidate.alike = Alike::Always;
        for (const Shared shared : {Shared::Window, Shared::Depth, Shared::Projection, Shared::View, Shared::Ndc,
                                    Shared::Matrix, Shared::Point}) {
            candidate.shared = shared;
            const std::string english = alikeSentence(candidate);
            QVERIFY(english.find("cannot be separated") != std::string::npos);
            base::setLanguage(base::Language::Chinese);
            const std::string chinese = alikeSentence(candidate);
            base::setLanguage(base::Language::English);
            QVERIFY2(chinese != english && chinese.find("told") == std::string::npos, chinese.c_str());
        }
        for (const Kind kind : {Kind::Eye, Kind::ViewTranslation, Kind::CameraCentre, Kind::WorldOrigin,
                                Kind::ObjectOrigin, Kind::Vertex}) {
            const std::vector<KnownPoint> one{{kind, glm::dvec3(0.0), "cube", 5}};
            base::setLanguage(base::Language::Chinese);
            const std::string chinese = knownPointSentence(one);
            base::setLanguage(base::Language::English);
            QVERIFY2(chinese.find("the ") == std::string::npos && chinese.find("Usually") == std::string::npos,
                     chinese.c_str());
        }
    }
};

UNPROJECTOR_TEST(TestDoctorVerdicts)
#include "test_doctor_verdicts.moc"
