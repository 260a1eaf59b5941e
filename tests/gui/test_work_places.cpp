// What the window's panels come back to: sizes after narrow windows, other places and restarts, and the panels that go along
// from place to place.

#include "window_user.h"

#include "gui/lessons/lesson_player.h"
#include "gui/outside/observer_inset.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/shell/first_steps.h"
#include "gui/shell/overlay_bars.h"
#include "gui/shell/place_ids.h"
#include "tests/support/patience.h"

#include <QLabel>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>
#include <QToolButton>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

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

class TestWorkPlaces : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void init() { QSettings().clear(); }

    void thePanelInFrontIsKnown();
    void theOldSizesComeBack_data();
    void theOldSizesComeBack();
    void whatTheUserMadeWiderStaysWider_data();
    void whatTheUserMadeWiderStaysWider();
    void theOldSizesComeBackAfterARestart();

    void theViewFromOutsideComesBackAsItWasLeft_data();
    void theViewFromOutsideComesBackAsItWasLeft();
    void theViewFromOutsideIsOffOnceItsDockIsClosed();
    void aLessonHasOneButtonThatClosesIt_data();
    void aLessonHasOneButtonThatClosesIt();
    void aLessonGoesAlongUntilItIsClosed();
    void hiddenPanelsComeBackAsTheyAreNow();
    void aRightClickOffersNoEmptyPanel();
    void theInsetsBorderAloneHasItsPointer();
    void messagesAreReadBesideTheFirstSteps();
    void theFirstStepsStayInTheirPlace();
    void aSmallWindowHasEveryPanelOfItsPlace_data();
    void aSmallWindowHasEveryPanelOfItsPlace();
};

void TestWorkPlaces::thePanelInFrontIsKnown()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(isSeen(*window, "comparison") && !isSeen(*window, "objects"));
    window->places().show("objects");
    QTRY_VERIFY_WITH_TIMEOUT(!isSeen(*window, "comparison") && isSeen(*window, "objects"), kPatienceMilliseconds);
    window->places().enter("pipeline");
    QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "pipeline") && isSeen(*window, "parameters")
                                 && isSeen(*window, "inspector"),
                             kPatienceMilliseconds);
    QVERIFY(!isSeen(*window, "lifecycle") && !isSeen(*window, "comparison"));
    dockOf(*window, "inspector")->setFloating(true);
    QVERIFY(!isSeen(*window, "inspector"));
}

void TestWorkPlaces::theOldSizesComeBack_data()
{
    QTest::addColumn<Act>("before");
    QTest::addColumn<Act>("whileNarrow");
    const Act nothing = [](MainWindow &) {};
    const Act thereAndBack = [](MainWindow &window) {
        window.places().enter("pipeline");
        settle(20);
        window.places().enter("click");
    };
    QTest::newRow("narrow, then wide") << nothing << nothing;
    QTest::newRow("after another place") << thereAndBack << nothing;
    QTest::newRow("another place meanwhile") << nothing << thereAndBack;
    QTest::newRow("a click into the status bar meanwhile") << nothing << Act([](MainWindow &window) {
        QTest::mouseClick(window.statusBar()->findChild<QLabel *>(), Qt::LeftButton);
        settle(10);
    });
    QTest::newRow("all panels hidden meanwhile") << nothing << Act([](MainWindow &window) {
        window.hidePanels(true);
        settle(10);
        window.hidePanels(false);
    });
    QTest::newRow("with a panel that was shown by its key")
        << Act([](MainWindow &window) { dockOf(window, "parameters")->toggleViewAction()->trigger(); }) << nothing;
    QTest::newRow("with one below that was shown by its key")
        << Act([](MainWindow &window) { dockOf(window, "inspector")->toggleViewAction()->trigger(); }) << nothing;
    QTest::newRow("with the other tab in front")
        << Act([](MainWindow &window) { window.places().show("objects"); }) << nothing;
}

void TestWorkPlaces::theOldSizesComeBack()
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

void TestWorkPlaces::whatTheUserMadeWiderStaysWider_data()
{
    QTest::addColumn<bool>("withOtherPlace");
    QTest::newRow("here") << false;
    QTest::newRow("after another place") << true;
}

void TestWorkPlaces::whatTheUserMadeWiderStaysWider()
{
    QFETCH(bool, withOtherPlace);
    const auto window = windowOfSize(kWide);
    const int first = dockOf(*window, "comparison")->width();
    widen(*window, "comparison", 60);
    const int wider = dockOf(*window, "comparison")->width();
    QCOMPARE(wider, first + 60);
    resizeTo(*window, kNarrow);
    if (withOtherPlace) {
        window->places().enter("pipeline");
        settle(20);
        window->places().enter("click");
    }
    resizeTo(*window, kWide);
    QTRY_COMPARE_WITH_TIMEOUT(dockOf(*window, "comparison")->width(), wider, kPatienceMilliseconds);
}

void TestWorkPlaces::theOldSizesComeBackAfterARestart()
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

void TestWorkPlaces::theViewFromOutsideComesBackAsItWasLeft_data()
{
    QTest::addColumn<bool>("isDocked");
    QTest::addColumn<bool>("isShown");
    QTest::newRow("in the corner of the view") << false << true;
    QTest::newRow("in a dock") << true << true;
    QTest::newRow("in a dock, not shown") << true << false;
}

void TestWorkPlaces::theViewFromOutsideComesBackAsItWasLeft()
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

void TestWorkPlaces::theViewFromOutsideIsOffOnceItsDockIsClosed()
{
    const auto window = windowOfSize(kWide);
    QAction *action = actionOf(*window, QStringLiteral("View from Outside"));
    action->trigger();
    emit window->findChild<ObserverPanel *>()->dockRequested(true);
    QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "observer"), kPatienceMilliseconds);
    dockOf(*window, "observer")->close(); // as the x of its frame does
    QVERIFY(!action->isChecked());
    for (const char *place : {"pipeline", "click"}) {
        window->places().enter(place);
        QVERIFY2(dockOf(*window, "observer")->isHidden(), place);
    }
    window->places().reset();
    QVERIFY(dockOf(*window, "observer")->isHidden());
    action->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "observer"), kPatienceMilliseconds);
    window->places().enter("pipeline");
    QTRY_VERIFY_WITH_TIMEOUT(!dockOf(*window, "observer")->isHidden(), kPatienceMilliseconds);
}

void TestWorkPlaces::aLessonHasOneButtonThatClosesIt_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("isTab");
    QTest::newRow("wide") << QSize(1280, 800) << false;
    QTest::newRow("small") << QSize(700, 560) << true;
}

void TestWorkPlaces::aLessonHasOneButtonThatClosesIt()
{
    QFETCH(QSize, size);
    QFETCH(bool, isTab);
    const auto window = windowOfSize(size);
    for (const char *place : {kClickPlace, kPipelinePlace}) {
        window->places().enter(place);
        QVERIFY(window->lessons().start("rows"));
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

void TestWorkPlaces::aLessonGoesAlongUntilItIsClosed()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start("rows"));
    const QDockWidget *lesson = dockOf(*window, "lesson");
    QVERIFY(!lesson->isHidden());
    window->places().enter("pipeline");
    QVERIFY(!lesson->isHidden());
    dockOf(*window, "lesson")->close();
    window->places().enter("click");
    QVERIFY(lesson->isHidden());
    window->places().reset();
    QVERIFY(lesson->isHidden());
    QVERIFY(window->lessons().start("parallel"));
    QVERIFY(!lesson->isHidden());
}

void TestWorkPlaces::hiddenPanelsComeBackAsTheyAreNow()
{
    const auto window = windowOfSize(kWide);
    QVERIFY(window->lessons().start("rows"));
    QVERIFY(!dockOf(*window, "lesson")->isHidden());
    window->hidePanels(true);
    QVERIFY(dockOf(*window, "lesson")->isHidden());
    window->session().openBundledScene();
    window->hidePanels(false);
    QVERIFY(dockOf(*window, "lesson")->isHidden());
    QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "comparison"), kPatienceMilliseconds);
}

void TestWorkPlaces::aRightClickOffersNoEmptyPanel()
{
    const auto window = windowOfSize(kWide);
    const std::unique_ptr<QMenu> menu(window->createPopupMenu());
    QStringList texts;
    for (const QAction *action : menu->actions())
        texts << action->text();
    for (const WorkPlaces::Panel &panel : window->places().panels())
        QCOMPARE(texts.contains(panel.title), !panel.standsAlone);
    QVERIFY(texts.contains(QStringLiteral("Tools")));
}

void TestWorkPlaces::theInsetsBorderAloneHasItsPointer()
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

/// At the first start, with the name of a file that is not there.
void TestWorkPlaces::messagesAreReadBesideTheFirstSteps()
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
    // Beside them the view is clicked.
    const QPoint beside = placeOf(*steps).center() + QPoint(steps->width(), 0);
    QCOMPARE(window->childAt(beside), &window->view());
}

void TestWorkPlaces::theFirstStepsStayInTheirPlace()
{
    const auto window = windowOfSize(kWide, true);
    auto *steps = window->findChild<FirstSteps *>();
    QVERIFY(steps && steps->isVisible());
    window->places().enter(kPipelinePlace);
    QVERIFY(steps->isHidden());
    window->places().reset();
    QVERIFY(steps->isHidden());
    window->places().enter(kClickPlace);
    QVERIFY2(steps->isVisible(), "nobody has closed them");
    emit steps->closeRequested();
    window->places().enter(kPointsPlace);
    window->places().enter(kClickPlace);
    QVERIFY(steps->isHidden());
    // Who asks for them is taken to where they are.
    window->places().enter(kPipelinePlace);
    actionOf(*window, QStringLiteral("First Steps"))->trigger();
    QCOMPARE(window->places().current(), kClickPlace);
    QVERIFY(steps->isVisible());
}

void TestWorkPlaces::aSmallWindowHasEveryPanelOfItsPlace_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("wide and high") << kWide;
    QTest::newRow("not high") << QSize(1280, 500);
    QTest::newRow("narrow") << kNarrow;
}

/// Where there is no room for all side by side, some are tabs.
void TestWorkPlaces::aSmallWindowHasEveryPanelOfItsPlace()
{
    QFETCH(QSize, size);
    const auto window = windowOfSize(size);
    for (const WorkPlaces::Place &place : window->places().places()) {
        window->places().enter(place.id);
        window->places().reset();
        for (const char *panel : place.panels) {
            QVERIFY2(!dockOf(*window, panel)->isHidden(), panel);
            window->places().show(panel);
            QTRY_VERIFY2_WITH_TIMEOUT(isSeen(*window, panel), panel, kPatienceMilliseconds);
        }
    }
}

QTEST_MAIN(TestWorkPlaces)
#include "test_work_places.moc"
