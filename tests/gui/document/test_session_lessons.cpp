// A lesson over a session without a window: the fate of the scene shown before it.

#include "tests/support/test.h"

#include "gui/lessons/lesson_player.h"
#include "tests/gui/document/session_desk.h"
#include "tests/support/patience.h"

#include <QSignalSpy>
#include <QStandardPaths>
#include <QTranslator>

using namespace sessions;
using namespace unprojector::gui;
using namespace unprojector::scene;

namespace {

/// A language whose lessons cannot be read: its lesson texts are a file that holds something else.
class BrokenTexts : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char *, const char *source, const char *, int) const override
    {
        return qstrcmp(source, "%1.json") == 0 ? QStringLiteral("%1/../lessons.json") : QString();
    }
};

} // namespace

class TestSessionLessons : public QObject, protected FolderUser {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("unprojector-test-session-lessons"));
    }
    void init() { changeFolder(); }

    void aLessonAsksNothingAndLosesNothing()
    {
        const auto desk = this->desk();
        desk->session.openBundledScene();
        desk->cut();
        const QStringList names = desk->names();
        LessonPlayer player(desk->document, desk->session);
        desk->session.openFiles({pathOf(file(QStringLiteral("triangle.obj")))});
        QVERIFY(player.start("pipeline"));
        QVERIFY(!desk->session.isLoading()); // it would replace the step
        QVERIFY(!desk->session.hasUnsavedChanges());
        desk->cut(0.25);
        QVERIFY(player.next() && player.leave());
        QCOMPARE(desk->names(), names);
        QCOMPARE(desk->document.scene().clipPlanes.at(0).w, 0.5);
        QVERIFY(desk->session.hasUnsavedChanges());
        QVERIFY(desk->answers.asked.isEmpty());
        desk->session.end();
    }

    void theSceneBehindALessonIsAskedAbout_data() { waysToLeave(); }

    void theSceneBehindALessonIsAskedAbout()
    {
        QFETCH(Step, step);
        const auto desk = this->desk();
        desk->session.openBundledScene();
        desk->cut();
        LessonPlayer player(desk->document, desk->session);
        QVERIFY(player.start("pipeline") && player.next());
        desk->cut(0.25);
        const QStringList names = desk->names();
        step(*desk);
        QCOMPARE(desk->answers.asked, QStringList(QStringLiteral("save Bundled scene")));
        // A user who cancels stays in place, and the scene is still behind the lesson.
        QVERIFY(player.lesson());
        QCOMPARE(player.index(), std::size_t(1));
        QCOMPARE(desk->names(), names);
        QCOMPARE(desk->document.scene().clipPlanes.at(0).w, 0.25);
        QVERIFY(kept() > 0);
        QVERIFY(player.leave());
        QCOMPARE(desk->document.scene().clipPlanes.at(0).w, 0.5);
        QVERIFY(desk->session.hasUnsavedChanges());

        desk->answers.asked.clear();
        desk->answers.save = SessionQuestions::SaveAnswer::Discard;
        QVERIFY(player.start("pipeline"));
        step(*desk);
        QCOMPARE(desk->answers.asked.size(), 1);
        desk->session.end();
        QCOMPARE(kept(), 0);

        // The session asks nothing and brings nothing back without unsaved changes.
        desk->session.openBundledScene();
        desk->answers.asked.clear();
        QVERIFY(player.start("pipeline"));
        desk->cut(0.25);
        step(*desk);
        QVERIFY(desk->answers.asked.isEmpty());
        desk->session.end();
    }

    void theSceneBehindALessonIsSaved_data() { waysToLeave(); }

    void theSceneBehindALessonIsSaved()
    {
        QFETCH(Step, step);
        const auto desk = this->desk();
        desk->session.openBundledScene();
        desk->cut();
        const QStringList names = desk->names();
        LessonPlayer player(desk->document, desk->session);
        QVERIFY(player.start("pipeline"));
        desk->answers.save = SessionQuestions::SaveAnswer::Save;
        step(*desk); // no name is given
        QCOMPARE(desk->answers.asked,
                 QStringList({QStringLiteral("save Bundled scene"), QStringLiteral("name scene.json")}));
        QVERIFY(!player.lesson());
        QCOMPARE(desk->names(), names);
        QVERIFY(desk->session.hasUnsavedChanges());

        QVERIFY(player.start("pipeline"));
        desk->answers.fileName = pathOf(file(QStringLiteral("mine.json")));
        step(*desk);
        QVERIFY2(read(file(QStringLiteral("mine.json"))).contains("0.5"), "the scene's plane");
        QVERIFY(!player.lesson());
        QVERIFY(!desk->session.hasUnsavedChanges());
        desk->session.end();
    }

    void theSceneBehindALessonIsKeptInCaseOfACrash()
    {
        {
            const auto crashed = desk();
            crashed->session.openBundledScene();
            crashed->cut();
            LessonPlayer player(crashed->document, crashed->session);
            QVERIFY(player.start("pipeline"));
        }
        const auto desk = this->desk();
        desk->session.offerRecovery();
        QCOMPARE(desk->session.offered().size(), std::size_t(1));
        QCOMPARE(desk->session.offered()[0].name, QStringLiteral("Bundled scene"));
        desk->session.recover(0);
        QTRY_COMPARE_WITH_TIMEOUT(desk->document.scene().clipPlanes.size(), std::size_t(1), kPatienceMilliseconds);
        // It goes with the scene, there and back, and ends with it.
        const int files = kept();
        QVERIFY(files > 0);
        LessonPlayer player(desk->document, desk->session);
        QVERIFY(player.start("pipeline"));
        QVERIFY(kept() == files);
        QVERIFY(player.leave());
        QVERIFY(kept() == files);
        QVERIFY(player.start("pipeline"));
        desk->answers.save = SessionQuestions::SaveAnswer::Discard;
        QVERIFY(desk->session.mayLeave());
        desk->session.end();
        QVERIFY(kept() == 0);
    }

    void changesThatCannotBeKeptAreToldAgain()
    {
        const QString inTheWay = write(QStringLiteral("recovery"), "a file, where the folder is to be");
        const auto desk = this->desk();
        desk->session.openBundledScene();
        desk->cut();
        QTRY_COMPARE_WITH_TIMEOUT(desk->warnings.size(), 1, kPatienceMilliseconds); // once, however often it fails
        QVERIFY2(desk->warnings[0].startsWith(QStringLiteral("Unsaved changes are not protected from a crash"))
                     && desk->warnings[0].contains(QDir::toNativeSeparators(inTheWay)),
                 qPrintable(desk->warnings[0]));
        LessonPlayer player(desk->document, desk->session);
        QVERIFY(player.start("pipeline"));
        QCOMPARE(desk->warnings.size(), 2); // no retry as long as the scene is behind the lesson
        QVERIFY(player.next() && player.leave());
        QVERIFY(QFile::remove(inTheWay));
        QVERIFY(player.start("pipeline")); // and now it is tried
        QCOMPARE(desk->warnings.size(), 2);
        QVERIFY(kept() > 0);
        QVERIFY(player.leave());
        QVERIFY(desk->session.hasUnsavedChanges());
        desk->session.end();
        QCOMPARE(kept(), 0);
    }

    void aStepThatCannotBeShownLeavesTheChangesKept()
    {
        const QString inTheWay = write(QStringLiteral("recovery"), "a file, where the folder is to be");
        const auto desk = this->desk();
        desk->session.openBundledScene();
        desk->cut();
        Scene step = desk->document.scene();
        step.camera = {step.camera->center, step.camera->center, step.camera->up};
        QVERIFY(!desk->session.openLesson(step, QStringLiteral("Step"), QStringLiteral("rows")));
        QCOMPARE(desk->warnings.size(), 1);
        QVERIFY(QFile::remove(inTheWay));
        QTRY_VERIFY_WITH_TIMEOUT(kept() > 0, kPatienceMilliseconds);
        desk->session.end();
    }

    void lessonsThatCannotBeReadAreLeftOut()
    {
        const auto desk = this->desk();
        LessonPlayer player(desk->document, desk->session);
        const QSignalSpy failures(&player, &LessonPlayer::failed);
        BrokenTexts texts;
        QVERIFY(QCoreApplication::installTranslator(&texts));
        QVERIFY(player.lessons().empty() && !player.start("pipeline"));
        QVERIFY(failures.size() > 1);
    }

private:
    void waysToLeave()
    {
        addColumn<Step>("step");
        newRow("bundled scene") << Step([](Desk &d) { d.session.openBundledScene(); });
        newRow("model") << Step([this](Desk &d) { d.openAndWait({file(QStringLiteral("triangle.obj"))}); });
        newRow("scene") << Step([this](Desk &d) { d.openAndWait({writeScene(QStringLiteral("scene.json"))}); });
        newRow("closing") << Step([](Desk &d) {
            if (d.session.mayLeave())
                d.session.end();
        });
    }
};

UNPROJECTOR_TEST(TestSessionLessons)
#include "test_session_lessons.moc"
