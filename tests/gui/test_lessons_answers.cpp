// What a lesson asks in the window: answers are checked and shown, and what has them waits.

#include "gui/lessons/lesson_player.h"
#include "gui/view/lifecycle_log.h"
#include "gui/view/scene_view.h"
#include "lessons_user.h"
#include "tests/support/patience.h"

#include <QTest>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

class TestLessonsAnswers : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void anAnswerIsChecked();
    void anAnswerIsShown();
    void whatHasTheAnswerWaitsForIt();
    void thePapersAnswersWait();
    void theReasonStaysInFront();
    void theViewIsCalledAsThePaperSays();
};

void TestLessonsAnswers::anAnswerIsChecked()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(part<LessonPlayer>(*window).start("first"));
    QVERIFY(part<LessonPlayer>(*window).goTo(1));
    const QString shown = panelOf(*window).text();
    QVERIFY(!shown.contains(QStringLiteral("312.5")));
    answer(*window, QStringLiteral("312"));
    QCOMPARE(verdictOf(*window), QStringLiteral("312 is not it. Try again, or have it shown."));
    answer(*window, QStringLiteral("-312.5"));
    QCOMPARE(verdictOf(*window), QStringLiteral("−312.5 has the wrong sign. Try again, or have it shown."));
    QCOMPARE(panelOf(*window).text(), shown);
    answer(*window, QStringLiteral("2*"));
    QCOMPARE(verdictOf(*window), QStringLiteral("“2*” ends where a number is wanted."));
    answer(*window, QStringLiteral("500 - 187.5"));
    QCOMPARE(verdictOf(*window), QStringLiteral("Right: 312.5."));
    QVERIFY(panelOf(*window).text().contains(QStringLiteral("500 − (187 + 0.5) = 312.5")));
    QVERIFY(part<LessonPlayer>(*window).goTo(2));
    QVERIFY(verdictOf(*window).isEmpty());
}

void TestLessonsAnswers::anAnswerIsShown()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(part<LessonPlayer>(*window).start("pipeline"));
    follow(*window, QStringLiteral("step:model_view"));
    QVERIFY(!panelOf(*window).text().contains(QStringLiteral("m[14] = −8")));
    buttonOf(*window, QStringLiteral("Show"))->click();
    QCOMPARE(verdictOf(*window), QStringLiteral("It is −8."));
    QVERIFY(panelOf(*window).text().contains(QStringLiteral("m[14] = −8")));
}

void TestLessonsAnswers::whatHasTheAnswerWaitsForIt()
{
    const auto window = windowOfSize(kWide);
    LessonPlayer &player = part<LessonPlayer>(*window);
    const auto goTo = [&](const char *id) {
        return player.goTo(std::size_t(player.lesson()->step(id) - player.lesson()->steps.data()));
    };
    const auto isSaid = [&] { return panelOf(*window).text().contains(QStringLiteral("Panels that show the answer")); };
    QVERIFY(player.start("pipeline"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden() && isSaid());
    QVERIFY(goTo("load_identity")); // what it asks is of another step
    QVERIFY(isSeen(*window, "pipeline") && !isSaid());
    QVERIFY(goTo("look_at"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden() && isSaid());
    answer(*window, QStringLiteral("0.5")); // which is not it
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    answer(*window, QStringLiteral("0.75"));
    QVERIFY(isSeen(*window, "pipeline") && !isSaid());
    QVERIFY(goTo("model_view"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    QTest::mouseClick(buttonOf(*window, QStringLiteral("Show")), Qt::LeftButton);
    QVERIFY(isSeen(*window, "pipeline"));
    QVERIFY(goTo("viewport_50"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    QVERIFY(goTo("ortho")); // never answered
    QVERIFY(!dockOf(*window, "pipeline")->isHidden() && dockOf(*window, "comparison")->isHidden());
    QVERIFY(player.leave());
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    QVERIFY(player.start("first"));
    QVERIFY(!dockOf(*window, "comparison")->isHidden());
    QVERIFY(player.next()); // asks for what it shows
    QVERIFY(dockOf(*window, "comparison")->isHidden());
    QVERIFY(player.next());
    QVERIFY(isSeen(*window, "comparison"));
    QVERIFY(player.leave());
    // The user's own stays the user's.
    window->workspaces().show(Panel::Pipeline);
    QVERIFY(player.start("pipeline"));
    QVERIFY(dockOf(*window, "pipeline")->isHidden());
    QVERIFY(player.leave());
    QVERIFY(isSeen(*window, "pipeline"));
}

/// Whatever else was shown, what a step of the paper asks is not in sight before it is answered.
void TestLessonsAnswers::thePapersAnswersWait()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(part<LessonPlayer>(*window).start("weng"));
    follow(*window, QStringLiteral("panel:pipeline"));
    for (const char *id : {"look_at", "viewport", "windows", "back", "world", "ortho", "oblique", "clip_plane"}) {
        follow(*window, QStringLiteral("step:") + QLatin1String(id));
        follow(*window, QStringLiteral("click:clicked"));
        QVERIFY2(dockOf(*window, "comparison")->isHidden() && dockOf(*window, "pipeline")->isHidden(), id);
        buttonOf(*window, QStringLiteral("Show"))->click();
        QVERIFY2(!dockOf(*window, "comparison")->isHidden() && isSeen(*window, "pipeline"), id); // as before in front
    }
}

/// In a narrow window the lesson and the panel that has the answer are tabs of one column.
void TestLessonsAnswers::theReasonStaysInFront()
{
    const int digit = QFontMetrics(QApplication::font()).horizontalAdvance(u'0'); // what is narrow goes by it
    const auto window = windowOfSize({100 * digit, 700});
    QVERIFY(part<LessonPlayer>(*window).start("weng"));
    follow(*window, QStringLiteral("step:look_at"));
    QVERIFY(isSeen(*window, "lesson"));
    buttonOf(*window, QStringLiteral("Show"))->click();
    QVERIFY(!dockOf(*window, "comparison")->isHidden() && !isSeen(*window, "comparison"));
    QVERIFY(isSeen(*window, "lesson"));
}

/// The steps on MFC: what they ask is what Life of the View writes down.
void TestLessonsAnswers::theViewIsCalledAsThePaperSays()
{
    const auto window = windowOfSize(kWide);
    const auto *log = window->findChild<LifecycleLog *>();
    QVERIFY(log);
    const auto calls = [log](int first) { return log->text(first, log->rowCount() - 1); };
    QVERIFY(part<LessonPlayer>(*window).start("weng"));
    follow(*window, QStringLiteral("step:mfc"));
    QVERIFY(dockOf(*window, "lifecycle")->isHidden());
    answer(*window, QStringLiteral("5"));
    QVERIFY(dockOf(*window, "lifecycle")->isHidden());
    answer(*window, QStringLiteral("4"));
    QVERIFY(isSeen(*window, "lifecycle"));

    follow(*window, QStringLiteral("step:mfc_size"));
    follow(*window, QStringLiteral("view:500x500"));
    QTRY_VERIFY_WITH_TIMEOUT(part<LessonPlayer>(*window).hasViewOfStep(), kPatienceMilliseconds);
    settle(*window);
    const int before = log->rowCount();
    follow(*window, QStringLiteral("view:500x250"));
    QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), QSize(500, 250), kPatienceMilliseconds);
    QTRY_VERIFY_WITH_TIMEOUT(calls(before).contains(QStringLiteral("OnSize(500, 250)\tglViewport(0, 0, 500, 250)")),
                             kPatienceMilliseconds);
    QTRY_VERIFY_WITH_TIMEOUT(calls(before).lastIndexOf(QStringLiteral("OnDraw"))
                                 > calls(before).lastIndexOf(QStringLiteral("OnSize")),
                             kPatienceMilliseconds);
    QVERIFY2(calls(before).section(u'\n', 0, 0).contains(QStringLiteral("OnSize")), qPrintable(calls(before)));
    const auto stretch = [&] { // of a square
        const Setup &g = window->document().setup();
        const ProjectionWindow w = projectionWindow(g.projection());
        return g.viewport.width / (w.right - w.left) / (g.viewport.height / (w.top - w.bottom));
    };
    QCOMPARE(stretch(), *part<LessonPlayer>(*window).answer());
    follow(*window, QStringLiteral("set:follows"));
    QCOMPARE(stretch(), 1.0);
    QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));

    follow(*window, QStringLiteral("step:mfc_click"));
    emit hintOf(*window)->linkActivated(QStringLiteral("restart:"));
    follow(*window, QStringLiteral("view:500x500"));
    QTRY_VERIFY_WITH_TIMEOUT(part<LessonPlayer>(*window).hasViewOfStep(), kPatienceMilliseconds);
    QVERIFY(dockOf(*window, "lifecycle")->isHidden());
    follow(*window, QStringLiteral("click:clicked"));
    QVERIFY2(
        calls(0).contains(QStringLiteral("glReadPixels(230, %1, 1, 1,").arg(*part<LessonPlayer>(*window).answer())),
        qPrintable(calls(0)));
}

QTEST_MAIN(TestLessonsAnswers)
#include "test_lessons_answers.moc"
