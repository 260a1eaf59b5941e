// A lesson's questions in the window: answers are checked and shown, and panels that show them
// wait.

#include "tests/support/test.h"

#include "gui/lessons/lesson_player.h"
#include "gui/view/lifecycle_log.h"
#include "gui/view/scene_view.h"
#include "tests/gui/lessons/lessons_user.h"
#include "tests/support/patience.h"

#include <QRegularExpression>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

class TestLessonsAnswers : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void anAnswerIsChecked()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start("first"));
        QVERIFY(part<LessonPlayer>(*window).goTo(1));
        const QString shown = panelOf(*window).text();
        QVERIFY(!shown.contains(QStringLiteral("87.5")));
        QCOMPARE(verdictOf(*window), QString());
        answer(*window, QStringLiteral("17"));
        QCOMPARE(verdictOf(*window), QStringLiteral("17 is not it. Try again, or have it shown."));
        answer(*window, QStringLiteral("-87.5"));
        QCOMPARE(verdictOf(*window), QStringLiteral("−87.5 has the wrong sign. Try again, or have it shown."));
        answer(*window, QStringLiteral("500 - 412"));
        QCOMPARE(verdictOf(*window),
                 QStringLiteral("88 = 500 − 412: the pixel’s upper edge. Its centre is half a pixel lower."));
        answer(*window, QStringLiteral("87"));
        QCOMPARE(verdictOf(*window),
                 QStringLiteral("87 = 500 − 413: the pixel’s lower edge. Its centre is half a pixel higher."));
        answer(*window, QStringLiteral("412"));
        QCOMPARE(verdictOf(*window),
                 QStringLiteral("412 counts from the top. OpenGL counts from the bottom of the view, "
                                "which is 500 high."));
        QCOMPARE(panelOf(*window).text(), shown);
        answer(*window, QStringLiteral("2*"));
        QCOMPARE(verdictOf(*window), QStringLiteral("“2*” ends where a number is expected. Complete it."));
        answer(*window, QStringLiteral("500 - 412.5"));
        QCOMPARE(verdictOf(*window), QStringLiteral("Right: 87.5."));
        QVERIFY(panelOf(*window).text().contains(QStringLiteral("500 − (412 + 0.5) = 87.5")));
        QVERIFY(part<LessonPlayer>(*window).goTo(2));
        QVERIFY(verdictOf(*window).isEmpty());
    }

    void anAnswerIsShown()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start("pipeline"));
        follow(*window, QStringLiteral("step:model_view"));
        QVERIFY(!panelOf(*window).text().contains(QStringLiteral("m[14] = −8")));
        buttonOf(*window, QStringLiteral("Show"))->click();
        QCOMPARE(verdictOf(*window), QStringLiteral("It is −8."));
        QVERIFY(panelOf(*window).text().contains(QStringLiteral("m[14] = −8")));
    }

    void whatHasTheAnswerWaitsForIt()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        const auto goTo = [&](const char *id) {
            return player.goTo(std::size_t(player.lesson()->step(id) - player.lesson()->steps.data()));
        };
        const auto isSaid = [&] { return verdictOf(*window) == QStringLiteral("Answer first; then the panel opens."); };
        QVERIFY(player.start("pipeline"));
        QVERIFY(isCovered(*window, "pipeline") && isCovered(*window, "comparison"));
        QVERIFY(goTo("load_identity")); // its question belongs to another step
        QVERIFY(isSeen(*window, "pipeline") && !isCovered(*window, "pipeline") && !isSaid());
        QVERIFY(goTo("look_at"));
        QVERIFY(isSeen(*window, "pipeline") && isCovered(*window, "pipeline") && isSaid());
        answer(*window, QStringLiteral("0.5")); // which is not it
        QVERIFY(isCovered(*window, "pipeline"));
        answer(*window, QStringLiteral("0.75"));
        QVERIFY(isSeen(*window, "pipeline") && !isCovered(*window, "pipeline") && !isSaid());
        QVERIFY(goTo("model_view"));
        QVERIFY(isCovered(*window, "pipeline"));
        QTest::mouseClick(buttonOf(*window, QStringLiteral("Show")), Qt::LeftButton);
        QVERIFY(isSeen(*window, "pipeline") && !isCovered(*window, "pipeline"));
        QVERIFY(goTo("look_at")); // answered before
        QVERIFY(!isCovered(*window, "pipeline") && !isSaid());
        QVERIFY(goTo("viewport_50"));
        QVERIFY(isCovered(*window, "pipeline"));
        QVERIFY(goTo("ortho")); // never answered
        QVERIFY(!isCovered(*window, "pipeline") && isCovered(*window, "comparison"));
        QVERIFY(player.start("pipeline")); // from the beginning, without any answers
        QVERIFY(goTo("look_at"));
        QVERIFY(isCovered(*window, "pipeline"));
        QVERIFY(player.leave());
        QVERIFY(dockOf(*window, "pipeline")->isHidden() && !isCovered(*window, "pipeline"));
        QVERIFY(!isCovered(*window, "comparison") && isSeen(*window, "comparison"));
        // The first step asks nothing, but its click has the answers to those after it.
        QVERIFY(player.start("first"));
        QVERIFY(isCovered(*window, "comparison"));
        for (const QLabel *cover : dockOf(*window, "comparison")->findChildren<QLabel *>(QStringLiteral("cover")))
            QCOMPARE(cover->text(), QStringLiteral("The panel opens with the answer to step 7."));
        QVERIFY(goTo("world"));
        answer(*window, QStringLiteral("5"));
        QVERIFY(!isCovered(*window, "comparison"));
        QVERIFY(player.leave());
    }

    /// The paper's answers are hidden until the step's question is answered, in any previous state of
    /// the panels.
    void thePapersAnswersWait()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start("weng"));
        follow(*window, QStringLiteral("panel:pipeline"));
        for (const char *id : {"look_at", "viewport", "windows", "back", "world", "ortho", "oblique", "clip_plane"}) {
            follow(*window, QStringLiteral("step:") + QLatin1String(id));
            follow(*window, QStringLiteral("click:clicked"));
            QVERIFY2(isCovered(*window, "comparison") && isCovered(*window, "pipeline"), id);
            buttonOf(*window, QStringLiteral("Show"))->click();
            const bool opens = QByteArray(id) != "look_at" && QByteArray(id) != "viewport"
                               && QByteArray(id) != "windows"
                               && QByteArray(id) != "back"; // until all that is asked about the click is answered
            QVERIFY2(isCovered(*window, "comparison") != opens && isCovered(*window, "pipeline") != opens, id);
            QVERIFY2(isSeen(*window, "pipeline"), id); // in front, as before
        }
    }

    void theEndCountsTheAnswers()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("first"));
        QVERIFY(player.goTo(1));
        answer(*window, QStringLiteral("87.5")); // at once
        QVERIFY(player.goTo(3));
        answer(*window, QStringLiteral("1"));
        answer(*window, QStringLiteral("-0.55"));           // later
        buttonOf(*window, QStringLiteral("Show"))->click(); // it was found before
        QVERIFY(player.goTo(4));
        buttonOf(*window, QStringLiteral("Show"))->click(); // shown
        answer(*window, QStringLiteral("20"));
        QVERIFY(player.goTo(6));
        buttonOf(*window, QStringLiteral("Finish"))->click();
        QVERIFY(player.lesson()); // its scene is still there
        const QString text = panelOf(*window).text();
        const auto says = [&](const char *name, int count) {
            return text.contains(QRegularExpression(QStringLiteral("%1\\s+%2\\b").arg(QLatin1String(name)).arg(count)));
        };
        QVERIFY2(says("Questions", 5) && says("Right with the first answer", 1) && says("Right with a later answer", 1)
                     && says("Shown", 1) && says("Not answered", 2),
                 qPrintable(text));
        QVERIFY(!panelOf(*window).findChild<QLineEdit *>()->isVisible());
        buttonOf(*window, QStringLiteral("‹ Back"))->click();
        QCOMPARE(player.index(), std::size_t(6));
        QVERIFY(panelOf(*window).findChild<QLineEdit *>()->isVisible());
        buttonOf(*window, QStringLiteral("Finish"))->click();
        buttonOf(*window, QStringLiteral("Next lesson ›"))->click();
        QCOMPARE(player.lesson()->name, std::string("weng"));
        QCOMPARE(player.index(), std::size_t(0));
        QCOMPARE(player.tally().atOnce + player.tally().later + player.tally().shown, 0);
    }

    void theLastLessonEndsBeforeAScene()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        const QString name = window->session().name();
        QVERIFY(player.start(player.lessons().back().name));
        QVERIFY(player.goTo(player.lesson()->steps.size() - 1));
        buttonOf(*window, QStringLiteral("Finish"))->click();
        QVERIFY(!buttonOf(*window, QStringLiteral("Next lesson ›"))->isVisible());
        buttonOf(*window, QStringLiteral("Leave"))->click();
        QVERIFY(!player.lesson());
        QCOMPARE(window->session().name(), name);

        MainWindow::Options options;
        options.remembers = false;
        MainWindow empty(options); // no scene was shown before the lesson
        bringUp(empty);
        QVERIFY(part<LessonPlayer>(empty).start("first"));
        QVERIFY(part<LessonPlayer>(empty).goTo(6));
        buttonOf(empty, QStringLiteral("Finish"))->click();
        buttonOf(empty, QStringLiteral("Leave"))->click();
        QVERIFY(!part<LessonPlayer>(empty).lesson() && !empty.document().objects().empty());
    }

    /// The lesson and the panel with the answer are tabs of one column in a narrow window.
    void theReasonStaysInFront()
    {
        const int digit =
            QFontMetrics(QApplication::font()).horizontalAdvance(u'0'); // narrowness is measured in digits
        const auto window = windowOfSize({100 * digit, 700});
        QVERIFY(part<LessonPlayer>(*window).start("weng"));
        follow(*window, QStringLiteral("step:look_at"));
        QVERIFY(isSeen(*window, "lesson"));
        buttonOf(*window, QStringLiteral("Show"))->click();
        QVERIFY(!dockOf(*window, "comparison")->isHidden() && !isSeen(*window, "comparison"));
        QVERIFY(isSeen(*window, "lesson"));
    }

    /// The steps on MFC ask for the entries that Life of the View lists.
    void theViewIsCalledAsThePaperSays()
    {
        const auto window = windowOfSize(kWide);
        const auto *log = window->findChild<LifecycleLog *>();
        QVERIFY(log);
        const auto calls = [log](int first) { return log->text(first, log->rowCount() - 1); };
        QVERIFY(part<LessonPlayer>(*window).start("weng"));
        follow(*window, QStringLiteral("step:mfc"));
        QVERIFY(isCovered(*window, "lifecycle"));
        answer(*window, QStringLiteral("5"));
        QVERIFY(isCovered(*window, "lifecycle"));
        answer(*window, QStringLiteral("4"));
        QVERIFY(isSeen(*window, "lifecycle") && !isCovered(*window, "lifecycle"));

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
        QCOMPARE(stretch(), part<LessonPlayer>(*window).asked()->answer);
        follow(*window, QStringLiteral("set:follows"));
        QCOMPARE(stretch(), 1.0);
        QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));

        follow(*window, QStringLiteral("step:mfc_click"));
        emit hintOf(*window)->linkActivated(QStringLiteral("restart:"));
        follow(*window, QStringLiteral("view:500x500"));
        QTRY_VERIFY_WITH_TIMEOUT(part<LessonPlayer>(*window).hasViewOfStep(), kPatienceMilliseconds);
        QVERIFY(isCovered(*window, "lifecycle"));
        follow(*window, QStringLiteral("click:clicked"));
        QVERIFY2(calls(0).contains(
                     QStringLiteral("glReadPixels(230, %1, 1, 1,").arg(part<LessonPlayer>(*window).asked()->answer)),
                 qPrintable(calls(0)));
    }
};

UNPROJECTOR_TEST(TestLessonsAnswers, display)
#include "test_lessons_answers.moc"
