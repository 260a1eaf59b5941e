// Values that are solved from wrong points. The programs with these values share no line with core.

#include "tests/support/test.h"

#include "core/base/translation.h"
#include "core/doctor/diagnosis.h"
#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "core/doctor/written_value.h"
#include "tests/core/doctor/doctor_lines.h"
#include "tests/support/doctor_bar.h"
#include "tests/support/wrong_values.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace unprojector;
using namespace unprojector::doctor;
using wrong_programs::WrongValue;

namespace {

constexpr double kFourDecimals = 1e-4;

/// A window of 814 x 723 pixels, 45 degrees, near 0.1, far 100.
doctor_bar::Shot testShot(const glm::dvec3 &world = {0.5, 0.75, -0.25})
{
    doctor_bar::Shot shot;
    wrong_programs::Scene &scene = shot.scene;
    scene.framebufferWidth = 814.0;
    scene.framebufferHeight = 723.0;
    scene.viewport = {0.0, 0.0, 814.0, 723.0};
    scene.eye = {3.0, 2.0, 5.0};
    scene.target = {0.0, 0.0, 0.0};
    scene.up = {0.0, 1.0, 0.0};
    scene.lens.isPerspective = true;
    scene.lens.fovyRadians = std::numbers::pi / 4.0;
    scene.lens.aspect = 814.0 / 723.0;
    scene.lens.nearDistance = 0.1;
    scene.lens.farDistance = 100.0;
    shot.click = clickOn(scene, world);
    return shot;
}

glm::dvec3 rounded(const glm::dvec3 &p, double step)
{
    return glm::dvec3(std::round(p.x / step), std::round(p.y / step), std::round(p.z / step)) * step;
}

WrongPoint pointOf(const doctor_bar::Shot &shot, const glm::dvec3 &got, double step = kFourDecimals)
{
    WrongPoint point;
    point.pixel = geometry::DevicePoint(shot.click.px, shot.click.py);
    point.depth = shot.click.depth;
    point.got = rounded(got, step);
    point.lastDigit = glm::dvec3(step);
    return point;
}

WrongPoint pointOf(const doctor_bar::Shot &shot, const WrongValue &wrong, double step = kFourDecimals)
{
    return pointOf(shot, printed(shot.scene, shot.click, wrong).value(), step);
}

Diagnosis diagnosed(const doctor_bar::Shot &shot, const WrongPoint &point)
{
    return diagnose(doctor_bar::caseOf(shot), {&point, 1}).value();
}

const Candidate *named(const Diagnosis &diagnosis, const std::string &id)
{
    const auto found = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                    [&](const Candidate &candidate) { return candidate.id == id; });
    return found == diagnosis.candidates.end() ? nullptr : &*found;
}

} // namespace

class TestDoctorSolved : public QObject {
    Q_OBJECT

private slots:
    void aRoundValueIsTheVerdict_data()
    {
        addColumn<QString>("id");
        addColumn<QStringList>("names");
        addColumn<QList<double>>("numbers");
        addColumn<QString>("word");
        addColumn<QString>("name");
        const auto row = [](const char *title, const char *id, const QStringList &names, const QList<double> &numbers,
                            const char *word, const char *name) {
            newRow(title) << QString(id) << names << numbers << QString(word) << QString(name);
        };
        row("far", "far-differs", {"far"}, {50}, "", "another far plane (far is 50, the scene has 100)");
        row("near", "near-differs", {"near"}, {0.25}, "", "another near plane (near is 0.25, the scene has 0.1)");
        row("field of view", "fovy-differs", {"fovy"}, {60}, "",
            "another field of view (fovy is 60 degrees, the scene has 45)");
        row("any field of view", "fovy-differs", {"fovy"}, {53.13}, "",
            "another field of view (fovy is 53.13 degrees, the scene has 45)");
        row("title bar", "pixel-shifted", {"dx", "dy"}, {8, 31}, "", "pixel shifted (8 to the right, 31 down)");
        row("viewport", "viewport-size-differs", {"width", "height"}, {800, 600}, "",
            "another viewport size (800 x 600 pixels)");
        row("ratio", "ratio-differs", {"ratio"}, {1.1}, "",
            "another pixel ratio (ratio 1.1, logical pixels in a device viewport)");
        row("millimetres", "scaled", {"factor"}, {1000}, "origin", "result scaled (by 1000 from the origin)");
        row("letterboxed", "pixel-scaled-and-moved", {"scale", "dx", "dy"}, {1.5, 200, 0}, "",
            "pixel scaled and moved (scaled by 1.5 and moved by (200, 0))");
        row("fitted", "pixel-scaled-and-moved", {"scale", "dx", "dy"}, {0.75, 0, 60}, "",
            "pixel scaled and moved (scaled by 0.75 and moved by (0, 60))");
        row("any unit", "scaled", {"factor"}, {0.7}, "origin", "result scaled (by 0.7 from the origin)");
        row("inches of depth", "scaled", {"factor"}, {25.4}, "eye", "result scaled (by 25.4 from the eye)");
    }

    void aRoundValueIsTheVerdict()
    {
        QFETCH(QString, id);
        QFETCH(QStringList, names);
        QFETCH(QList<double>, numbers);
        QFETCH(QString, word);
        QFETCH(QString, name);
        WrongValue wrong{id.toStdString(), {}, word.toStdString(), 0};
        for (int i = 0; i < names.size(); ++i)
            wrong.values[names[i].toStdString()] = {numbers[i]};
        const doctor_bar::Shot shot = testShot();
        const Diagnosis diagnosis = diagnosed(shot, pointOf(shot, wrong));
        const Candidate &first = diagnosis.candidates.front();
        QCOMPARE(QString::fromStdString(diagnosis.verdict), id);
        QCOMPARE(QString::fromStdString(candidateName(first)), name);
        QVERIFY(first.explains);
        for (int i = 0; i < names.size(); ++i) {
            const auto value = std::find_if(first.values.begin(), first.values.end(), [&](const SolvedValue &each) {
                return each.name == names[i].toStdString();
            });
            QVERIFY(value != first.values.end());
            QVERIFY(std::abs(value->numbers.front() - numbers[i]) <= 1e-3 * std::abs(numbers[i]));
        }
    }

    void everyValueStandsInItsLines_data()
    {
        addColumn<WrongValue>("wrong");
        addColumn<int>("points");
        addColumn<int>("values");
        const auto row = [](const char *title, const WrongValue &wrong, int points, int values) {
            newRow(title) << wrong << points << values;
        };
        row("far", {"far-differs", {{"far", {50}}}, "", 0}, 1, 1);
        row("near", {"near-differs", {{"near", {0.25}}}, "", 0}, 1, 1);
        row("near and far", {"near-far-differ", {{"near", {0.25}}, {"far", {60}}}, "", 0}, 2, 2);
        row("field of view", {"fovy-differs", {{"fovy", {53.13}}}, "", 0}, 1, 1);
        row("shift", {"pixel-shifted", {{"dx", {8}}, {"dy", {31}}}, "", 0}, 1, 2);
        row("letterbox", {"pixel-scaled-and-moved", {{"scale", {1.5}}, {"dx", {200}}, {"dy", {0}}}, "", 0}, 1, 3);
        row("its height flips y", {"pixel-scaled-and-moved", {{"scale", {1.5}}, {"dx", {0}}, {"dy", {50}}}, "", 1}, 1,
            4);
        row("scaled and moved", {"pixel-scaled-and-moved", {{"scale", {0.75}}, {"dx", {13}}, {"dy", {-37}}}, "", 0}, 2,
            3);
        row("viewport", {"viewport-size-differs", {{"width", {1000}}, {"height", {768}}}, "", 0}, 1, 2);
        row("ratio", {"ratio-differs", {{"ratio", {1.1}}}, "", 0}, 1, 2);
        row("ratio below 1", {"ratio-differs", {{"ratio", {0.625}}}, "", 0}, 1, 2);
        row("from the origin", {"scaled", {{"factor", {0.7}}}, "origin", 0}, 1, 2);
        row("from the eye", {"scaled", {{"factor", {25.4}}}, "eye", 0}, 1, 2);
        row("frame",
            {"frame-differs",
             {{"rotation", {0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1}}, {"scale", {2.5}}, {"translation", {4, -1, 2}}},
             "",
             0},
            4, 3);
        row("axes", {"axes-differ", {}, "z,-x,-y", 0}, 1, 1);
    }

    void everyValueStandsInItsLines()
    {
        QFETCH(WrongValue, wrong);
        QFETCH(int, points);
        QFETCH(int, values);
        const std::array shots{testShot(), testShot({-1.0, -0.5, -3.0}), testShot({0.25, -0.75, 1.0}),
                               testShot({-0.5, 0.5, 0.75})};
        std::vector<WrongPoint> given;
        for (std::size_t i = 0; i < std::size_t(points); ++i)
            given.push_back(pointOf(shots[i], wrong));
        const Diagnosis diagnosis = diagnose(doctor_bar::caseOf(shots[0]), given).value();
        const Candidate *candidate = named(diagnosis, wrong.id);
        QVERIFY(candidate && int(candidate->values.size()) == values);
        QCOMPARE(doctor_lines::faultsOf(diagnosis), QString());
    }

    /// A program whose pixels are too large must not multiply them once more.
    void theLinesOfARatioFollowItsDirection_data()
    {
        addColumn<double>("ratio");
        addColumn<int>("variant");
        addColumn<QString>("as");
        newRow("logical pixels") << 1.6 << 0 << "ratio-logical-in-device";
        newRow("logical pixels and flip") << 1.6 << 1 << "ratio-logical-both";
        newRow("logical viewport, logical flip") << 1.0 / 1.6 << 0 << "ratio-device-in-logical";
        newRow("logical viewport") << 1.0 / 1.6 << 1 << "ratio-device-in-logical";
    }

    void theLinesOfARatioFollowItsDirection()
    {
        QFETCH(double, ratio);
        QFETCH(int, variant);
        QFETCH(QString, as);
        const doctor_bar::Shot shot = testShot();
        const Diagnosis diagnosis =
            diagnosed(shot, pointOf(shot, {"ratio-differs", {{"ratio", {ratio}}}, "", variant}));
        const Candidate &first = diagnosis.candidates.front();
        QCOMPARE(first.id, std::string("ratio-differs"));
        QVERIFY2(candidateName(first).find("ratio 1.6,") != std::string::npos, candidateName(first).c_str());
        QVERIFY(codeOf(first.id, first.values) == codeOf(as.toStdString(), first.values));
        const QString lines = doctor_lines::linesOf(first, "GLU");
        QCOMPARE(lines.contains(QStringLiteral("* 1.6")) || lines.contains(QStringLiteral("*= 1.6")),
                 as != QStringLiteral("ratio-device-in-logical"));
        QVERIFY(lines.contains(QStringLiteral("1.6")));
        QCOMPARE(codeOf("ratio-device-in-logical", {}).front().right,
                 std::string("glfwGetFramebufferSize(window, &w, &h); // ratio times as large"));
    }

    void axesAreNoValueThatWouldExplain()
    {
        Candidate candidate;
        candidate.id = "axes-differ";
        candidate.explains = true;
        candidate.alike = Alike::InDigits;
        candidate.values = {{"axes", {}, "x,-z,y"}};
        Diagnosis diagnosis;
        diagnosis.verdict = "unknown";
        diagnosis.candidates = {candidate};
        QVERIFY(!verdictSentence(diagnosis).starts_with("A value would"));
        QVERIFY(!alikeSentence(candidate).starts_with("Both have a value"));
        candidate.values.push_back({"scale", {2.0}, {}});
        diagnosis.candidates = {candidate};
        QVERIFY(verdictSentence(diagnosis).starts_with("A value would"));
        QVERIFY(alikeSentence(candidate).starts_with("Both have a value"));
    }

    /// The tenth of near is a mistake of fixed form, which has its value too.
    void aFixedFactorHasItsValue()
    {
        const doctor_bar::Shot shot = testShot();
        const Diagnosis diagnosis = diagnosed(shot, pointOf(shot, {"near-differs", {{"near", {0.01}}}, "", 0}));
        QCOMPARE(diagnosis.verdict, std::string("near-differs"));
        const std::vector<SolvedValue> &values = diagnosis.candidates.front().values;
        QCOMPARE(values.size(), std::size_t(1));
        QCOMPARE(values.front().name, std::string("near"));
        QCOMPARE(values.front().numbers, std::vector<double>{0.01});
    }

    void onePointLeavesSeveralValues()
    {
        const doctor_bar::Shot shot = testShot();
        const Diagnosis diagnosis = diagnosed(shot, pointOf(shot, {"far-differs", {{"far", {37.8312}}}, "", 0}));
        QCOMPARE(diagnosis.verdict, std::string("unknown"));
        for (const char *id : {"far-differs", "near-differs", "scaled"}) {
            const Candidate *candidate = named(diagnosis, id);
            QVERIFY2(candidate && candidate->explains && !candidate->values.empty(), id);
        }
        const double solved = named(diagnosis, "far-differs")->values.front().numbers.front();
        QVERIFY(std::abs(solved - 37.8312) < 0.01);
        const std::string sentence = verdictSentence(diagnosis);
        QVERIFY2(sentence.starts_with("A value would explain the point: another "), sentence.c_str());
        QVERIFY2(sentence.ends_with(". Another wrong point at another depth separates them."), sentence.c_str());
        QVERIFY2(sentence.find("far is 37.83") != std::string::npos, sentence.c_str());
    }

    /// A far plane of any number in front of the click, and a near plane behind it. A round one may be.
    void aPlaneThatHidesThePointIsNoCandidate()
    {
        const doctor_bar::Shot shot = testShot();
        const auto hasCandidate = [&](const WrongValue &wrong) {
            return named(diagnosed(shot, pointOf(shot, wrong)), wrong.id) != nullptr;
        };
        QVERIFY(!hasCandidate({"far-differs", {{"far", {1.73205}}}, "", 0}));
        QVERIFY(!hasCandidate({"near-differs", {{"near", {7.38906}}}, "", 0}));
        QVERIFY(hasCandidate({"far-differs", {{"far", {5}}}, "", 0}));
    }

    void aSecondDepthDecides()
    {
        const WrongValue wrong{"far-differs", {{"far", {37.8312}}}, "", 0};
        const doctor_bar::Shot first = testShot(), second = testShot({-1.0, -0.5, -3.0});
        const std::array points{pointOf(first, wrong), pointOf(second, wrong)};
        const Diagnosis diagnosis = diagnose(doctor_bar::caseOf(first), points).value();
        QCOMPARE(diagnosis.verdict, std::string("far-differs"));
        QVERIFY(std::abs(diagnosis.candidates.front().values.front().numbers.front() - 37.8312) < 0.01);
    }

    /// With two decimals far is 50 to 2 %: any number is as round as that.
    void fewDigitsMakeNoValueCertain()
    {
        const doctor_bar::Shot shot = testShot();
        const Diagnosis diagnosis = diagnosed(shot, pointOf(shot, {"far-differs", {{"far", {50.0}}}, "", 0}, 1e-2));
        QCOMPARE(diagnosis.verdict, std::string("unknown"));
        QVERIFY(named(diagnosis, "far-differs"));
    }

    /// Any point on the ray has a far plane, a near plane and a scale that explain it.
    void pointsOnTheRayAreRarelyNamed()
    {
        const doctor_bar::Shot shot = testShot();
        const glm::dvec3 eye = shot.scene.eye, truth(0.5, 0.75, -0.25);
        oracle::Random random(31);
        int verdicts = 0;
        constexpr int kPoints = tests::rounds(60);
        for (int i = 0; i < kPoints; ++i) {
            const glm::dvec3 got = eye + random.uniform(0.3, 3.0) * (truth - eye);
            verdicts += diagnosed(shot, pointOf(shot, got)).verdict == "unknown" ? 0 : 1;
        }
        QVERIFY2(verdicts <= kPoints / 10, std::to_string(verdicts).c_str());
    }

    void aValueIsWrittenAsPeopleWriteIt_data()
    {
        addColumn<double>("value");
        addColumn<double>("unsure");
        addColumn<double>("expected");
        addColumn<bool>("isRound");
        newRow("50") << 49.998 << 0.0035 << 50.0 << true;
        newRow("0.1") << 0.10002 << 0.00004 << 0.1 << true;
        newRow("power of ten from below") << 0.009999 << 0.00002 << 0.01 << true;
        newRow("1.5") << 1.4997 << 0.0006 << 1.5 << true;
        newRow("1366") << 1365.99 << 0.02 << 1366.0 << true;
        newRow("25.4, a unit") << 25.3999 << 0.0002 << 25.4 << true;
        newRow("negative") << -31.004 << 0.01 << -31.0 << true;
        newRow("not round") << 37.8312 << 0.0035 << 37.83 << false;
        newRow("too unsure") << 49.1 << 1.2 << 50.0 << false;
    }

    void aValueIsWrittenAsPeopleWriteIt()
    {
        QFETCH(double, value);
        QFETCH(double, unsure);
        QFETCH(double, expected);
        QFETCH(bool, isRound);
        constexpr std::array kUnits{25.4, 0.3048};
        const WrittenValue written = doctor::written({value, unsure}, kUnits);
        QCOMPARE(written.value, expected);
        QCOMPARE(written.coincidence <= kRoundByChance, isRound);
        QVERIFY(std::abs(written.value - value) <= unsure);
    }

    /// A width that is right is no evidence that the height was typed in.
    void theScenesValueIsNoEvidence()
    {
        const WrittenValue written = doctor::written({1024.003, 0.02, 1024.0});
        QCOMPARE(written.value, 1024.0);
        QCOMPARE(written.coincidence, 1.0);
    }

    void twoPointsGiveRoundPlanes_data()
    {
        addColumn<double>("nearPlane");
        addColumn<double>("farPlane");
        newRow("0.5, 60") << 0.5 << 60.0;
        newRow("0.1, 50") << 0.1 << 50.0;
    }

    /// The bounds of near and far belong together: each alone leaves other round numbers.
    void twoPointsGiveRoundPlanes()
    {
        QFETCH(double, nearPlane);
        QFETCH(double, farPlane);
        const WrongValue wrong{"near-far-differ", {{"near", {nearPlane}}, {"far", {farPlane}}}, "", 0};
        oracle::Random random(41);
        int named = 0;
        constexpr int kRuns = tests::rounds(30);
        for (int i = 0; i < kRuns; ++i) {
            const auto shot = [&](double low, double high) {
                const double s = random.uniform(low, high);
                doctor_bar::Shot one = testShot();
                one.scene.lens.nearDistance = 1.0;
                one.click = clickOn(one.scene, {s + random.uniform(-1.0, 1.0), s + random.uniform(-1.0, 1.0), s});
                return one;
            };
            const doctor_bar::Shot front = shot(0.0, 1.0), back = shot(-4.0, -1.0);
            const std::array points{pointOf(front, wrong), pointOf(back, wrong)};
            const Diagnosis diagnosis = diagnose(doctor_bar::caseOf(front), points).value();
            const std::vector<SolvedValue> &values = diagnosis.candidates.front().values;
            named += diagnosis.verdict == "near-far-differ" && values[0].numbers.front() == nearPlane
                             && values[1].numbers.front() == farPlane
                         ? 1
                         : 0;
        }
        QVERIFY2(10 * named >= 9 * kRuns, std::to_string(named).c_str());
    }

    void onlyDeterminedDigitsAreWritten()
    {
        const WrongValue wrong{"near-far-differ", {{"near", {0.4618394}}, {"far", {63.71294}}}, "", 0};
        std::vector<WrongPoint> points;
        doctor_bar::Shot shot = testShot();
        shot.scene.lens.nearDistance = 1.0;
        for (const glm::dvec3 &world : {glm::dvec3(0.5, 0.75, -0.25), {-1.0, -0.5, -3.0}, {0.25, -0.75, 1.0}}) {
            shot.click = clickOn(shot.scene, world);
            points.push_back(pointOf(shot, wrong));
        }
        const Diagnosis diagnosis = diagnose(doctor_bar::caseOf(shot), points).value();
        const Candidate *candidate = named(diagnosis, "near-far-differ");
        QVERIFY(candidate);
        for (const SolvedValue &value : candidate->values) {
            const double shown = value.numbers.front();
            QVERIFY2(std::abs(shown * 1e5 - std::round(shown * 1e5)) < 1e-6, valueText(shown).c_str());
        }
    }

    void aRoundUnitShowsInFewDigits()
    {
        const WrongValue wrong{"scaled", {{"factor", {0.001}}}, "origin", 0};
        oracle::Random random(42);
        for (int i = 0; i < tests::rounds(20); ++i) {
            const doctor_bar::Shot shot =
                testShot({random.uniform(1.0, 2.0), random.uniform(0.2, 1.0), random.uniform(-1.0, 1.0)});
            const Diagnosis diagnosis = diagnosed(shot, pointOf(shot, wrong));
            const Candidate *candidate = named(diagnosis, "scaled");
            QVERIFY(candidate);
            QCOMPARE(candidate->values.front().numbers.front(), 0.001);
            if (candidate == &diagnosis.candidates.front())
                QVERIFY(diagnosis.chance > 1e-5); // a handful of digits
        }
    }

    void bothPlanesByOneFactorCannotBeToldApart()
    {
        const WrongValue wrong{"near-far-differ", {{"near", {0.2}}, {"far", {200}}}, "", 0};
        const doctor_bar::Shot first = testShot(), second = testShot({-1.0, -0.5, -3.0});
        const std::array points{pointOf(first, wrong), pointOf(second, wrong)};
        const Diagnosis diagnosis = diagnose(doctor_bar::caseOf(first), points).value();
        QCOMPARE(diagnosis.verdict, std::string("scaled"));
        const std::vector<Candidate> alike = diagnosis.alike();
        QVERIFY(!alike.empty());
        QCOMPARE(alike.front().id, std::string("near-far-differ"));
        QVERIFY(alike.front().alike == Alike::Always);
        QCOMPARE(alike.front().values[0].numbers, std::vector<double>{0.2});
        QCOMPARE(alike.front().values[1].numbers, std::vector<double>{200.0});
    }

    void theValueIsASentence_data()
    {
        addColumn<WrongValue>("wrong");
        addColumn<QString>("sentence");
        const auto row = [](const char *title, const WrongValue &wrong, const char *sentence) {
            newRow(title) << wrong << QString(sentence);
        };
        row("far", {"far-differs", {{"far", {50}}}, "", 0}, "Your program's far plane is at 50, the scene's at 100. ");
        row("scaled", {"scaled", {{"factor", {1000}}}, "origin", 0},
            "Your program scales its points by 1000 about the origin. ");
        row("shift", {"pixel-shifted", {{"dx", {8}}, {"dy", {31}}}, "", 0},
            "Your program's pixel is 8 to the right and 31 down. ");
        row("letterbox", {"pixel-scaled-and-moved", {{"scale", {1.5}}, {"dx", {200}}, {"dy", {0}}}, "", 0},
            "Your program's pixel is scaled by 1.5 and moved by (200, 0). ");
        row("viewport", {"viewport-size-differs", {{"width", {800}}, {"height", {600}}}, "", 0},
            "Your program's viewport has 800 x 600 pixels; the scene's has 814 x 723. ");
        row("axes", {"axes-differ", {}, "x,z,y", 0}, "Your program's axes are x,z,y: y and z are exchanged. ");
    }

    void theValueIsASentence()
    {
        QFETCH(WrongValue, wrong);
        QFETCH(QString, sentence);
        const doctor_bar::Shot shot = testShot();
        const Diagnosis diagnosis = diagnosed(shot, pointOf(shot, wrong));
        const QString said = QString::fromStdString(candidateSentence(diagnosis.candidates.front()));
        QVERIFY2(said.startsWith(sentence), qPrintable(said));
        QCOMPARE(said.count(QStringLiteral(". ")), 1);
    }
};

UNPROJECTOR_TEST(TestDoctorSolved)
#include "test_doctor_solved.moc"
