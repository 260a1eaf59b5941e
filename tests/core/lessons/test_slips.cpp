// Classic wrong answers to the questions of lessons are recognised by the numbers of the step.

#include "tests/support/test.h"

#include "core/lessons/covered_panels.h"
#include "core/lessons/slips.h"

#include <QFile>

#include <cmath>
#include <numbers>

using namespace unprojector;
using namespace unprojector::lessons;

namespace {

constexpr double kTolerance = 0.01;

Lesson lessonOf(const QString &name)
{
    QFile file(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/resources/lessons/") + name + QStringLiteral(".json"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read.", qPrintable(file.fileName()));
    const auto lesson = parseLesson(name.toStdString(), file.readAll().toStdString());
    if (!lesson)
        qFatal("%s", lesson.error().message().c_str());
    return *lesson;
}

/// A question in a view of 500 × 400 pixels at the ratio 2, with near 5 and far 25.
Asked askedFor(AskedKind kind, double answer, bool isPerspective = true)
{
    Asked asked;
    asked.kind = kind;
    asked.answer = answer;
    asked.tolerance = kTolerance;
    asked.height = 400.0;
    asked.ratio = 2.0;
    asked.nearDistance = 5.0;
    asked.farDistance = 25.0;
    asked.isPerspective = isPerspective;
    return asked;
}

QString written(const std::vector<CoveredPanel> &covered)
{
    QStringList parts;
    for (const CoveredPanel &one : covered)
        parts << QStringLiteral("%1:%2").arg(QLatin1String(nameOf(one.panel))).arg(one.until);
    return parts.join(QLatin1Char(' '));
}

} // namespace

class TestSlips : public QObject {
    Q_OBJECT

private slots:
    void aSlipIsRecognised_data()
    {
        addColumn<Asked>("asked");
        addColumn<double>("given");
        addColumn<int>("slip"); // -1: none
        const auto row = [](const char *name, const Asked &asked, double given, std::optional<SlipKind> slip) {
            newRow(name) << asked << given << (slip ? static_cast<int>(*slip) : -1);
        };
        using enum AskedKind;
        const Asked windowX = askedFor(WindowX, 162.5), windowY = askedFor(WindowY, 212.5);
        row("right", windowY, 212.5, {});
        row("right within the tolerance", windowY, 212.495, {});
        row("left edge", windowX, 162.0, SlipKind::LeftEdge);
        row("right edge", windowX, 163.0, SlipKind::RightEdge);
        row("upper edge: height minus row", windowY, 213.0, SlipKind::UpperEdge);
        row("lower edge", windowY, 212.0, SlipKind::LowerEdge);
        row("the row itself", windowY, 187.0, SlipKind::NotFlipped);
        row("its centre from the top", windowY, 187.5, SlipKind::NotFlipped);
        row("the row below", windowY, 188.0, SlipKind::NotFlipped);
        row("height minus 1 minus y", windowY, 186.5, SlipKind::NotFlipped);
        row("a pixel's upper edge from the top", askedFor(DeviceY, 187.5), 187.0, SlipKind::UpperEdge);
        row("a pixel's lower edge from the top", askedFor(DeviceY, 187.5), 188.0, SlipKind::LowerEdge);
        row("counted from the bottom", askedFor(DeviceY, 187.5), 212.5, SlipKind::Flipped);
        row("a row without the 1", askedFor(Row, 174.0), 175.0, SlipKind::RowAbove);
        row("a row's centre", askedFor(Row, 174.0), 174.5, SlipKind::RowCentre);
        row("a row from the top", askedFor(Row, 174.0), 225.0, SlipKind::NotFlipped);
        row("times the ratio", windowX, 325.0, SlipKind::TimesRatio);
        row("over the ratio", windowX, 81.25, SlipKind::OverRatio);
        row("no ratio in eye coordinates", askedFor(Other, 10.0), 20.0, {});
        row("sign", askedFor(Other, -3.5), 3.5, SlipKind::Sign);
        row("the distance for z", askedFor(EyeZ, -10.0), 10.0, SlipKind::DistanceForZ);
        row("z for the distance", askedFor(Distance, 10.0), -10.0, SlipKind::Sign);
        // The depth 0.625 is at the distance 10: 5 · 25 / (25 · 0.375 + 5 · 0.625).
        row("near and far swapped: depth", askedFor(WindowDepth, 0.625), 0.375, SlipKind::NearFarSwapped);
        row("near and far swapped: distance", askedFor(Distance, 10.0), 125.0 / (25 * 0.625 + 5 * 0.375),
            SlipKind::NearFarSwapped);
        row("near and far swapped: z", askedFor(EyeZ, -10.0), -125.0 / (25 * 0.625 + 5 * 0.375),
            SlipKind::NearFarSwapped);
        row("near and far swapped: box", askedFor(Distance, 10.0, false), 20.0, SlipKind::NearFarSwapped);
        row("NDC for the depth", askedFor(WindowDepth, 0.625), 0.25, SlipKind::NdcForDepth);
        row("the depth for NDC", askedFor(NdcZ, 0.25), 0.625, SlipKind::DepthForNdc);
        row("NDC for the depth in (13)", askedFor(Distance, 10.0), 125.0 / (25 * 0.75 + 5 * 0.25),
            SlipKind::NdcForDepth);
        row("the depth for NDC in (13)", askedFor(Distance, 10.0), 125.0 / (25 * 0.1875 + 5 * 0.8125),
            SlipKind::DepthForNdc);
        row("an even scale", askedFor(Distance, 10.0), 5 + 0.625 * 20, SlipKind::EvenDepth);
        row("an even scale of depths", askedFor(WindowDepth, 0.625), 0.25, SlipKind::NdcForDepth); // both lead there
        row("an even scale is a box's own", askedFor(Distance, 12.5, false), 125.0 / 17.5, {});
        row("degrees", askedFor(Other, 1.0), 180.0 / std::numbers::pi, SlipKind::DegreesForRadians);
        row("radians", askedFor(Other, 90.0), std::numbers::pi / 2.0, SlipKind::RadiansForDegrees);
        row("none", windowY, 17.3, {});
        row("not a number", windowY, std::nan(""), {});
    }

    void aSlipIsRecognised()
    {
        QFETCH(Asked, asked);
        QFETCH(double, given);
        QFETCH(int, slip);
        const std::optional<SlipKind> found = slipOf(asked, given);
        QCOMPARE(found ? static_cast<int>(*found) : -1, slip);
    }

    /// A coordinate is no slip of itself at the ratio 1; the question's own depth range applies.
    void thePixelsAreThoseOfTheScreen()
    {
        Asked asked = askedFor(AskedKind::WindowX, 162.5);
        asked.ratio = 1.25;
        QVERIFY(slipOf(asked, 203.125) == SlipKind::TimesRatio);
        QVERIFY(slipOf(asked, 130.0) == SlipKind::OverRatio);
        asked.ratio = 1.0;
        QVERIFY(!slipOf(asked, 162.5) && !slipOf(asked, 130.0));
        Asked depth = askedFor(AskedKind::WindowDepth, 0.8125); // 0.625 of the range from 0.5 to 1
        depth.depthAtNear = 0.5;
        QVERIFY(slipOf(depth, 0.6875) == SlipKind::NearFarSwapped);
        QVERIFY(slipOf(depth, 0.25) == SlipKind::NdcForDepth);
    }

    void anglesSlipByTheirUnit()
    {
        Asked asked = askedFor(AskedKind::Other, 10.0 * std::tan(std::numbers::pi / 6.0));
        asked.anglesDegrees = {30.0};
        QVERIFY(slipOf(asked, 10.0 * std::tan(30.0)) == SlipKind::DegreesForRadians);
        asked.answer = 1.0 / std::tan(std::numbers::pi / 6.0);
        QVERIFY(slipOf(asked, 1.0 / std::tan(30.0)) == SlipKind::DegreesForRadians);
        asked.anglesDegrees.clear();
        QVERIFY(!slipOf(asked, 1.0 / std::tan(30.0)));
    }

    void lessonsKnowTheirSlips_data()
    {
        addColumn<QString>("lesson");
        addColumn<QString>("step");
        addColumn<double>("given");
        addColumn<int>("slip");
        const auto row = [](const char *lesson, const char *step, double given, SlipKind slip) {
            addRow("%s %s %g", lesson, step, given)
                << QString::fromLatin1(lesson) << QString::fromLatin1(step) << given << static_cast<int>(slip);
        };
        row("first", "window", 88.0, SlipKind::UpperEdge);
        row("first", "window", 87.0, SlipKind::LowerEdge);
        row("first", "window", 412.0, SlipKind::NotFlipped);
        row("first", "distance", 6.153846, SlipKind::NearFarSwapped);
        row("first", "distance", 65.0, SlipKind::EvenDepth);
        row("first", "distance", -20.0, SlipKind::Sign);
        row("weng", "look_at", 10.0, SlipKind::DistanceForZ);
        row("weng", "viewport", 230.0, SlipKind::LeftEdge);
        row("weng", "ortho", 0.75, SlipKind::NearFarSwapped);
        row("weng", "ortho", -0.5, SlipKind::NdcForDepth);
        row("weng", "mfc_click", 291.0, SlipKind::RowAbove);
        row("weng", "mfc_click", 209.0, SlipKind::NotFlipped);
        row("pipeline", "back", 275.0, SlipKind::RowAbove);
        row("pipeline", "viewport_50", 0.5, SlipKind::NdcForDepth);
        row("derivation", "perspective", 0.75 * std::tan(45.0), SlipKind::DegreesForRadians);
        row("parallel", "orthographic", 2.0 / 7.0, SlipKind::DepthForNdc);
    }

    void lessonsKnowTheirSlips()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(double, given);
        QFETCH(int, slip);
        const Lesson read = lessonOf(lesson);
        const auto numbers = LessonNumbers::of(read, {800, 600, 1.0});
        QVERIFY(numbers);
        const auto asked = askedIn(*numbers, *read.step(step.toStdString()));
        QVERIFY(asked);
        const auto found = slipOf(*asked, given);
        QCOMPARE(found ? static_cast<int>(*found) : -1, slip);
    }

    void everyRightAnswerIsRight_data()
    {
        addColumn<QString>("lesson");
        for (const char *name : {"first", "weng", "pipeline", "derivation", "rows", "parallel"})
            newRow(name) << QString::fromLatin1(name);
    }

    void everyRightAnswerIsRight()
    {
        QFETCH(QString, lesson);
        const Lesson read = lessonOf(lesson);
        const auto numbers = LessonNumbers::of(read, {800, 600, 2.0});
        QVERIFY(numbers);
        for (const Step &step : read.steps) {
            const auto asked = askedIn(*numbers, step);
            QCOMPARE(asked.has_value(), step.question.has_value());
            QVERIFY(!asked || (isRight(*asked, asked->answer) && !slipOf(*asked, asked->answer)));
        }
    }

    void panelsStayCoveredUntilTheirLastAnswer()
    {
        const Lesson first = lessonOf(QStringLiteral("first"));
        // Step 1 asks nothing, but a click there gives the answers to all steps after it: window y, NDC
        // x, … and the world z.
        QCOMPARE(written(coveredPanels(first, 0, {})),
                 QStringLiteral("comparison:6 pipeline:6 inspector:1 lifecycle:1"));
        QCOMPARE(written(coveredPanels(first, 1, {1})), QStringLiteral("comparison:6 pipeline:6"));
        QCOMPARE(written(coveredPanels(first, 6, {1, 3, 4, 5, 6})), QString());
        // Another scene has its own answers.
        const Lesson weng = lessonOf(QStringLiteral("weng"));
        const auto indexOf = [](const Lesson &lesson, const char *id) {
            return static_cast<std::size_t>(lesson.step(id) - lesson.steps.data());
        };
        const std::size_t world = indexOf(weng, "world"), ortho = indexOf(weng, "ortho");
        QCOMPARE(written(coveredPanels(weng, world, {world})), QString());
        QVERIFY(!coveredPanels(weng, ortho, {}).empty());
        // The edge is asked for later, and only clicked there.
        const Lesson rows = lessonOf(QStringLiteral("rows"));
        const std::size_t vertex = indexOf(rows, "vertex"), edge = indexOf(rows, "edge_face");
        QCOMPARE(written(coveredPanels(rows, vertex, {vertex})), QString());
        QVERIFY(!coveredPanels(rows, edge, {vertex}).empty());
    }
};

UNPROJECTOR_TEST(TestSlips)
#include "test_slips.moc"
