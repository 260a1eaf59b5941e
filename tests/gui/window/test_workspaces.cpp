// The window's panels over time: sizes after narrow windows, other workspaces and restarts, and the
// panels that go along from workspace to workspace.

#include "tests/support/test.h"

#include "tests/gui/window_user.h"

#include "gui/document/picks.h"
#include "gui/lessons/first_steps.h"
#include "gui/lessons/lesson_player.h"
#include "gui/outside/observer_inset.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/shell/overlay_bars.h"
#include "tests/support/patience.h"

#include <QLabel>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>
#include <QToolButton>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

namespace {

using Act = void (*)(MainWindow &);

constexpr QSize kWide(1280, 800), kNarrow(800, 600);

void resizeTo(MainWindow &window, const QSize &size)
{
    window.resize(size);
    settle();
}

/// Takes the separator left of a dock on the right and lets it go so many pixels to the left.
void widen(MainWindow &window, const char *panel, int pixels)
{
    const QRect dock = dockOf(window, panel)->geometry();
    const QPoint from(dock.left() - 2, dock.center().y()), to = from - QPoint(pixels, 0);
    QTest::mousePress(&window, Qt::LeftButton, {}, from);
    QTest::mouseMove(&window, to);
    QMouseEvent move(QEvent::MouseMove, to, window.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &move);
    settle(20); // it follows a moment later
    QTest::mouseRelease(&window, Qt::LeftButton, {}, to);
    settle(20);
}

} // namespace

class TestWorkspaces : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void init() { QSettings().clear(); }

    void thePanelInFrontIsKnown()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(isSeen(*window, "comparison") && !isSeen(*window, "objects"));
        window->workspaces().show(Panel::Objects);
        QTRY_VERIFY_WITH_TIMEOUT(!isSeen(*window, "comparison") && isSeen(*window, "objects"), kPatienceMilliseconds);
        window->workspaces().enter(Workspace::Pipeline);
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "pipeline") && isSeen(*window, "parameters")
                                     && isSeen(*window, "inspector"),
                                 kPatienceMilliseconds);
        QVERIFY(!isSeen(*window, "lifecycle") && !isSeen(*window, "comparison"));
        dockOf(*window, "inspector")->setFloating(true);
        QVERIFY(!isSeen(*window, "inspector"));
    }

    void theOldSizesComeBack_data()
    {
        addColumn<Act>("before");
        addColumn<Act>("whileNarrow");
        const Act nothing = [](MainWindow &) {};
        const Act thereAndBack = [](MainWindow &window) {
            window.workspaces().enter(Workspace::Pipeline);
            settle(20);
            window.workspaces().enter(Workspace::Click);
        };
        newRow("narrow, then wide") << nothing << nothing;
        newRow("after another place") << thereAndBack << nothing;
        newRow("another place meanwhile") << nothing << thereAndBack;
        newRow("a click into the status bar meanwhile") << nothing << Act([](MainWindow &window) {
            QTest::mouseClick(window.statusBar()->findChild<QLabel *>(), Qt::LeftButton);
            settle(10);
        });
        newRow("all panels hidden meanwhile") << nothing << Act([](MainWindow &window) {
            window.workspaces().hidePanels(true);
            settle(10);
            window.workspaces().hidePanels(false);
        });
        newRow("with a panel that was shown by its key")
            << Act([](MainWindow &window) { dockOf(window, "parameters")->toggleViewAction()->trigger(); }) << nothing;
        newRow("with one below that was shown by its key")
            << Act([](MainWindow &window) { dockOf(window, "inspector")->toggleViewAction()->trigger(); }) << nothing;
        newRow("with the other tab in front")
            << Act([](MainWindow &window) { window.workspaces().show(Panel::Objects); }) << nothing;
    }

    void theOldSizesComeBack()
    {
        QFETCH(Act, before);
        QFETCH(Act, whileNarrow);
        const auto window = windowOfSize(kWide);
        before(*window);
        settle();
        const QSize wide = window->view().size();
        resizeTo(*window, kNarrow);
        QVERIFY(window->view().width() < wide.width());
        whileNarrow(*window);
        settle(20);
        resizeTo(*window, kWide);
        QTRY_COMPARE_WITH_TIMEOUT(window->view().size(), wide, kPatienceMilliseconds);
    }

    void whatTheUserMadeWiderStaysWider_data()
    {
        addColumn<bool>("withOtherPlace");
        newRow("here") << false;
        newRow("after another place") << true;
    }

    void whatTheUserMadeWiderStaysWider()
    {
        QFETCH(bool, withOtherPlace);
        const auto window = windowOfSize(kWide);
        const int first = dockOf(*window, "comparison")->width();
        widen(*window, "comparison", 60);
        const int wider = dockOf(*window, "comparison")->width();
        QCOMPARE(wider, first + 60);
        resizeTo(*window, kNarrow);
        if (withOtherPlace) {
            window->workspaces().enter(Workspace::Pipeline);
            settle(20);
            window->workspaces().enter(Workspace::Click);
        }
        resizeTo(*window, kWide);
        QTRY_COMPARE_WITH_TIMEOUT(dockOf(*window, "comparison")->width(), wider, kPatienceMilliseconds);
    }

    void theOldSizesComeBackAfterARestart()
    {
        int wider = 0;
        {
            const auto window = windowOfSize(kWide, true);
            resizeTo(*window, kWide);
            widen(*window, "comparison", 40);
            wider = dockOf(*window, "comparison")->width();
            resizeTo(*window, kNarrow);
            window->close();
        }
        const auto window = windowOfSize(kWide, true);
        QCOMPARE(window->size(), kNarrow);
        resizeTo(*window, kWide);
        QTRY_COMPARE_WITH_TIMEOUT(dockOf(*window, "comparison")->width(), wider, kPatienceMilliseconds);
    }

    void theViewKeepsItsSizeAndItsClick_data()
    {
        addColumn<QSize>("size");
        newRow("wide") << kWide;
        newRow("narrow") << QSize(1024, 700);
    }

    /// The panels on the right are as wide in every workspace, also after the user has made them wider
    /// in one of them.
    void theViewKeepsItsSizeAndItsClick()
    {
        QFETCH(QSize, size);
        const auto window = shownWindow(false, size);
        enter(*window, "click");
        settle(20);
        const QSize first = window->view().size();
        window->view().onLButtonDown(WidgetPoint(first.width() / 2.0, first.height() / 2.0));
        QVERIFY(window->document().picks().pick());
        for (const char *workspace : {"points", "doctor", "click"}) {
            enter(*window, workspace);
            settle(20);
            QCOMPARE(window->view().size(), first);
            QVERIFY2(!window->document().picks().sinceClick().isAnything(), workspace);
        }
        widen(*window, "comparison", 60);
        const QSize narrower = window->view().size();
        QVERIFY(narrower.width() < first.width());
        for (const char *workspace : {"points", "doctor", "click"}) {
            enter(*window, workspace);
            settle(20);
            QCOMPARE(window->view().size(), narrower);
        }
    }

    /// An earlier version kept a width for each workspace.
    void settingsWithSeveralWidthsBecomeOne()
    {
        const auto widen = [](const QString &workspace, int width) {
            QSettings settings;
            const QString key = QStringLiteral("window/sizes/") + workspace;
            QVariantMap sizes = settings.value(key).toMap();
            QVERIFY2(sizes.contains(QStringLiteral("right")), qPrintable(workspace));
            sizes[QStringLiteral("right")] = width;
            settings.setValue(key, sizes);
        };
        {
            const auto window = windowOfSize(kWide, true);
            for (const char *workspace : {"points", "doctor", "click"})
                enter(*window, workspace);
            window->close();
        }
        widen(QStringLiteral("points"), 380);
        widen(QStringLiteral("doctor"), 470);
        const auto window = windowOfSize(kWide, true);
        const QSize first = window->view().size();
        for (const char *workspace : {"points", "doctor", "click"}) {
            enter(*window, workspace);
            settle(20);
            QCOMPARE(window->view().size(), first);
        }
    }

    void theViewFromOutsideComesBackAsItWasLeft_data()
    {
        addColumn<bool>("isDocked");
        addColumn<bool>("isShown");
        newRow("in the corner of the view") << false << true;
        newRow("in a dock") << true << true;
        newRow("in a dock, not shown") << true << false;
    }

    void theViewFromOutsideComesBackAsItWasLeft()
    {
        QFETCH(bool, isDocked);
        QFETCH(bool, isShown);
        QSizeF share;
        {
            const auto window = windowOfSize(kWide, true);
            QAction *action = actionOf(*window, QStringLiteral("View from Outside"));
            action->trigger();
            auto *panel = window->findChild<ObserverPanel *>();
            QTRY_VERIFY_WITH_TIMEOUT(panel->isVisible(), kPatienceMilliseconds);
            auto *inset = static_cast<ObserverInset *>(panel->parentWidget());
            QTest::mousePress(inset, Qt::LeftButton, {}, {2, 2});
            QMouseEvent move(QEvent::MouseMove, QPointF(-38.0, -22.0), inset->mapToGlobal(QPointF(-38.0, -22.0)),
                             Qt::NoButton, Qt::LeftButton, {});
            QCoreApplication::sendEvent(inset, &move);
            QTest::mouseRelease(inset, Qt::LeftButton, {}, {2, 2});
            share = inset->share();
            QVERIFY(share.width() > 0.42);
            if (isDocked) {
                emit panel->dockRequested(true);
                QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "observer"), kPatienceMilliseconds);
            }
            if (!isShown)
                action->trigger();
            window->close();
        }
        const auto window = windowOfSize(kWide, true);
        QAction *action = actionOf(*window, QStringLiteral("View from Outside"));
        QCOMPARE(action->isChecked(), isShown);
        // A lesson that shows it in between does not change that.
        auto &lessons = part<LessonPlayer>(*window);
        QVERIFY(lessons.start("first") && lessons.goTo(3) && action->isChecked() && lessons.leave());
        QCOMPARE(action->isChecked(), isShown);
        if (!isShown) {
            QVERIFY(dockOf(*window, "observer")->isHidden());
            action->trigger();
        }
        auto *panel = window->findChild<ObserverPanel *>();
        QVERIFY(panel);
        QTRY_VERIFY_WITH_TIMEOUT(panel->isVisible(), kPatienceMilliseconds);
        QCOMPARE(isSeen(*window, "observer"), isDocked);
        emit panel->dockRequested(false);
        QCOMPARE(static_cast<ObserverInset *>(panel->parentWidget())->share(), share);
    }

    void theViewFromOutsideIsOffOnceItsDockIsClosed()
    {
        const auto window = windowOfSize(kWide);
        QAction *action = actionOf(*window, QStringLiteral("View from Outside"));
        action->trigger();
        emit window->findChild<ObserverPanel *>()->dockRequested(true);
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "observer"), kPatienceMilliseconds);
        dockOf(*window, "observer")->close(); // as the x of its frame does
        QVERIFY(!action->isChecked());
        for (const char *place : {"pipeline", "click"}) {
            enter(*window, place);
            QVERIFY2(dockOf(*window, "observer")->isHidden(), place);
        }
        window->workspaces().reset();
        QVERIFY(dockOf(*window, "observer")->isHidden());
        action->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "observer"), kPatienceMilliseconds);
        window->workspaces().enter(Workspace::Pipeline);
        QTRY_VERIFY_WITH_TIMEOUT(!dockOf(*window, "observer")->isHidden(), kPatienceMilliseconds);
    }

    void aLessonHasOneButtonThatClosesIt_data()
    {
        addColumn<QSize>("size");
        addColumn<bool>("isTab");
        newRow("wide") << QSize(1280, 800) << false;
        newRow("small") << QSize(700, 560) << true;
    }

    void aLessonHasOneButtonThatClosesIt()
    {
        QFETCH(QSize, size);
        QFETCH(bool, isTab);
        const auto window = windowOfSize(size);
        for (const Workspace workspace : {Workspace::Click, Workspace::Pipeline}) {
            window->workspaces().enter(workspace);
            QVERIFY(part<LessonPlayer>(*window).start("rows"));
            const QDockWidget *lesson = dockOf(*window, "lesson");
            QTRY_VERIFY_WITH_TIMEOUT(lesson->isVisible(), kPatienceMilliseconds);
            QCOMPARE(lesson->titleBarWidget() != nullptr, isTab);
            QToolButton *own = nullptr;
            for (QToolButton *button : lesson->findChildren<QToolButton *>()) {
                if (button->accessibleName() == QStringLiteral("Leave the lesson"))
                    own = button;
            }
            QVERIFY(own);
            QCOMPARE(own->isVisible(), isTab);
            if (isTab) {
                own->click();
                QVERIFY(lesson->isHidden());
            }
        }
    }

    void aLessonGoesAlongUntilItIsClosed()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start("rows"));
        const QDockWidget *lesson = dockOf(*window, "lesson");
        QVERIFY(!lesson->isHidden());
        window->workspaces().enter(Workspace::Pipeline);
        QVERIFY(!lesson->isHidden());
        dockOf(*window, "lesson")->close();
        window->workspaces().enter(Workspace::Click);
        QVERIFY(lesson->isHidden());
        window->workspaces().reset();
        QVERIFY(lesson->isHidden());
        QVERIFY(part<LessonPlayer>(*window).start("parallel"));
        QVERIFY(!lesson->isHidden());
    }

    void hiddenPanelsComeBackAsTheyAreNow()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start("rows"));
        QVERIFY(!dockOf(*window, "lesson")->isHidden());
        window->workspaces().hidePanels(true);
        QVERIFY(dockOf(*window, "lesson")->isHidden());
        window->session().openBundledScene();
        window->workspaces().hidePanels(false);
        QVERIFY(dockOf(*window, "lesson")->isHidden());
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "comparison"), kPatienceMilliseconds);
    }

    void aRightClickOffersNoEmptyPanel()
    {
        const auto window = windowOfSize(kWide);
        const std::unique_ptr<QMenu> menu(window->createPopupMenu());
        QStringList texts;
        for (const QAction *action : menu->actions())
            texts << action->text();
        for (const QDockWidget *dock : window->findChildren<QDockWidget *>()) {
            const bool standsAlone =
                dock->objectName() == QLatin1String("lesson") || dock->objectName() == QLatin1String("observer");
            QCOMPARE(texts.contains(dock->windowTitle()), !standsAlone);
        }
        QVERIFY(texts.contains(QStringLiteral("Tools")));
    }

    void theInsetsBorderAloneHasItsPointer()
    {
        const auto window = windowOfSize(kWide);
        actionOf(*window, QStringLiteral("View from Outside"))->trigger();
        auto *panel = window->findChild<ObserverPanel *>();
        QTRY_VERIFY_WITH_TIMEOUT(panel->isVisible(), kPatienceMilliseconds);
        QWidget *inset = panel->parentWidget();
        QTest::mouseMove(inset, QPoint(1, 1));
        settle(10);
        QCOMPARE(inset->cursor().shape(), Qt::SizeFDiagCursor);
        QVERIFY(panel->view().cursor().shape() != Qt::SizeFDiagCursor);
        QVERIFY(panel->cursor().shape() != Qt::SizeFDiagCursor);
    }

    /// The window starts for the first time, with the name of a missing file.
    void messagesAreReadBesideTheFirstSteps()
    {
        const auto window = windowOfSize(kWide, true);
        const auto *steps = window->findChild<FirstSteps *>();
        QVERIFY(steps && steps->isVisible());
        const QPoint corner = window->view().mapFromGlobal(steps->mapToGlobal(QPoint(0, 0)));
        QVERIFY(corner.x() > 0 && corner.y() > 0);
        window->session().openFiles({"not-there.obj"});
        QTRY_VERIFY_WITH_TIMEOUT(!window->message().isEmpty(), kPatienceMilliseconds);
        settle(20);
        const auto *message = window->findChild<MessageBar *>();
        const auto placeOf = [&](const QWidget &widget) {
            return QRect(widget.mapTo(window.get(), QPoint(0, 0)), widget.size());
        };
        QVERIFY(message->isVisible() && steps->isVisible());
        QVERIFY(!placeOf(*message).intersects(placeOf(*steps)));
        // A click next to them reaches the view.
        const QPoint beside = placeOf(*steps).center() + QPoint(steps->width(), 0);
        QCOMPARE(window->childAt(beside), &window->view());
    }

    void theFirstStepsStayInTheirPlace()
    {
        const auto window = windowOfSize(kWide, true);
        auto *steps = window->findChild<FirstSteps *>();
        QVERIFY(steps && steps->isVisible());
        window->workspaces().enter(Workspace::Pipeline);
        QVERIFY(steps->isHidden());
        window->workspaces().reset();
        QVERIFY(steps->isHidden());
        window->workspaces().enter(Workspace::Click);
        QVERIFY2(steps->isVisible(), "nobody has closed them");
        emit steps->closeRequested();
        window->workspaces().enter(Workspace::Landmarks);
        window->workspaces().enter(Workspace::Click);
        QVERIFY(steps->isHidden());
        // A user who asks for them is taken to them.
        window->workspaces().enter(Workspace::Pipeline);
        actionOf(*window, QStringLiteral("First Steps"))->trigger();
        QVERIFY(window->workspaces().current() == Workspace::Click);
        QVERIFY(steps->isVisible());
    }

    void aSmallWindowHasEveryPanelOfItsPlace_data()
    {
        addColumn<QSize>("size");
        newRow("wide and high") << kWide;
        newRow("not high") << QSize(1280, 500);
        newRow("narrow") << kNarrow;
    }

    /// Some panels are tabs where there is no room for all side by side.
    void aSmallWindowHasEveryPanelOfItsPlace()
    {
        QFETCH(QSize, size);
        const auto window = windowOfSize(size);
        const std::vector<std::pair<Workspace, std::vector<Panel>>> all{
            {Workspace::Click, {Panel::Comparison, Panel::Objects}},
            {Workspace::Pipeline, {Panel::Pipeline, Panel::Parameters, Panel::Inspector, Panel::Lifecycle}},
            {Workspace::Landmarks, {Panel::Landmarks, Panel::Objects}},
            {Workspace::Doctor, {Panel::Doctor, Panel::Objects}}};
        for (const auto &[workspace, panels] : all) {
            window->workspaces().enter(workspace);
            window->workspaces().reset();
            for (const Panel panel : panels) {
                QVERIFY2(!window->workspaces().dock(panel).isHidden(), nameOf(panel));
                window->workspaces().show(panel);
                QTRY_VERIFY2_WITH_TIMEOUT(isSeen(*window, nameOf(panel)), nameOf(panel), kPatienceMilliseconds);
            }
        }
    }
};

UNPROJECTOR_TEST(TestWorkspaces, display)
#include "test_workspaces.moc"
