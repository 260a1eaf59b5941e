// Lessons in the window: from step to step, and the return of everything shown before them.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/lessons/first_steps.h"
#include "gui/lessons/lesson_player.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/view/scene_view.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/lessons/lessons_user.h"
#include "tests/support/patience.h"

#include <QComboBox>
#include <QSettings>
#include <QSignalSpy>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;
using namespace unprojector::mesh;
using namespace unprojector::scene;

class TestLessonsWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void whatIsDoneStaysInTheSameScene()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("first"));
        follow(*window, QStringLiteral("view:500x500"));
        QTRY_VERIFY_WITH_TIMEOUT(player.hasViewOfStep(), kPatienceMilliseconds);
        QVERIFY(!hintOf(*window));
        follow(*window, QStringLiteral("click:clicked"));
        QVERIFY(window->document().picks().pick());
        QVERIFY(player.goTo(1));
        QVERIFY(window->document().picks().pick());
        QCOMPARE(window->session().name(), QStringLiteral("Window Coordinates"));
        QVERIFY(window->windowTitle().contains(window->session().name()));
        LookAt turned = window->document().scene().camera;
        turned.eye = turned.eye + WorldVector(1, 0, 0);
        setCamera(window->document(), turned);
        QVERIFY(!player.isAsTheStep());
        QVERIFY(hintOf(*window));
        emit hintOf(*window)->linkActivated(QStringLiteral("restart:"));
        QVERIFY(player.isAsTheStep());
        QVERIFY(!hintOf(*window));
        QVERIFY(player.goTo(2));
    }

    void whatWasShownComesBack()
    {
        const auto window = windowOfSize(kLow);
        SceneDocument &document = window->document();
        window->workspaces().enter(Workspace::Landmarks);
        QVERIFY(editClipPlanes(document, {{0.0, 1.0, 0.0, 0.5}}, {}, {QStringLiteral("Plane")}));
        const QString name = window->session().name();
        const Model *model = document.objects().front().model.get();
        const QSize size = window->size();
        QVERIFY(part<LessonPlayer>(*window).start("first"));
        QVERIFY(window->workspaces().current() == Workspace::Click);
        const auto height = heightToGrowFor(*window);
        if (!height)
            QSKIP("The screen is too low for a view that the window grows for.");
        follow(*window, QStringLiteral("view:300x%1").arg(*height));
        QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), QSize(300, *height), kPatienceMilliseconds);
        QVERIFY(window->size() != size);
        QVERIFY(window->session().name() != name);
        follow(*window, QStringLiteral("panel:pipeline"));
        QVERIFY(isSeen(*window, "pipeline"));
        window->workspaces().enter(Workspace::Pipeline); // which has the panel as its own
        dockOf(*window, "lesson")->close();
        QVERIFY(!part<LessonPlayer>(*window).lesson());
        QVERIFY(dockOf(*window, "lesson")->isHidden());
        QCOMPARE(window->session().name(), name);
        QCOMPARE(document.objects().front().model.get(), model);
        QCOMPARE(document.scene().clipPlanes.size(), std::size_t(1));
        QVERIFY(window->session().hasUnsavedChanges());
        QVERIFY(window->workspaces().current() == Workspace::Landmarks);
        QCOMPARE(window->size(), size);
        window->workspaces().enter(Workspace::Click);
        QVERIFY(dockOf(*window, "pipeline")->isHidden());
        window->workspaces().enter(Workspace::Pipeline);
        QVERIFY(!dockOf(*window, "pipeline")->isHidden());
    }

    void whatCannotBeShownLeavesTheSceneThere()
    {
        const auto window = windowOfSize(kWide);
        const QString name = window->session().name();
        Scene step = window->document().scene();
        step.camera = {step.camera->center, step.camera->center, step.camera->up};
        QVERIFY(!window->session().openLesson(step, QStringLiteral("other"), QStringLiteral("rows")));
        QCOMPARE(window->session().name(), name);
        QVERIFY(!window->message().isEmpty());
    }

    void aClosedWindowIsAsBeforeTheLesson()
    {
        QSize size;
        {
            const auto window = windowOfSize(kLow, true);
            window->resize(kLow);
            window->workspaces().enter(Workspace::Landmarks);
            size = window->size();
            QVERIFY(part<LessonPlayer>(*window).start("first"));
            const auto height = heightToGrowFor(*window);
            if (!height)
                QSKIP("The screen is too low for a view that the window grows for.");
            follow(*window, QStringLiteral("view:400x%1").arg(*height));
            QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), QSize(400, *height), kPatienceMilliseconds);
            QVERIFY(window->size() != size);
            follow(*window, QStringLiteral("panel:pipeline"));
            QVERIFY(window->close());
        }
        const auto window = windowOfSize(kWide, true);
        QCOMPARE(window->size(), size);
        QVERIFY(window->workspaces().current() == Workspace::Landmarks);
        QVERIFY(dockOf(*window, "lesson")->isHidden());
        window->workspaces().enter(Workspace::Click);
        QVERIFY(dockOf(*window, "pipeline")->isHidden());
    }

    void anotherSceneEndsTheLesson()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start("rows"));
        const QSignalSpy changes(&part<LessonPlayer>(*window), &LessonPlayer::changed);
        window->session().openBundledScene();
        QVERIFY(!part<LessonPlayer>(*window).lesson());
        QCOMPARE(changes.size(), 1);
        QVERIFY(dockOf(*window, "lesson")->isHidden());
        QVERIFY(!part<LessonPlayer>(*window).leave());
    }

    void theKeysGoFromStepToStep()
    {
        const auto window = windowOfSize(kWide);
        QAction *next = actionOf(*window, QStringLiteral("Next Step")),
                *back = actionOf(*window, QStringLiteral("Previous Step")),
                *leave = actionOf(*window, QStringLiteral("Leave Lesson"));
        QVERIFY(!next->isEnabled() && !back->isEnabled() && !leave->isEnabled());
        QVERIFY(part<LessonPlayer>(*window).start("derivation"));
        QVERIFY(next->isEnabled() && !back->isEnabled() && leave->isEnabled());
        window->activateWindow(); // keys are for the active one
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        QTest::keyClick(&window->view(), Qt::Key_PageDown, Qt::AltModifier);
        QCOMPARE(part<LessonPlayer>(*window).index(), std::size_t(1));
        auto *steps = panelOf(*window).findChild<QComboBox *>();
        QCOMPARE(steps->currentIndex(), 1);
        const std::size_t count = part<LessonPlayer>(*window).lesson()->steps.size();
        QVERIFY(steps->currentText().startsWith(QStringLiteral("2 of %1").arg(count)));
        follow(*window, QStringLiteral("step:frustum"));
        QCOMPARE(part<LessonPlayer>(*window).index(), count - 1);
        QVERIFY(!next->isEnabled() && !buttonOf(*window, QStringLiteral("Next ›")));
        QTest::keyClick(&window->view(), Qt::Key_PageUp, Qt::AltModifier);
        QCOMPARE(part<LessonPlayer>(*window).index(), count - 2);
        leave->trigger();
        QVERIFY(!part<LessonPlayer>(*window).lesson() && !next->isEnabled());
        QVERIFY(part<LessonPlayer>(*window).start("derivation"));
        follow(*window, QStringLiteral("step:frustum"));
        buttonOf(*window, QStringLiteral("Finish"))->click();
        buttonOf(*window, QStringLiteral("Leave"))->click();
        QVERIFY(!part<LessonPlayer>(*window).lesson());
    }

    void theNoteForNewcomersWaits()
    {
        QSettings().clear();
        const auto window = windowOfSize({1100, 700}, true);
        const auto *note = window->findChild<FirstSteps *>();
        QVERIFY(note && note->isVisible());
        QVERIFY(part<LessonPlayer>(*window).start("rows"));
        QVERIFY(!note->isVisible());
        follow(*window, QStringLiteral("step:round_trip"));
        follow(*window, QStringLiteral("view:300x300"));
        QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), QSize(300, 300), kPatienceMilliseconds);
        QVERIFY(part<LessonPlayer>(*window).leave());
        QVERIFY(note->isVisible());
    }

    void aLessonBeginsAsIfNoneHadBeenBefore()
    {
        const auto window = windowOfSize(kLow);
        const QSize size = window->size();
        QVERIFY(part<LessonPlayer>(*window).start("pipeline"));
        const auto height = heightToGrowFor(*window);
        if (!height)
            QSKIP("The screen is too low for a view that the window grows for.");
        follow(*window, QStringLiteral("view:300x%1").arg(*height));
        QTRY_VERIFY_WITH_TIMEOUT(window->size() != size, kPatienceMilliseconds);
        follow(*window, QStringLiteral("action:backward"));
        QVERIFY(isSeen(*window, "pipeline"));
        QVERIFY(part<LessonPlayer>(*window).start("first"));
        QTRY_COMPARE_WITH_TIMEOUT(window->size(), size, kPatienceMilliseconds);
        QVERIFY(dockOf(*window, "pipeline")->isHidden() && isSeen(*window, "lesson"));
        QCOMPARE(window->findChild<PipelinePanel *>()->direction(), PipelineDirection::Forward);
        QVERIFY(part<LessonPlayer>(*window).leave());
        QCOMPARE(window->size(), size);
        QVERIFY(dockOf(*window, "lesson")->isHidden());
    }

    void theTextHasRoomBesideOtherPanels()
    {
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        const QDockWidget *lesson = dockOf(*window, "lesson"), *parameters = dockOf(*window, "parameters");
        const auto isLarger = [&] {
            return isSeen(*window, "lesson") && isSeen(*window, "parameters")
                   && lesson->height() > parameters->height();
        };
        QVERIFY(player.start("first"));
        window->workspaces().enter(Workspace::Pipeline);
        QTRY_VERIFY_WITH_TIMEOUT(isLarger(), kPatienceMilliseconds);
        // Drawn to another size it keeps that.
        window->resizeDocks({dockOf(*window, "lesson")}, {200}, Qt::Vertical);
        QTRY_VERIFY_WITH_TIMEOUT(!isLarger(), kPatienceMilliseconds);
        QVERIFY(player.next());
        window->workspaces().enter(Workspace::Click);
        window->workspaces().enter(Workspace::Pipeline);
        settle(*window);
        QVERIFY(isSeen(*window, "lesson") && isSeen(*window, "parameters") && !isLarger());
    }
};

UNPROJECTOR_TEST(TestLessonsWindow, display)
#include "test_lessons_window.moc"
