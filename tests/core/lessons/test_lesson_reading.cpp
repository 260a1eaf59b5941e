// The parsing of a lesson: the inheritance between steps, the check of its numbers, and the errors
// of a lesson that cannot be parsed.

#include "tests/support/test.h"

#include "core/lessons/lesson.h"
#include "core/lessons/set_link.h"
#include "core/lessons/step_numbers.h"
#include "tests/core/lessons/lesson_texts.h"
#include "tests/core/lessons/statements.h"

#include <nlohmann/json.hpp>

#include <QRegularExpression>

#include <cmath>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::lessons;
using namespace lessontexts;
using namespace unprojector::scene;

/// The text of a link, written anew from its parsed form.
QString writtenAgain(const Link &link)
{
    struct Writer {
        QString operator()(const FormulasLink &one) const { return "formulas:" + QString::fromStdString(one.anchor); }
        QString operator()(const ClickLink &one) const { return "click:" + QString::fromStdString(one.point); }
        QString operator()(const SetLink &one) const { return "set:" + QString::fromStdString(one.change); }
        QString operator()(const PanelLink &one) const { return QString("panel:") + nameOf(one.panel); }
        QString operator()(const WorkspaceLink &one) const { return QString("place:") + nameOf(one.workspace); }
        QString operator()(const StepLink &one) const { return "step:" + QString::fromStdString(one.id); }
        QString operator()(const RestartLink &) const { return "restart:"; }
        QString operator()(const GivenPointLink &) const { return "point:"; }
        QString operator()(const FactorsLink &one) const
        {
            return one.matrix == FactorsLink::Matrix::View ? "apart:view" : "apart:projection";
        }
        QString operator()(const MatrixLink &one) const
        {
            constexpr std::array kNames{"model", "view", "projection", "viewport"};
            return QString("matrix:") + kNames[static_cast<std::size_t>(one.stage)];
        }
        QString operator()(const ActionLink &one) const
        {
            return "action:" + QString::fromStdString(one.name) + (one.isOn ? "" : ":off");
        }
        QString operator()(const ViewSizeLink &one) const
        {
            return QString("view:%1x%2").arg(one.size.x).arg(one.size.y);
        }
    };
    return std::visit(Writer(), link);
}

class TestLessonReading : public QObject {
    Q_OBJECT

private slots:
    void panelsThatShowTheAnswerAreKnown_data()
    {
        addColumn<QByteArray>("answer");
        addColumn<QStringList>("hidden");
        const QStringList both{"inspector", "pipeline", "comparison"}, own{"inspector"};
        newRow("of the followed point") << QByteArray("eye.z") << both;
        newRow("its distance") << QByteArray("-eye.z") << both;
        newRow("of a pixel") << QByteArray("clicked.world.x") << both;
        newRow("by the formulas") << QByteArray("clicked.formula.x") << both;
        newRow("of a point that a link clicks") << QByteArray("linked.ndc.y") << both;
        newRow("of one that was clicked before") << QByteArray("earlier.ndc.y") << both;
        newRow("of one that an answer before clicks") << QByteArray("revealed.ndc.y") << both;
        newRow("of one that only its own answer clicks") << QByteArray("own.ndc.y") << own;
        newRow("of one that nobody clicks") << QByteArray("other.ndc.y") << own;
        newRow("of a matrix") << QByteArray("projection[2][2]") << QStringList{"inspector", "pipeline"};
        newRow("of its factors") << QByteArray("projectionSteps[0][2][3]") << QStringList{"inspector", "pipeline"};
        newRow("in pixels") << QByteArray("clicked.window.y")
                            << QStringList{"inspector", "pipeline", "comparison", "lifecycle"};
        newRow("a depth") << QByteArray("window.z")
                          << QStringList{"inspector", "pipeline", "comparison", "precision", "lifecycle"};
        newRow("of another step") << QByteArray("a:eye.z") << own;
        newRow("computed") << QByteArray("eye.z * 2") << own;
        newRow("of the scene") << QByteArray("scene.projection.near") << own;
    }

    void panelsThatShowTheAnswerAreKnown()
    {
        QFETCH(QByteArray, answer);
        QFETCH(QStringList, hidden);
        const QByteArray json = R"({"title": "T", "steps": [
        {"id": "a", "title": "A", "text": ["<a href='click:earlier'>x</a>"], "scene": "zhangci-model-view",
         "points": {"clicked": {"pixel": [275, 225]},
                    "linked": {"space": "world", "coordinates": [1, 1, -3]},
                    "earlier": {"space": "world", "coordinates": [2, 0, -3]},
                    "revealed": {"space": "world", "coordinates": [1, 0, -3]},
                    "own": {"space": "world", "coordinates": [0, 1, -3]},
                    "other": {"space": "world", "coordinates": [0, 2, -3]}},
         "question": {"text": "?", "answer": "quoted 1", "tolerance": 0.1, "reveal": ["<a href='click:revealed'>x</a>"]}},
        {"id": "b", "title": "B", "text": ["<a href='click:linked'>x</a>"],
         "question": {"text": "?", "answer": "%", "tolerance": 0.1, "hides": ["inspector"],
                      "reveal": ["<a href='click:own'>x</a>"]}}]})";
        const auto lesson = parseLesson("t", QByteArray(json).replace('%', answer).toStdString());
        QVERIFY2(lesson, lesson ? "" : lesson.error().message().c_str());
        QStringList found;
        for (const Panel panel : lesson->steps[1].question->hides)
            found << QString::fromLatin1(nameOf(panel));
        QCOMPARE(found, hidden);
    }

    void aWrongNumberIsFound_data()
    {
        addColumn<QByteArray>("text");
        addColumn<QByteArray>("fault");
        const auto row = [](const char *name, const char *text, const char *fault) {
            newRow(name) << QByteArray(text) << QByteArray(fault);
        };
        row("right", "{−8 = modelview[2][3]} and {(0, 0, 5) = scene.view.eye}", "");
        row("rounded", "{−0.10 = projection[2][2]}, {0.1 = projection[0][0]}", "");
        row("another", "{−7 = modelview[2][3]}", "a.text: \"−7\" says -7, it is -8");
        row("another sign", "{8 = modelview[2][3]}", "a.text: \"8\" says 8, it is -8");
        row("its last digit", "{0.11 = projection[0][0]}", "a.text: \"0.11\" says 0.11, it is 0.1");
        row("a whole number is meant exactly", "{2 = -0.3 * eye.z}", "a.text: \"2\" says 2, it is 2.4");
        row("with itself", "{2 = 2}", "a.text: \"2\" names \"2\", which the program does not compute");
        row("of the source", "{2 = quoted}", "");
        row("one of the source", "{4 = quoted 4}", "");
        row("another of the source", "{5 = quoted 4}", "a.text: \"5\" says 5, it is 4");
        row("none of the source", "{5 = quoted four}",
            "a.text: \"5\" names \"quoted four\", which the program does not compute");
        row("too many", "{(1, 1) = eye.z}", "a.text: \"(1, 1)\" says 2 numbers and names 1");
        row("no such path", "{1 = eye.q}", "a.text: \"1\" names \"eye.q\", which the program does not compute");
        row("half a place", "{1 = view[}", "a.text: \"1\" names \"view[\", which the program does not compute");
        row("beyond the last", "{1 = view[0][4]}",
            "a.text: \"1\" names \"view[0][4]\", which the program does not compute");
        row("of no source", "It is 5.", "a.text: 1 numbers outside of braces in \"It is 5.\"");
        row("an index is a name", "m[14] = {−8 = modelview[2][3]}", "");
        row("a step of a matrix",
            "{10 = projectionSteps[0][2][3] + 10}, {−5 = viewSteps[0][2][3]}, {0.1 = projectionSteps[1][0][0]}", "");
        row("no such step", "{1 = projectionSteps[3][0][0]}",
            "a.text: \"1\" names \"projectionSteps[3][0][0]\", which the program does not compute");
        row("an expression", "{16 = -2 * eye.z}, {4/5 = eye.z / -10}", "");
    }

    void aWrongNumberIsFound()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, fault);
        auto lesson = parseLesson("t", oneStep(R"(, "scene": "zhangci-model-view")"));
        QVERIFY2(lesson, lesson ? "" : lesson.error().message().c_str());
        Lesson made = *lesson;
        made.steps[0].text = {text.toStdString()};
        const auto numbers = LessonNumbers::of(made, {800, 600, 1.0});
        QVERIFY(numbers);
        QCOMPARE(written(faultsOf(*numbers, made.steps[0])).trimmed(), QString::fromUtf8(fault));
    }

    void statementsAreTakenApart_data()
    {
        addColumn<QByteArray>("text");
        addColumn<QByteArray>("shown");
        addColumn<QList<double>>("numbers");
        addColumn<int>("faults");
        const auto row = [](const char *name, const char *text, const char *shown, const QList<double> &numbers,
                            int faults = 0) {
            newRow(name) << QByteArray(text) << QByteArray(shown) << numbers << faults;
        };
        row("none", "nothing", "nothing", {});
        row("signs", "{−1, -2 and ±3 = a}", "−1, -2 and ±3", {-1, -2, 3});
        row("differences", "{500 − (187 + 0.5) = 312.5 = a}", "500 − (187 + 0.5) = 312.5", {500, 187, 0.5, 312.5});
        row("fractions", "{−3/7 or 16 : 9 = a}", "−3/7 or 16 : 9", {-3.0 / 7, 16.0 / 9});
        row("names", "{m[14] = −8 = a}", "m[14] = −8", {-8});
        row("a range of them", "m[0..15] {2 = a}", "m[0..15] 2", {2});
        row("links to formulas", "<a href='formulas:w9'>(9)</a> {<b>2</b> = a}",
            "<a href='formulas:w9'>(9)</a> <b>2</b>", {2});
        row("other numbers in them", "<a href='formulas:x'>(9) to (12): +0.143</a>",
            "<a href='formulas:x'>(9) to (12): +0.143</a>", {}, 1);
        row("loose", "7 {8 = a}", "7 8", {8}, 1);
        row("no source", "{8}", "8", {}, 1);
        row("unclosed", "a {8 = b", "a ", {}, 1);
        row("unopened", "8} = b", "8} = b", {}, 2);
    }

    void statementsAreTakenApart()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, shown);
        QFETCH(QList<double>, numbers);
        QFETCH(int, faults);
        const StatedText made = statedText(text.toStdString());
        QCOMPARE(QByteArray::fromStdString(shownText(text.toStdString())), shown);
        QList<double> found;
        for (const Statement &statement : made.statements) {
            for (const StatedNumber &number : statement.numbers)
                found << number.value;
        }
        QCOMPARE(found, numbers);
        QCOMPARE(int(made.faults.size()), faults);
    }

    void aClickMayTakeAVertex()
    {
        // The square from -4 to 4 at z = -4, in a box of 18 on 600 pixels.
        const auto lesson = parseLesson("t", oneStep(R"(, "scene": "parallel-orthographic", "points": {
        "clicked": {"pixel": [431, 431]},
        "vertex": {"pixel": [431, 431], "snap": "vertex"},
        "edge": {"pixel": [431, 300], "snap": "edge"},
        "beside": {"pixel": [434, 300], "snap": "face"}})"));
        QVERIFY2(lesson, lesson ? "" : lesson.error().message().c_str());
        const auto numbers = LessonNumbers::of(*lesson, {600, 600, 1.0});
        QVERIFY2(numbers, numbers ? "" : numbers.error().message().c_str());
        const auto at = [&](const char *path) { return numbers->step("a").at(path); };
        QVERIFY(std::fabs(at("clicked.world")[0] - 3.945) < 1e-9 && std::fabs(at("clicked.world")[1] + 3.945) < 1e-9);
        QCOMPARE(at("vertex.world"), (std::vector<double>{4.0, -4.0, -4.0}));
        QVERIFY(std::fabs(at("edge.world.x")[0] - 4.0) < 1e-9 && std::fabs(at("edge.world.y")[0] + 0.015) < 1e-9);
        QVERIFY(std::fabs(at("beside.world.x")[0] - 4.0) < 0.03); // within a pixel of the face
    }

    void aPointOutsideHasNoPixel()
    {
        const auto lesson = parseLesson("t", oneStep(R"(, "scene": "zhangci-perspective", "points": {
        "middle": {"space": "eye", "coordinates": [0, 0, -5]},
        "beside": {"space": "eye", "coordinates": [0, -1e13, -5]},
        "in_the_eye": {"space": "eye", "coordinates": [0, 0, 0]}})"));
        QVERIFY2(lesson, lesson ? "" : lesson.error().message().c_str());
        const auto numbers = LessonNumbers::of(*lesson, {300, 300, 1.0});
        QVERIFY(numbers);
        QVERIFY(numbers->step("a").pixelOf("middle") == (DevicePixel{150, 150}));
        QVERIFY(!numbers->step("a").pixelOf("beside"));
        QVERIFY(!numbers->step("a").pixelOf("in_the_eye"));
    }

    void aStepGoesOnFromTheOneBefore()
    {
        const auto lesson = parseLesson("t", R"({"title": "T", "steps": [
        {"id": "a", "title": "A", "text": ["x"], "scene": "zhangci-perspective", "view": [30, 20],
         "points": {"p": {"space": "world", "coordinates": [1, 2, 3]}}},
        {"id": "b", "title": "B", "text": ["x"], "change": {"projection": {"near": 2}}, "highlights": ["cube", "axes"]},
        {"id": "c", "title": "C", "text": ["x"], "scene": "zhangci-2d"}]})");
        QVERIFY2(lesson, lesson ? "" : lesson.error().message().c_str());
        QCOMPARE(lesson->steps[1].scene.json()["projection"]["near"].get<double>(), 2.0);
        QCOMPARE(lesson->steps[1].scene.json()["projection"]["far"].get<double>(), 100.0);
        QVERIFY(lesson->steps[1].view == glm::ivec2(30, 20));
        QCOMPARE(lesson->steps[1].points.size(), std::size_t(1));
        QVERIFY(!lesson->steps[2].view && lesson->steps[2].points.empty());
        QVERIFY(lesson->steps[1].highlights == (std::set{Highlight::Axes, Highlight::Cube}));
        QVERIFY(lesson->steps[2].highlights.empty()); // each step has its own
        const auto numbers = LessonNumbers::of(*lesson, {800, 600, 1.0});
        QVERIFY(numbers);
        QCOMPARE(numbers->values("a", "b:scene.projection.near"), std::vector<double>{2.0});
        QCOMPARE(numbers->values("b", "p.world").size(), std::size_t(3));
    }

    void aFaultNamesItsPlace_data()
    {
        addColumn<QByteArray>("json");
        addColumn<QByteArray>("error");
        const auto row = [](const char *name, const std::string &json, const char *error) {
            newRow(name) << QByteArray::fromStdString(json) << QByteArray(error);
        };
        row("no JSON", "{", "t.json: the file ends too early");
        row("no steps", R"({"title": "T"})", "t.json: steps: is missing");
        row("a wrong key", oneStep(R"(, "scene": "zhangci-2d", "tex": 1)"),
            "t.json: steps[0]: there is no key \"tex\"");
        row("no scene", oneStep(""), "t.json: steps[0]: the first step must have a \"scene\"");
        row("an unknown scene", oneStep(R"(, "scene": "kettle")"),
            "t.json: steps[0].scene: the program brings along no scene \"kettle\"");
        row("both", oneStep(R"(, "scene": "zhangci-2d", "change": {})"),
            "t.json: steps[0]: has a \"scene\" and a \"change\"");
        row("a point without coordinates", oneStep(R"(, "scene": "zhangci-2d", "points": {"p": {"space": "eye"}})"),
            "t.json: steps[0].points.p.coordinates: is missing");
        row("no tolerance", oneStep(R"(, "scene": "zhangci-2d", "question": {"answer": "eye.z"})"),
            "t.json: steps[0].question.tolerance: is missing");
        row("an unknown snap",
            oneStep(R"(, "scene": "zhangci-2d", "points": {"p": {"pixel": [1, 1], "snap": "corner"}})"),
            "t.json: steps[0].points.p.snap: ");
        row("half a view", oneStep(R"(, "scene": "zhangci-2d", "view": [1.5, 2])"), "t.json: steps[0].view[0]: ");
        row("an unknown highlight", oneStep(R"(, "scene": "zhangci-2d", "highlights": ["axes", "stars"])"),
            "t.json: steps[0].highlights[1]: ");
        row("an unknown panel", oneStep(R"(, "scene": "zhangci-2d", "panels": ["pipeline", "kitchen"])"),
            "t.json: steps[0].panels[1]: ");
        row("an unknown workspace", oneStep(R"(, "scene": "zhangci-2d", "place": "garden")"),
            "t.json: steps[0].place: ");
        row("a view beyond all numbers", oneStep(R"(, "scene": "zhangci-2d", "view": [1e12, 2])"),
            "t.json: steps[0].view[0]: ");
    }

    void aFaultNamesItsPlace()
    {
        QFETCH(QByteArray, json);
        QFETCH(QByteArray, error);
        const auto lesson = parseLesson("t", json.toStdString());
        QVERIFY(!lesson);
        QString text = QString::fromStdString(lesson.error().message());
        static const QRegularExpression place(QStringLiteral("^t\\.json:\\d+:\\d+: "));
        QVERIFY2(text.contains(place), qPrintable(text));
        QVERIFY2(text.replace(place, QStringLiteral("t.json: ")).startsWith(error), qPrintable(text));
    }

    void translationsMayBeIncomplete()
    {
        const std::string lesson = oneStep(R"(, "source": "S", "scene": "zhangci-2d")");
        const auto translated = parseLesson("t", lesson, R"({"steps": [{"id": "a", "title": "甲"}]})");
        QVERIFY2(translated, translated ? "" : translated.error().message().c_str());
        QCOMPARE(translated->steps[0].title, std::string("甲"));
        QCOMPARE(translated->steps[0].text, std::vector<std::string>{"x"});
        QCOMPARE(untranslated(lesson, R"({"steps": [{"id": "a", "title": "甲"}]})"),
                 (std::vector<std::string>{"title", "a.text", "a.source"}));
        QCOMPARE(untranslated(oneStep(""), R"({"title": "T", "steps": [{"id": "a", "title": "甲", "text": ["x"],
                                                                       "source": "源"}]})"),
                 (std::vector<std::string>{"a.source"}));
        const auto other = parseLesson("t", lesson, R"({"steps": [{"id": "b"}]})");
        QVERIFY(!other);
        QCOMPARE(other.error().message(), std::string("t, translated:1:12: steps[0]: the lesson has no step \"b\""));
    }

    /// More digits than a double holds are kept as they are written.
    void numbersMayHaveAllTheirDigits()
    {
        const auto lesson = parseLesson("t", oneStep(R"(, "scene": {"unprojector": 1,
        "window": {"width": 800, "height": 600, "devicePixelRatio": 1},
        "projection": {"type": "perspective", "fovy": 45, "near": 1, "far": 100},
        "view": {"eye": [0.70710678118654757, 0.10000000000000000555, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
        "objects": []})"));
        QVERIFY2(lesson, lesson ? "" : lesson.error().message().c_str());
        const auto scene = sceneOf(lesson->steps.front());
        QVERIFY2(scene, scene ? "" : scene.error().message().c_str());
        const Setup setup = *setupOf(*scene, {800, 600, 1.0}, {});
        QVERIFY(setup.camera().eye == WorldPoint(std::sqrt(0.5), 0.1, 5.0));
    }

    void aChangeLeavesTheRest()
    {
        const auto lesson = parseLesson("t", oneStep(R"(, "scene": "zhangci-perspective", "set": {
        "other": {"point": {"space": "eye", "coordinates": [0.1, 0, -5]}},
        "nearer": {"projection": {"near": 0.3}, "ui": {"clipDistancesFitObjects": false}},
        "wrong": {"projection": {"near": -2}}})"));
        QVERIFY2(lesson, lesson ? "" : lesson.error().message().c_str());
        const Step &step = lesson->steps.front();
        Scene scene = *sceneOf(step);
        LookAt camera = scene.camera;
        camera.eye = WorldPoint(0.1, 1.0 / 3.0, 5.0);
        scene.camera = camera;
        auto perspective = std::get<Perspective>(*scene.projection);
        perspective.verticalFov = 0.8; // of which degrees have other digits
        scene.projection = perspective;
        const Setup setup = *setupOf(scene, {800, 600, 1.0}, {});

        const SceneSettings other = *settingsWith(scene, setup, step.changes.at("other"));
        QVERIFY(other.givenPoint == (GivenPoint{EyePoint(0.1, 0, -5)}));
        QVERIFY(other.camera == scene.camera && other.projection == scene.projection);
        QCOMPARE(other.clipDistancesFitObjects, scene.clipDistancesFitObjects);

        const SceneSettings nearer = *settingsWith(scene, setup, step.changes.at("nearer"));
        QCOMPARE(std::get<Perspective>(*nearer.projection).nearDistance, 0.3);
        QVERIFY(!nearer.clipDistancesFitObjects);
        QVERIFY(nearer.camera == scene.camera && nearer.givenPoint == scene.givenPoint);

        const auto wrong = settingsWith(scene, setup, step.changes.at("wrong"));
        QVERIFY(!wrong);
        const QByteArray why = QByteArray::fromStdString(wrong.error().message());
        QVERIFY2(why.contains("projection.near"), why.constData());
        // A missing member cannot be set: a result without a change must not pass for the answer.
        const auto unknown = settingsWith(
            scene, setup, base::JsonValue(nlohmann::ordered_json::parse(R"({"projection": {"left": 1}})")));
        QVERIFY(!unknown);
        QCOMPARE(QByteArray::fromStdString(unknown.error().message()), QByteArray("set: there is no projection.left"));
    }

    void linksAreRead_data()
    {
        addColumn<bool>("isLink");
        for (const char *link :
             {"formulas:w9", "click:corner", "set:other", "panel:observer", "panel:points", "place:doctor",
              "step:ortho", "restart:", "point:", "apart:view", "apart:projection", "matrix:model", "matrix:viewport",
              "action:rows", "action:perspective:off", "view:300x200"})
            newRow(link) << true;
        for (const char *link :
             {"", "formulas", "formulas:", "panel:kitchen", "place:comparison", "apart:model", "matrix:whole",
              "action:", "action::off", "action:rows:on", "view:300", "view:300x", "view:0x200", "view:-300x200",
              "view:300x200x", "view:3e2x200", "restart:1", "http://example.org", "Panel:observer"})
            newRow(link) << false;
    }

    void linksAreRead()
    {
        QFETCH(bool, isLink);
        const std::optional<Link> link = parseLink(QTest::currentDataTag());
        QCOMPARE(link.has_value(), isLink);
        if (link)
            QCOMPARE(writtenAgain(*link), QString::fromLatin1(QTest::currentDataTag()));
    }
};

UNPROJECTOR_TEST(TestLessonReading)
#include "test_lesson_reading.moc"
