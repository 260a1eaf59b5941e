// The bundled lessons, every step in both languages: each number of a text is the one that the
// program computes, and each link leads somewhere.

#include "tests/support/test.h"

#include "core/lessons/lesson.h"
#include "core/lessons/set_link.h"
#include "core/lessons/step_numbers.h"
#include "tests/core/lessons/lesson_texts.h"
#include "tests/core/lessons/statements.h"
#include "tests/support/errata.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::lessons;
using namespace lessontexts;
using namespace unprojector::scene;

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
        qFatal("%s", listed.error().message().c_str());
    return *listed;
}

Lesson lessonOf(const QString &name, bool isTranslated)
{
    const auto lesson = isTranslated ? parseLesson(name.toStdString(), fileText(name + QStringLiteral(".json")),
                                                   fileText(name + QStringLiteral("_zh_CN.json")))
                                     : parseLesson(name.toStdString(), fileText(name + QStringLiteral(".json")));
    if (!lesson)
        qFatal("%s", lesson.error().message().c_str());
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

/// The targets of a step's links.
QStringList linksOf(const Step &step)
{
    static const QRegularExpression link(QStringLiteral("<a href='([^']*)'>"));
    QStringList links;
    for (auto it = link.globalMatch(allOf(step)); it.hasNext();)
        links << it.next().captured(1);
    links.sort();
    return links;
}

} // namespace

class TestLessons : public QObject {
    Q_OBJECT

private slots:
    void allFilesAreListed()
    {
        QStringList wanted{QStringLiteral("lessons.json")};
        for (const std::string &name : names())
            wanted << QString::fromStdString(name) + QStringLiteral(".json")
                   << QString::fromStdString(name) + QStringLiteral("_zh_CN.json");
        wanted.sort();
        QCOMPARE(QDir(kFolder).entryList(QDir::Files, QDir::Name), wanted);
    }

    void everyNumberIsThePrograms_data()
    {
        addColumn<QString>("name");
        addColumn<bool>("isTranslated");
        for (const std::string &name : names()) {
            addRow("%s", name.c_str()) << QString::fromStdString(name) << false;
            addRow("%s, Chinese", name.c_str()) << QString::fromStdString(name) << true;
        }
    }

    void everyNumberIsThePrograms()
    {
        QFETCH(QString, name);
        QFETCH(bool, isTranslated);
        const Lesson lesson = lessonOf(name, isTranslated);
        for (const Surface &surface : {Surface{800, 600, 1.0}, Surface{1333, 900, 1.25}}) {
            const auto numbers = LessonNumbers::of(lesson, surface);
            QVERIFY2(numbers, numbers ? "" : numbers.error().message().c_str());
            for (const Step &step : lesson.steps) {
                const QString faults = written(faultsOf(*numbers, step));
                QVERIFY2(faults.isEmpty(), qPrintable(faults));
            }
        }
    }

    void everyTextIsTranslated_data() { lessonRows(); }

    void everyTextIsTranslated()
    {
        QFETCH(QString, name);
        const Lesson english = lessonOf(name, false), chinese = lessonOf(name, true);
        const auto missing =
            untranslated(fileText(name + QStringLiteral(".json")), fileText(name + QStringLiteral("_zh_CN.json")));
        QVERIFY2(missing.empty(), qPrintable(written(missing)));
        for (std::size_t i = 0; i < english.steps.size(); ++i) {
            QCOMPARE(linksOf(chinese.steps[i]), linksOf(english.steps[i]));
            QCOMPARE(chinese.steps[i].text.size(), english.steps[i].text.size());
        }
    }

    void noChineseIsSlanted_data() { lessonRows(); }

    /// Chinese fonts have no italics: slanted by the program, the characters look deformed.
    void noChineseIsSlanted()
    {
        QFETCH(QString, name);
        static const QRegularExpression slanted(
            QStringLiteral("<(i|em)>(?:(?!</\\1>).)*[\\x{3400}-\\x{9fff}].*?</\\1>"));
        for (const Step &step : lessonOf(name, true).steps) {
            const QString found = slanted.match(allOf(step)).captured();
            QVERIFY2(found.isEmpty(), qPrintable(found));
        }
    }

    void everyNameIsUsable_data() { lessonRows(); }

    /// A point's name must not hide what a path can name already.
    void everyNameIsUsable()
    {
        QFETCH(QString, name);
        static const QRegularExpression plain(QStringLiteral("^[a-z][a-z0-9_]*$"));
        const QStringList taken = QStringLiteral("scene model view projection viewport modelview whole object world "
                                                 "eye clip ndc window device widget pixel formula inverse point "
                                                 "surface set pi sqrt deg rad")
                                      .split(QLatin1Char(' '));
        const QStringList settable =
            QStringLiteral("projection view depthRange clipPlanes point ui").split(QLatin1Char(' '));
        for (const Step &step : lessonOf(name, false).steps) {
            const QString id = QString::fromStdString(step.id);
            QVERIFY2(plain.match(id).hasMatch() && !step.title.empty() && !step.text.empty(), qPrintable(id));
            QVERIFY2(!step.question || step.question->tolerance > 0.0, qPrintable(id));
            for (const auto &[key, point] : step.points) {
                const QString own = QString::fromStdString(key);
                QVERIFY2(plain.match(own).hasMatch() && !taken.contains(own), qPrintable(id + ": " + own));
            }
            for (const auto &[key, change] : step.changes) {
                QVERIFY2(plain.match(QString::fromStdString(key)).hasMatch(), key.c_str());
                for (const auto &[member, value] : change.json().items())
                    QVERIFY2(settable.contains(QString::fromStdString(member)), member.c_str());
            }
        }
    }

    void everyLinkLeadsSomewhere_data() { lessonRows(); }

    void everyLinkLeadsSomewhere()
    {
        QFETCH(QString, name);
        const Lesson lesson = lessonOf(name, false);
        const auto numbers = LessonNumbers::of(lesson, {800, 600, 1.0});
        QVERIFY(numbers);
        for (const Step &step : lesson.steps) {
            for (const QString &link : linksOf(step)) {
                const std::string where = (step.id + ": " + link.toStdString());
                const std::string to = link.section(QLatin1Char(':'), 1).toStdString();
                QVERIFY2(parseLink(link.toStdString()), where.c_str());
                if (link.startsWith(QLatin1String("step:")))
                    QVERIFY2(lesson.step(to), where.c_str());
                else if (link.startsWith(QLatin1String("click:")))
                    QVERIFY2(numbers->step(step.id).pixelOf(to), where.c_str());
                else if (link.startsWith(QLatin1String("set:"))) {
                    QVERIFY2(step.changes.contains(to), where.c_str());
                    // The change gives the same point, independent of an earlier typed point.
                    const Scene opened = *sceneOf(step);
                    const std::optional<GivenPoint> none,
                        clip = GivenPoint{ClipPoint(2, 3, 4, 5)}, world = GivenPoint{WorldPoint(1, 2, 3)},
                        object = GivenPoint{ObjectPoint(4, 5, 6), opened.objects[0].name};
                    std::optional<GivenPoint> made;
                    for (const auto &before : {opened.givenPoint, none, clip, world, object}) {
                        Scene scene = opened;
                        scene.givenPoint = before;
                        const Surface surface{800, 600, 1.0};
                        const base::JsonValue &change = step.changes.at(to);
                        const auto changed = settingsWith(scene, *setupOf(scene, surface, {}), change);
                        QVERIFY2(changed, changed ? "" : changed.error().message().c_str());
                        static_cast<SceneSettings &>(scene) = *changed;
                        QVERIFY2(setupOf(scene, surface, {}), where.c_str());
                        if (!change.json().contains("point"))
                            made = before;
                        else if (!made)
                            made = scene.givenPoint;
                        QVERIFY2(scene.givenPoint == made, where.c_str());
                    }
                } else
                    QVERIFY2(
                        link.startsWith(QLatin1String("formulas:")) || link.startsWith(QLatin1String("panel:"))
                            || link.startsWith(QLatin1String("place:")) || link.startsWith(QLatin1String("view:"))
                            || link.startsWith(QLatin1String("action:")) // named in the window, where they are tried
                            || link == QLatin1String("apart:view") || link == QLatin1String("apart:projection"),
                        where.c_str());
            }
        }
    }

    void everyFormulaOfThePaperHasItsNumbers_data()
    {
        addColumn<QString>("anchor");
        for (int i = 1; i <= 12; ++i)
            addRow("(%d)", i) << QStringLiteral("w%1").arg(i);
        newRow("(13)") << QStringLiteral("z-perspective");
        newRow("(14)") << QStringLiteral("z-ortho");
        newRow("(15)") << QStringLiteral("shear");
        newRow("(16)") << QStringLiteral("eye-to-world");
    }

    /// The paragraph continues after the link with an equation whose numbers are computed.
    void everyFormulaOfThePaperHasItsNumbers()
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

    void everyErrorIsTold_data()
    {
        addColumn<QString>("anchor");
        for (const char *anchor : kErrata)
            newRow(anchor) << QString::fromLatin1(anchor);
    }

    /// A fitting step leads to each error of the originals in Help.
    void everyErrorIsTold()
    {
        QFETCH(QString, anchor);
        bool isTold = false;
        for (const std::string &name : names()) {
            for (const Step &step : lessonOf(QString::fromStdString(name), false).steps)
                isTold = isTold || linksOf(step).contains(QStringLiteral("formulas:") + anchor);
        }
        QVERIFY(isTold);
    }

private:
    static void lessonRows()
    {
        addColumn<QString>("name");
        for (const std::string &name : names())
            newRow(name.c_str()) << QString::fromStdString(name);
    }
};

UNPROJECTOR_TEST(TestLessons)
#include "test_lessons.moc"
