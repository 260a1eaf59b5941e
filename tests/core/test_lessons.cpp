// The lessons that come with the program, each step of each in both languages: every number that a text states is the one that
// the program computes, every link leads somewhere. And what is said of lessons that cannot be read.

#include "core/lessons/highlights.h"
#include "core/lessons/lesson.h"
#include "core/lessons/set_link.h"
#include "core/lessons/statements.h"
#include "core/lessons/step_numbers.h"
#include "core/scene/bundled_models.h"
#include "tests/support/errata.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::lessons;

namespace {

const QString kFolder = QStringLiteral(UNPROJECTOR_SOURCE_DIR "/resources/lessons/");

std::string fileText(const QString &name)
{
    QFile file(kFolder + name);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read.", qPrintable(file.fileName()));
    return file.readAll().toStdString();
}

std::vector<std::string> names()
{
    const auto listed = parseLessonNames(fileText(QStringLiteral("lessons.json")));
    if (!listed)
        qFatal("%s", listed.error().text.c_str());
    return *listed;
}

Lesson lessonOf(const QString &name, bool isTranslated)
{
    const auto lesson = isTranslated ? parseLesson(name.toStdString(), fileText(name + QStringLiteral(".json")),
                                                   fileText(name + QStringLiteral("_zh_CN.json")))
                                     : parseLesson(name.toStdString(), fileText(name + QStringLiteral(".json")));
    if (!lesson)
        qFatal("%s", lesson.error().text.c_str());
    return *lesson;
}

QString allOf(const Step &step)
{
    std::string all;
    for (const std::string &paragraph : step.text)
        all += paragraph;
    if (step.question) {
        all += step.question->text;
        for (const std::string &paragraph : step.question->reveal)
            all += paragraph;
    }
    return QString::fromStdString(all);
}

/// Where the links of a step lead to.
QStringList linksOf(const Step &step)
{
    static const QRegularExpression link(QStringLiteral("<a href='([^']*)'>"));
    QStringList links;
    for (auto it = link.globalMatch(allOf(step)); it.hasNext();)
        links << it.next().captured(1);
    links.sort();
    return links;
}

QString written(const std::vector<std::string> &lines)
{
    QString text;
    for (const std::string &line : lines)
        text += QString::fromStdString(line) + QLatin1Char('\n');
    return text;
}

/// A lesson of one step on a scene that is there, with these members besides.
std::string oneStep(const char *members)
{
    return std::string(R"({"title": "T", "steps": [{"id": "a", "title": "A", "text": ["x"])") + members + "}]}";
}

} // namespace

class TestLessons : public QObject {
    Q_OBJECT

private slots:
    void allFilesAreListed();
    void everyNumberIsThePrograms_data();
    void everyNumberIsThePrograms();
    void everyTextIsTranslated_data() { lessonRows(); }
    void everyTextIsTranslated();
    void everyLinkLeadsSomewhere_data() { lessonRows(); }
    void everyLinkLeadsSomewhere();
    void everyFormulaOfThePaperHasItsNumbers_data();
    void everyFormulaOfThePaperHasItsNumbers();
    void everyErrorIsTold_data();
    void everyErrorIsTold();
    void panelsThatShowTheAnswerAreClosed_data();
    void panelsThatShowTheAnswerAreClosed();
    void aWrongNumberIsFound_data();
    void aWrongNumberIsFound();
    void statementsAreTakenApart_data();
    void statementsAreTakenApart();
    void aClickMayTakeAVertex();
    void aPointOutsideHasNoPixel();
    void aStepGoesOnFromTheOneBefore();
    void aFaultNamesItsPlace_data();
    void aFaultNamesItsPlace();
    void translationsMayBeIncomplete();
    void axesAreNamed_data();
    void axesAreNamed();
    void theVolumesSidesAreLettered_data();
    void theVolumesSidesAreLettered();
    void theCubesSidesAreNumbered();
    void theViewportIsMeasured();
    void aChangeLeavesTheRest();

private:
    static void lessonRows();
};

void TestLessons::lessonRows()
{
    QTest::addColumn<QString>("name");
    for (const std::string &name : names())
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
}

void TestLessons::allFilesAreListed()
{
    QStringList wanted{QStringLiteral("lessons.json")};
    for (const std::string &name : names())
        wanted << QString::fromStdString(name) + QStringLiteral(".json")
               << QString::fromStdString(name) + QStringLiteral("_zh_CN.json");
    wanted.sort();
    QCOMPARE(QDir(kFolder).entryList(QDir::Files, QDir::Name), wanted);
}

void TestLessons::everyNumberIsThePrograms_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isTranslated");
    for (const std::string &name : names()) {
        QTest::addRow("%s", name.c_str()) << QString::fromStdString(name) << false;
        QTest::addRow("%s, Chinese", name.c_str()) << QString::fromStdString(name) << true;
    }
}

void TestLessons::everyNumberIsThePrograms()
{
    QFETCH(QString, name);
    QFETCH(bool, isTranslated);
    const Lesson lesson = lessonOf(name, isTranslated);
    for (const Surface &surface : {Surface{800, 600, 1.0}, Surface{1333, 900, 1.25}}) {
        const auto numbers = LessonNumbers::of(lesson, surface);
        QVERIFY2(numbers, numbers ? "" : numbers.error().text.c_str());
        for (const Step &step : lesson.steps) {
            const QString faults = written(numbers->faults(step));
            QVERIFY2(faults.isEmpty(), qPrintable(faults));
        }
    }
}

void TestLessons::everyTextIsTranslated()
{
    QFETCH(QString, name);
    const Lesson english = lessonOf(name, false), chinese = lessonOf(name, true);
    const auto missing = untranslated(english, fileText(name + QStringLiteral("_zh_CN.json")));
    QVERIFY(missing);
    QVERIFY2(missing->empty(), qPrintable(written(*missing)));
    for (std::size_t i = 0; i < english.steps.size(); ++i) {
        QCOMPARE(linksOf(chinese.steps[i]), linksOf(english.steps[i]));
        QCOMPARE(chinese.steps[i].text.size(), english.steps[i].text.size());
    }
}

void TestLessons::everyLinkLeadsSomewhere()
{
    QFETCH(QString, name);
    const Lesson lesson = lessonOf(name, false);
    const auto numbers = LessonNumbers::of(lesson, {800, 600, 1.0});
    QVERIFY(numbers);
    for (const Step &step : lesson.steps) {
        for (const QString &link : linksOf(step)) {
            const std::string where = (step.id + ": " + link.toStdString());
            const std::string to = link.section(QLatin1Char(':'), 1).toStdString();
            if (link.startsWith(QLatin1String("step:")))
                QVERIFY2(lesson.step(to), where.c_str());
            else if (link.startsWith(QLatin1String("click:")))
                QVERIFY2(numbers->step(step.id).pixelOf(to), where.c_str());
            else if (link.startsWith(QLatin1String("set:"))) {
                QVERIFY2(step.changes.contains(to), where.c_str());
                // Whatever point was typed before, a point that it gives is the same.
                const Scene opened = *sceneOf(step, bundledModels());
                const std::optional<GivenPoint> none, clip = GivenPoint{ClipPoint(2, 3, 4, 5)},
                                                      world = GivenPoint{WorldPoint(1, 2, 3)},
                                                      object = GivenPoint{ObjectPoint(4, 5, 6), opened.objects[0].name};
                std::optional<GivenPoint> made;
                for (const auto &before : {opened.givenPoint, none, clip, world, object}) {
                    Scene scene = opened;
                    scene.givenPoint = before;
                    const Surface surface{800, 600, 1.0};
                    const nlohmann::ordered_json &change = step.changes.at(to);
                    const auto changed = settingsWith(scene, *pictureOf(scene, surface, {}), change);
                    QVERIFY2(changed, changed ? "" : changed.error().text.c_str());
                    static_cast<SceneSettings &>(scene) = *changed;
                    QVERIFY2(pictureOf(scene, surface, {}), where.c_str());
                    if (!change.contains("point"))
                        made = before;
                    else if (!made)
                        made = scene.givenPoint;
                    QVERIFY2(scene.givenPoint == made, where.c_str());
                }
            } else
                QVERIFY2(link.startsWith(QLatin1String("formulas:")) || link.startsWith(QLatin1String("panel:"))
                             || link.startsWith(QLatin1String("place:")) || link.startsWith(QLatin1String("view:"))
                             || link.startsWith(QLatin1String("action:")) // named in the window, where they are tried
                             || link == QLatin1String("apart:view") || link == QLatin1String("apart:projection"),
                         where.c_str());
        }
    }
}

void TestLessons::everyFormulaOfThePaperHasItsNumbers_data()
{
    QTest::addColumn<QString>("anchor");
    for (int i = 1; i <= 12; ++i)
        QTest::addRow("(%d)", i) << QStringLiteral("w%1").arg(i);
    QTest::newRow("(13)") << QStringLiteral("z-perspective");
    QTest::newRow("(14)") << QStringLiteral("z-ortho");
    QTest::newRow("(15)") << QStringLiteral("shear");
    QTest::newRow("(16)") << QStringLiteral("eye-to-world");
}

/// Behind the link to it, in the same paragraph, an equation stands whose numbers are computed.
void TestLessons::everyFormulaOfThePaperHasItsNumbers()
{
    QFETCH(QString, anchor);
    const std::string link = "<a href='formulas:" + anchor.toStdString() + "'>";
    for (const bool isTranslated : {false, true}) {
        bool isFound = false;
        const auto look = [&](const std::string &paragraph) {
            const std::size_t at = paragraph.find(link);
            if (at == std::string::npos)
                return;
            for (const Statement &one : statedText(paragraph.substr(at)).statements)
                isFound = isFound || (!one.isQuoted && one.shown.find(" = ") != std::string::npos);
        };
        const Lesson lesson = lessonOf(QStringLiteral("weng"), isTranslated);
        for (const Step &step : lesson.steps) {
            std::for_each(step.text.begin(), step.text.end(), look);
            if (step.question)
                std::for_each(step.question->reveal.begin(), step.question->reveal.end(), look);
        }
        QVERIFY(isFound);
    }
}

void TestLessons::everyErrorIsTold_data()
{
    QTest::addColumn<QString>("anchor");
    for (const char *anchor : kErrata)
        QTest::newRow(anchor) << QString::fromLatin1(anchor);
}

/// Some step, where it belongs, leads to each error of the originals in Help.
void TestLessons::everyErrorIsTold()
{
    QFETCH(QString, anchor);
    bool isTold = false;
    for (const std::string &name : names()) {
        for (const Step &step : lessonOf(QString::fromStdString(name), false).steps)
            isTold = isTold || linksOf(step).contains(QStringLiteral("formulas:") + anchor);
    }
    QVERIFY(isTold);
}

void TestLessons::panelsThatShowTheAnswerAreClosed_data()
{
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<QStringList>("hidden");
    const QStringList both{"inspector", "pipeline", "comparison"}, own{"inspector"};
    QTest::newRow("of the followed point") << QByteArray("eye.z") << both;
    QTest::newRow("its distance") << QByteArray("-eye.z") << both;
    QTest::newRow("of a pixel") << QByteArray("clicked.world.x") << both;
    QTest::newRow("by the formulas") << QByteArray("clicked.formula.x") << both;
    QTest::newRow("of a point that a link clicks") << QByteArray("linked.ndc.y") << both;
    QTest::newRow("of one that was clicked before") << QByteArray("earlier.ndc.y") << both;
    QTest::newRow("of one that nobody clicks") << QByteArray("other.ndc.y") << own;
    QTest::newRow("of a matrix") << QByteArray("projection[2][2]") << QStringList{"inspector", "pipeline"};
    QTest::newRow("of another step") << QByteArray("a:eye.z") << own;
    QTest::newRow("computed") << QByteArray("eye.z * 2") << own;
    QTest::newRow("of the scene") << QByteArray("scene.projection.near") << own;
}

void TestLessons::panelsThatShowTheAnswerAreClosed()
{
    QFETCH(QByteArray, answer);
    QFETCH(QStringList, hidden);
    const QByteArray json = R"({"title": "T", "steps": [
        {"id": "a", "title": "A", "text": ["<a href='click:earlier'>x</a>"], "scene": "zhangci-model-view",
         "points": {"clicked": {"pixel": [275, 225]},
                    "linked": {"space": "world", "coordinates": [1, 1, -3]},
                    "earlier": {"space": "world", "coordinates": [2, 0, -3]},
                    "other": {"space": "world", "coordinates": [0, 2, -3]}}},
        {"id": "b", "title": "B", "text": ["<a href='click:linked'>x</a>"],
         "question": {"text": "?", "answer": "%", "tolerance": 0.1, "hides": ["inspector"]}}]})";
    const auto lesson = parseLesson("t", QByteArray(json).replace('%', answer).toStdString());
    QVERIFY2(lesson, lesson ? "" : lesson.error().text.c_str());
    QStringList found;
    for (const std::string &panel : lesson->steps[1].question->hides)
        found << QString::fromStdString(panel);
    QCOMPARE(found, hidden);
}

void TestLessons::aWrongNumberIsFound_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("fault");
    const auto row = [](const char *name, const char *text, const char *fault) {
        QTest::newRow(name) << QByteArray(text) << QByteArray(fault);
    };
    row("right", "{−8 = modelview[2][3]} and {(0, 0, 5) = scene.view.eye}", "");
    row("rounded", "{−0.10 = projection[2][2]}, {0.1 = projection[0][0]}", "");
    row("another", "{−7 = modelview[2][3]}", "a.text: \"−7\" says -7, it is -8");
    row("another sign", "{8 = modelview[2][3]}", "a.text: \"8\" says 8, it is -8");
    row("its last digit", "{0.11 = projection[0][0]}", "a.text: \"0.11\" says 0.11, it is 0.1");
    row("a whole number is meant exactly", "{2 = -0.3 * eye.z}", "a.text: \"2\" says 2, it is 2.4");
    row("with itself", "{2 = 2}", "a.text: \"2\" a: \"2\" is nothing that the program computes");
    row("of the source", "{2 = quoted}", "");
    row("one of the source", "{4 = quoted 4}", "");
    row("another of the source", "{5 = quoted 4}", "a.text: \"5\" says 5, it is 4");
    row("none of the source", "{5 = quoted four}",
        "a.text: \"5\" a: \"four\" in \"quoted four\" is no number of this step");
    row("too many", "{(1, 1) = eye.z}", "a.text: \"(1, 1)\" says 2 numbers and names 1");
    row("no such path", "{1 = eye.q}", "a.text: \"1\" a: \"eye.q\" in \"eye.q\" is no number of this step");
    row("half a place", "{1 = view[}", "a.text: \"1\" a: \"view[\" in \"view[\" is no number of this step");
    row("beyond the last", "{1 = view[0][4]}",
        "a.text: \"1\" a: \"view[0][4]\" in \"view[0][4]\" is no number of this step");
    row("of no source", "It is 5.", "a.text: 1 numbers outside of braces in \"It is 5.\"");
    row("an index is a name", "m[14] = {−8 = modelview[2][3]}", "");
    row("a step of a matrix",
        "{10 = projectionSteps[0][2][3] + 10}, {−5 = viewSteps[0][2][3]}, {0.1 = projectionSteps[1][0][0]}", "");
    row("no such step", "{1 = projectionSteps[3][0][0]}",
        "a.text: \"1\" a: \"projectionSteps[3][0][0]\" in \"projectionSteps[3][0][0]\" is no number of this step");
    row("an expression", "{16 = -2 * eye.z}, {4/5 = eye.z / -10}", "");
}

void TestLessons::aWrongNumberIsFound()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, fault);
    auto lesson = parseLesson("t", oneStep(R"(, "scene": "zhangci-model-view")"));
    QVERIFY2(lesson, lesson ? "" : lesson.error().text.c_str());
    Lesson made = *lesson;
    made.steps[0].text = {text.toStdString()};
    const auto numbers = LessonNumbers::of(made, {800, 600, 1.0});
    QVERIFY(numbers);
    QCOMPARE(written(numbers->faults(made.steps[0])).trimmed(), QString::fromUtf8(fault));
}

void TestLessons::statementsAreTakenApart_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("shown");
    QTest::addColumn<QList<double>>("numbers");
    QTest::addColumn<int>("faults");
    const auto row = [](const char *name, const char *text, const char *shown, const QList<double> &numbers,
                        int faults = 0) {
        QTest::newRow(name) << QByteArray(text) << QByteArray(shown) << numbers << faults;
    };
    row("none", "nothing", "nothing", {});
    row("signs", "{−1, -2 and ±3 = a}", "−1, -2 and ±3", {-1, -2, 3});
    row("differences", "{500 − (187 + 0.5) = 312.5 = a}", "500 − (187 + 0.5) = 312.5", {500, 187, 0.5, 312.5});
    row("fractions", "{−3/7 or 16 : 9 = a}", "−3/7 or 16 : 9", {-3.0 / 7, 16.0 / 9});
    row("names", "{m[14] = −8 = a}", "m[14] = −8", {-8});
    row("a range of them", "m[0..15] {2 = a}", "m[0..15] 2", {2});
    row("links to formulas", "<a href='formulas:w9'>(9)</a> {<b>2</b> = a}", "<a href='formulas:w9'>(9)</a> <b>2</b>",
        {2});
    row("other numbers in them", "<a href='formulas:x'>(9) to (12): +0.143</a>",
        "<a href='formulas:x'>(9) to (12): +0.143</a>", {}, 1);
    row("loose", "7 {8 = a}", "7 8", {8}, 1);
    row("no source", "{8}", "", {}, 1);
    row("unclosed", "a {8 = b", "a ", {}, 1);
    row("unopened", "8} = b", "8", {}, 2);
}

void TestLessons::statementsAreTakenApart()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, shown);
    QFETCH(QList<double>, numbers);
    QFETCH(int, faults);
    const StatedText made = statedText(text.toStdString());
    QCOMPARE(QByteArray::fromStdString(made.shown), shown);
    QList<double> found;
    for (const Statement &statement : made.statements) {
        for (const StatedNumber &number : statement.numbers)
            found << number.value;
    }
    QCOMPARE(found, numbers);
    QCOMPARE(int(made.faults.size()), faults);
}

void TestLessons::aClickMayTakeAVertex()
{
    // The square from -4 to 4 at z = -4, in a box of 18 on 600 pixels.
    const auto lesson = parseLesson("t", oneStep(R"(, "scene": "parallel-orthographic", "points": {
        "clicked": {"pixel": [431, 431]},
        "vertex": {"pixel": [431, 431], "snap": "vertex"},
        "edge": {"pixel": [431, 300], "snap": "edge"},
        "beside": {"pixel": [434, 300], "snap": "face"}})"));
    QVERIFY2(lesson, lesson ? "" : lesson.error().text.c_str());
    const auto numbers = LessonNumbers::of(*lesson, {600, 600, 1.0});
    QVERIFY2(numbers, numbers ? "" : numbers.error().text.c_str());
    const auto at = [&](const char *path) { return numbers->step("a").at(path); };
    QVERIFY(std::fabs(at("clicked.world")[0] - 3.945) < 1e-9 && std::fabs(at("clicked.world")[1] + 3.945) < 1e-9);
    QCOMPARE(at("vertex.world"), (std::vector<double>{4.0, -4.0, -4.0}));
    QVERIFY(std::fabs(at("edge.world.x")[0] - 4.0) < 1e-9 && std::fabs(at("edge.world.y")[0] + 0.015) < 1e-9);
    QVERIFY(std::fabs(at("beside.world.x")[0] - 4.0) < 0.03); // within a pixel of the face
}

void TestLessons::aPointOutsideHasNoPixel()
{
    const auto lesson = parseLesson("t", oneStep(R"(, "scene": "zhangci-perspective", "points": {
        "middle": {"space": "eye", "coordinates": [0, 0, -5]},
        "beside": {"space": "eye", "coordinates": [0, -1e13, -5]},
        "in_the_eye": {"space": "eye", "coordinates": [0, 0, 0]}})"));
    QVERIFY2(lesson, lesson ? "" : lesson.error().text.c_str());
    const auto numbers = LessonNumbers::of(*lesson, {300, 300, 1.0});
    QVERIFY(numbers);
    QVERIFY(numbers->step("a").pixelOf("middle") == (DevicePixel{150, 150}));
    QVERIFY(!numbers->step("a").pixelOf("beside"));
    QVERIFY(!numbers->step("a").pixelOf("in_the_eye"));
}

void TestLessons::aStepGoesOnFromTheOneBefore()
{
    const auto lesson = parseLesson("t", R"({"title": "T", "steps": [
        {"id": "a", "title": "A", "text": ["x"], "scene": "zhangci-perspective", "view": [30, 20],
         "points": {"p": {"space": "world", "coordinates": [1, 2, 3]}}},
        {"id": "b", "title": "B", "text": ["x"], "change": {"projection": {"near": 2}}, "highlights": ["cube", "axes"]},
        {"id": "c", "title": "C", "text": ["x"], "scene": "zhangci-2d"}]})");
    QVERIFY2(lesson, lesson ? "" : lesson.error().text.c_str());
    QCOMPARE(lesson->steps[1].scene["projection"]["near"].get<double>(), 2.0);
    QCOMPARE(lesson->steps[1].scene["projection"]["far"].get<double>(), 100.0);
    QVERIFY(lesson->steps[1].view == glm::ivec2(30, 20));
    QCOMPARE(lesson->steps[1].points.size(), std::size_t(1));
    QVERIFY(!lesson->steps[2].view && lesson->steps[2].points.empty());
    QVERIFY(lesson->steps[1].highlights == (std::set{Highlight::Axes, Highlight::Cube}));
    QVERIFY(lesson->steps[2].highlights.empty()); // each step has its own
    const auto numbers = LessonNumbers::of(*lesson, {800, 600, 1.0});
    QVERIFY(numbers);
    QCOMPARE(numbers->values("a", "b:scene.projection.near").value().front(), 2.0);
    QCOMPARE(numbers->values("b", "p.world").value().size(), std::size_t(3));
}

void TestLessons::aFaultNamesItsPlace_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QByteArray>("error");
    const auto row = [](const char *name, const std::string &json, const char *error) {
        QTest::newRow(name) << QByteArray::fromStdString(json) << QByteArray(error);
    };
    row("no JSON", "{", "t.json:1:2: ");
    row("no steps", R"({"title": "T"})", "t.json: steps: is missing");
    row("a wrong key", oneStep(R"(, "scene": "zhangci-2d", "tex": 1)"), "t.json: steps[0]: there is no key \"tex\"");
    row("no scene", oneStep(""), "t.json: steps[0]: the first step must have a \"scene\"");
    row("an unknown scene", oneStep(R"(, "scene": "kettle")"),
        "t.json: steps[0].scene: the program brings along no scene \"kettle\"");
    row("both", oneStep(R"(, "scene": "zhangci-2d", "change": {})"),
        "t.json: steps[0]: has a \"scene\" and a \"change\"");
    row("a point with the name of the changes",
        oneStep(R"(, "scene": "zhangci-2d", "points": {"set": {"pixel": [1, 1]}})"),
        "t.json: steps[0].points: \"set\" ");
    row("a taken name", oneStep(R"(, "scene": "zhangci-2d", "points": {"eye": {"pixel": [1, 1]}})"),
        "t.json: steps[0].points: \"eye\" is no free name");
    row("a point without coordinates", oneStep(R"(, "scene": "zhangci-2d", "points": {"p": {"space": "eye"}})"),
        "t.json: steps[0].points.p.coordinates: is missing");
    row("no tolerance", oneStep(R"(, "scene": "zhangci-2d", "question": {"answer": "eye.z"})"),
        "t.json: steps[0].question.tolerance: is missing");
    row("an unknown snap", oneStep(R"(, "scene": "zhangci-2d", "points": {"p": {"pixel": [1, 1], "snap": "corner"}})"),
        "t.json: steps[0].points.p.snap: ");
    row("half a view", oneStep(R"(, "scene": "zhangci-2d", "view": [1.5, 2])"),
        "t.json: steps[0]: \"view\" must be two whole numbers from 1 to 16384");
    row("an unknown change", oneStep(R"(, "scene": "zhangci-2d", "set": {"a": {"objects": []}})"),
        "t.json: steps[0].set.a: a link cannot change \"objects\", only \"projection\", \"view\", \"depthRange\", "
        "\"clipPlanes\", \"point\", \"ui\"");
    row("a change without a name", oneStep(R"(, "scene": "zhangci-2d", "set": {"A b": {"point": null}})"),
        "t.json: steps[0].set: \"A b\" is no name");
    row("an unknown highlight", oneStep(R"(, "scene": "zhangci-2d", "highlights": ["axes", "stars"])"),
        "t.json: steps[0].highlights: there is no highlight \"stars\"; there are \"axes\", \"volume\", \"cube\", "
        "\"viewport\"");
    row("a view beyond all numbers", oneStep(R"(, "scene": "zhangci-2d", "view": [1e12, 2])"),
        "t.json: steps[0]: \"view\" must be two whole numbers from 1 to 16384");
}

void TestLessons::aFaultNamesItsPlace()
{
    QFETCH(QByteArray, json);
    QFETCH(QByteArray, error);
    const auto lesson = parseLesson("t", json.toStdString());
    QVERIFY(!lesson);
    const QByteArray text = QByteArray::fromStdString(lesson.error().text);
    QVERIFY2(text.startsWith(error), text.constData());
}

void TestLessons::translationsMayBeIncomplete()
{
    const std::string lesson = oneStep(R"(, "source": "S", "scene": "zhangci-2d")");
    const auto translated = parseLesson("t", lesson, R"({"steps": [{"id": "a", "title": "甲"}]})");
    QVERIFY2(translated, translated ? "" : translated.error().text.c_str());
    QCOMPARE(translated->steps[0].title, std::string("甲"));
    QCOMPARE(translated->steps[0].text, std::vector<std::string>{"x"});
    QCOMPARE(*untranslated(*parseLesson("t", lesson), R"({"steps": [{"id": "a", "title": "甲"}]})"),
             (std::vector<std::string>{"title", "a.text", "a.source"}));
    const auto other = parseLesson("t", lesson, R"({"steps": [{"id": "b"}]})");
    QVERIFY(!other);
    QCOMPARE(other.error().text, std::string("t, translated: steps[0]: the lesson has no step \"b\""));
}

void TestLessons::axesAreNamed_data()
{
    QTest::addColumn<QList<double>>("offset");
    QTest::addColumn<double>("mirror");
    QTest::addColumn<QStringList>("names");
    QTest::newRow("moved and mirrored") << QList<double>{4, 3, 0} << -2.0 << QStringList{"MC", "WC", "VC"};
    QTest::newRow("at rest") << QList<double>{0, 0, 0} << 1.0 << QStringList{"MC = WC", "VC"};
}

void TestLessons::axesAreNamed()
{
    QFETCH(QList<double>, offset);
    QFETCH(double, mirror);
    QFETCH(QStringList, names);
    Scene scene;
    scene.objects.resize(2);
    scene.objects[0].name = "other";
    scene.objects[0].transform = {Translate{glm::dvec3(9, 9, 9)}};
    scene.objects[1].name = "followed";
    scene.objects[1].transform = {Translate{glm::dvec3(offset[0], offset[1], offset[2])},
                                  Scale{glm::dvec3(mirror, 1, 1)}};
    scene.givenPoint = GivenPoint{ObjectPoint(), "followed"};
    const EyeFrame eye = *eyeFrame(LookAt{WorldPoint(5, 2, 0), WorldPoint(5, 2, 1), WorldVector(0, -1, 0)});
    const std::vector<NamedAxes> axes = namedAxes(scene, eye);
    QStringList found;
    for (const NamedAxes &one : axes)
        found << QString::fromStdString(one.name);
    QCOMPARE(found, names);
    QVERIFY(axes.front().origin == WorldPoint(offset[0], offset[1], offset[2]));
    QVERIFY(axes.front().directions[0] == WorldVector(mirror < 0.0 ? -1 : 1, 0, 0)); // a unit, and still mirrored
    QVERIFY(axes.back().origin == WorldPoint(5, 2, 0));
    QVERIFY(axes.back().directions[1] == WorldVector(0, -1, 0));
    QVERIFY(axes.back().directions[2] == WorldVector(0, 0, -1)); // it looks along its own -z
}

void TestLessons::theVolumesSidesAreLettered_data()
{
    QTest::addColumn<bool>("isPerspective");
    QTest::newRow("a pyramid") << true;
    QTest::newRow("a box") << false;
}

void TestLessons::theVolumesSidesAreLettered()
{
    QFETCH(bool, isPerspective);
    const Projection projection =
        isPerspective ? Projection(Frustum{-1, 3, -2, 2, 5, 10}) : Projection(Ortho{-1, 3, -2, 2, 5, 10});
    // In the middle between near and far a pyramid of twice the depth is half as large again.
    const double share = isPerspective ? 1.5 : 1.0;
    const QMap<QString, EyePoint> wanted{{"l", EyePoint(-1 * share, 0, -7.5)},
                                         {"r", EyePoint(3 * share, 0, -7.5)},
                                         {"b", EyePoint(1 * share, -2 * share, -7.5)},
                                         {"t", EyePoint(1 * share, 2 * share, -7.5)},
                                         {"n", EyePoint(1, 0, -5)},
                                         {"f", EyePoint(isPerspective ? 2 : 1, 0, -10)}};
    for (const auto &[letter, at] : volumeLetters(projection))
        QVERIFY2(distance(at, wanted[QString::fromStdString(letter.letter)]) < 1e-12, letter.letter.c_str());
}

void TestLessons::theCubesSidesAreNumbered()
{
    QStringList found;
    for (const auto &[letter, at] : cubeLetters()) {
        QCOMPARE(std::fabs(at.x) + std::fabs(at.y) + std::fabs(at.z), 1.0);
        QCOMPARE(QString::fromStdString(letter.letter),
                 at.x + at.y + at.z < 0.0 ? QStringLiteral("−1") : QStringLiteral("1"));
        found << QStringLiteral("%1 %2 %3").arg(at.x).arg(at.y).arg(at.z);
    }
    found.removeDuplicates();
    QCOMPARE(found.size(), 6);
}

void TestLessons::theViewportIsMeasured()
{
    const auto written = [](const Viewport &viewport) {
        QStringList lines;
        for (const LetteredArrow &arrow : viewportArrows(viewport, {500, 450, 1.0}, 6.0))
            lines << QStringLiteral("%1%2 %3,%4 %5,%6")
                         .arg(arrow.letter.letter.c_str(), arrow.letter.index.c_str())
                         .arg(arrow.from.x)
                         .arg(arrow.from.y)
                         .arg(arrow.to.x)
                         .arg(arrow.to.y);
        return lines;
    };
    QCOMPARE(written({100, 40, 400, 300}),
             (QStringList{"xv 6,6 494,6", "yv 6,6 6,444", "width 100,334 500,334", "height 494,40 494,340",
                          "vx 0,190 100,190", "vy 300,0 300,40", "rect.bottom 404,450 404,0"}));
    const QStringList whole = written({0, 0, 500, 450});
    QCOMPARE(whole.filter(QStringLiteral("vx")) + whole.filter(QStringLiteral("vy")), QStringList());
}

void TestLessons::aChangeLeavesTheRest()
{
    const auto lesson = parseLesson("t", oneStep(R"(, "scene": "zhangci-perspective", "set": {
        "other": {"point": {"space": "eye", "coordinates": [0.1, 0, -5]}},
        "nearer": {"projection": {"near": 0.3}, "ui": {"clipDistancesFitObjects": false}},
        "wrong": {"projection": {"near": -2}}})"));
    QVERIFY2(lesson, lesson ? "" : lesson.error().text.c_str());
    const Step &step = lesson->steps.front();
    Scene scene = *sceneOf(step, bundledModels());
    scene.camera.eye = WorldPoint(0.1, 1.0 / 3.0, 5.0);
    std::get<Perspective>(scene.projection).verticalFovRadians = 0.8; // of which degrees have other digits
    const Picture picture = *pictureOf(scene, {800, 600, 1.0}, {});

    const SceneSettings other = *settingsWith(scene, picture, step.changes.at("other"));
    QVERIFY(other.givenPoint == (GivenPoint{EyePoint(0.1, 0, -5)}));
    QVERIFY(other.camera == scene.camera && other.projection == scene.projection);
    QCOMPARE(other.clipDistancesFitObjects, scene.clipDistancesFitObjects);

    const SceneSettings nearer = *settingsWith(scene, picture, step.changes.at("nearer"));
    QCOMPARE(std::get<Perspective>(nearer.projection).nearDistance, 0.3);
    QVERIFY(!nearer.clipDistancesFitObjects);
    QVERIFY(nearer.camera == scene.camera && nearer.givenPoint == scene.givenPoint);

    const auto wrong = settingsWith(scene, picture, step.changes.at("wrong"));
    QVERIFY(!wrong);
    const QByteArray why = QByteArray::fromStdString(wrong.error().text);
    QVERIFY2(why.contains("projection.near"), why.constData());
    // What is not there cannot be set: that nothing happens is not to be taken for the answer.
    const auto unknown = settingsWith(scene, picture, nlohmann::ordered_json::parse(R"({"projection": {"left": 1}})"));
    QVERIFY(!unknown);
    QCOMPARE(QByteArray::fromStdString(unknown.error().text), QByteArray("set: there is no projection.left"));
}

QTEST_APPLESS_MAIN(TestLessons)
#include "test_lessons.moc"
