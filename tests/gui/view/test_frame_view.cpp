// The number of times that the views draw, the part that the screen shows, and the pointer's
// reports. Run once more with object ids as colours.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/outside/observer_view.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QAction>
#include <QScreen>
#include <QSignalSpy>

#include <cmath>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

const LookAt kElsewhere{WorldPoint(kCubeCenter + glm::dvec3(3.0, 1.0, 6.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}};

/// The number of pictures that drew the objects.
int drawnObjects(const QSignalSpy &steps)
{
    int count = 0;
    for (const QList<QVariant> &step : steps)
        count += step.at(0).value<LifecycleEvent>().calls.contains(QStringLiteral("glDrawElements")) ? 1 : 0;
    return count;
}

int pictures(const QSignalSpy &steps)
{
    int count = 0;
    for (const QList<QVariant> &step : steps)
        count += step.at(0).value<LifecycleEvent>().kind == LifecycleEvent::Kind::OnDraw ? 1 : 0;
    return count;
}

} // namespace

/// Returns whether the screen shows the picture at the widget's position. Qt rounds its corner,
/// which can carry its last row and column under a neighbour.
bool isOnScreen(const QWidget &widget, const QImage &picture)
{
    const double ratio = widget.devicePixelRatio();
    const auto pixels = [ratio](int logical) { return static_cast<int>(std::floor(logical * ratio + 0.5)); };
    const QPoint corner = widget.mapToGlobal(QPoint(0, 0));
    QImage screen = widget.screen()->grabWindow(0).toImage().convertToFormat(picture.format());
    screen.setDevicePixelRatio(1.0);
    QImage expected = picture.copy(0, 0, picture.width() - 1, picture.height() - 1);
    expected.setDevicePixelRatio(1.0);
    // A window's corner may lie between logical pixels; the window then reports the neighbouring
    // one.
    for (const int right : {0, -1, 1}) {
        for (const int down : {0, -1, 1}) {
            const QPoint place(pixels(corner.x()) + right, pixels(corner.y()) + down);
            if (screen.copy(QRect(place, expected.size())) == expected)
                return true;
        }
    }
    return false;
}

QImage grabbed(SceneView &view)
{
    return view.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

class TestFrameView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        redirectSettings();
        qRegisterMetaType<LifecycleEvent>();
    }

    void smoothEdgesAreSeenInBothViews()
    {
        const auto window = twoCubesWindow();
        QAction *smooth = nullptr, *observer = nullptr;
        for (QAction *action : window->findChildren<QAction *>()) {
            if (action->text() == QStringLiteral("&Smooth Edges"))
                smooth = action;
            if (action->text() == QStringLiteral("&View from Outside"))
                observer = action;
        }
        if (!smooth || !observer)
            QFAIL("the menu has no such action");
        QVERIFY(!smooth->isChecked());
        window->resize(900, 420);
        observer->trigger();
        auto *outside = window->findChild<ObserverView *>();
        QVERIFY(outside);
        QVERIFY(QTest::qWaitFor([&] { return outside->width() > 200; }, kPatienceMilliseconds));
        settle();
        const QImage before = window->view().grabFramebuffer(), outsideBefore = outside->grabFramebuffer();
        smooth->trigger();
        QVERIFY(window->view().grabFramebuffer() != before);
        QVERIFY(outside->grabFramebuffer() != outsideBefore);
        smooth->trigger();
        QVERIFY(window->view().grabFramebuffer() == before);
        QVERIFY(outside->grabFramebuffer() == outsideBefore);
    }

    void aGrabbedPictureIsSmoothInMotion()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        view.setSmoothEdges(true);
        settle(300);
        const QImage atRest = grabbed(view);
        setCamera(window->document(), kElsewhere);
        QVERIFY(grabbed(view) != atRest);
        setCamera(window->document(), kBeforeTwoCubes);
        QVERIFY(grabbed(view) == atRest);
    }

    void theScreenShowsSmoothEdgesAtRest()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        const QImage plain = grabbed(view);
        QTRY_VERIFY_WITH_TIMEOUT(isOnScreen(view, plain), kPatienceMilliseconds);
        view.setSmoothEdges(true);
        const QImage smooth = grabbed(view);
        QVERIFY(smooth != plain);
        QTRY_VERIFY_WITH_TIMEOUT(isOnScreen(view, smooth), kPatienceMilliseconds);
        // A picture that has just been drawn may be shown unchanged; it does not stay so.
        setCamera(window->document(), kElsewhere);
        setCamera(window->document(), kBeforeTwoCubes);
        settle(40);
        QTRY_VERIFY_WITH_TIMEOUT(isOnScreen(view, smooth), kPatienceMilliseconds);
    }

    void aWindowThatOpensIsDrawnOnce()
    {
        MainWindow::Options options;
        options.remembers = false;
        MainWindow window(options);
        QSignalSpy steps(&window.view(), &SceneView::happened);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window, kPatienceMilliseconds));
        QTRY_VERIFY_WITH_TIMEOUT(drawnObjects(steps) > 0, kPatienceMilliseconds);
        settle();
        // The window's system may lay it out once more.
        QVERIFY2(drawnObjects(steps) <= 2, qPrintable(QString::number(drawnObjects(steps))));
    }

    void aResizedViewIsOnTheScreen()
    {
        const auto window = twoCubesWindow();
        for (const QSize &size : {QSize(500, 300), QSize(300, 420), QSize(640, 480)}) {
            window->resize(size);
            QTRY_COMPARE_WITH_TIMEOUT(window->size(), size, kPatienceMilliseconds);
            settle(30);
            QTRY_VERIFY_WITH_TIMEOUT(isOnScreen(window->view(), grabbed(window->view())), kPatienceMilliseconds);
        }
    }

    void objectsAreDrawnOnceAChange()
    {
        SceneDocument document;
        openObjects(document, twoCubes(), kBeforeTwoCubes);
        SceneView view(document);
        QSignalSpy steps(&view, &SceneView::happened);
        view.resize(400, 300);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view, kPatienceMilliseconds));
        QTRY_VERIFY_WITH_TIMEOUT(pictures(steps) > 0, kPatienceMilliseconds);
        settle();
        QCOMPARE(drawnObjects(steps), 1);

        // A pick is drawn over the picture that is there; the pointer draws nothing at all.
        steps.clear();
        click(view, {200.0, 150.0});
        (void)view.grabFramebuffer();
        QVERIFY(document.picks().pick() && document.picks().pick()->hit());
        QVERIFY(pictures(steps) > 0);
        QCOMPARE(drawnObjects(steps), 0);
        settle();
        steps.clear();
        QSignalSpy hovered(&view, &SceneView::hovered);
        for (int x = 190; x < 210; ++x)
            sendMouse(view, QEvent::MouseMove, QPointF(x, 150.0), Qt::NoButton, Qt::NoButton);
        QTRY_VERIFY_WITH_TIMEOUT(!hovered.isEmpty() && hovered.last().at(0).value<PixelClick>().position.x == 209.0,
                                 kPatienceMilliseconds);
        QCOMPARE(pictures(steps), 0);

        // A click on a picture that is not drawn yet draws it; the paint that follows does not.
        setCamera(document,
                  {WorldPoint(kCubeCenter + glm::dvec3(0.5, 0.3, 7.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
        click(view, {200.0, 150.0});
        QCOMPARE(drawnObjects(steps), 1);
        QTRY_VERIFY_WITH_TIMEOUT(pictures(steps) > 1, kPatienceMilliseconds);
        settle();
        QCOMPARE(drawnObjects(steps), 1);
    }

    void theListOfObjectsMayChange()
    {
        const auto window = twoCubesWindow();
        SceneDocument &document = window->document();
        const QImage two = window->view().grabFramebuffer();
        SceneObject third = cubeScene().front(); // a model that no object has shown yet
        third.transform = {Translate{kCubeCenter + glm::dvec3(0.0, 2.2, 0.0)}};
        QVERIFY(addObjects(document, {third}));
        const QImage three = window->view().grabFramebuffer();
        QVERIFY(three != two);
        QVERIFY(removeObject(document, 0));
        (void)window->view().grabFramebuffer();
        document.undoStack().undo();
        QVERIFY(window->view().grabFramebuffer() == three);
        document.undoStack().undo();
        QVERIFY(window->view().grabFramebuffer() == two);
    }

    void theReadoutFollowsThePointer()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        QSignalSpy hovered(&view, &SceneView::hovered);
        const QPointF place = localOf(*window, kCubeCenter + glm::dvec3(0.2, 0.1, 1.0));
        sendMouse(view, QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton);
        // The picture changes while the pointer waits for its answer: the answer is the new one's.
        setCamera(window->document(),
                  {WorldPoint(kCubeCenter + glm::dvec3(0.0, 0.0, 9.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
        QTRY_VERIFY_WITH_TIMEOUT(!hovered.isEmpty(), kPatienceMilliseconds);
        click(view, place);
        QCOMPARE(hovered.last().at(0).value<PixelClick>().sample.depth, window->document().picks().pick()->window.z);
        // A pointer that has left gets no report.
        hovered.clear();
        sendMouse(view, QEvent::MouseMove, place + QPointF(3.0, 0.0), Qt::NoButton, Qt::NoButton);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view, &leave);
        settle();
        QVERIFY(hovered.isEmpty());
        // It comes back.
        sendMouse(view, QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton);
        QTRY_COMPARE_WITH_TIMEOUT(hovered.size(), 1, kPatienceMilliseconds);
        QCOMPARE(hovered.last().at(0).value<PixelClick>().sample.depth, window->document().picks().pick()->window.z);
    }

    void anAnswerThatIsOvertakenIsGivenOfTheNextPicture()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        (void)view.grabFramebuffer(); // or the answer would be asked for later, once there is a picture
        QSignalSpy hovered(&view, &SceneView::hovered);
        const QPointF place = localOf(*window, kCubeCenter + glm::dvec3(0.2, 0.1, 1.0));
        sendMouse(view, QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton);
        // The answer comes while the next picture is not drawn yet.
        view.setUpdatesEnabled(false);
        setCamera(window->document(), kElsewhere);
        settle(100);
        QVERIFY(hovered.isEmpty());
        view.setUpdatesEnabled(true);
        QTRY_COMPARE_WITH_TIMEOUT(hovered.size(), 1, kPatienceMilliseconds);
        click(view, place);
        QCOMPARE(hovered.last().at(0).value<PixelClick>().sample.depth, window->document().picks().pick()->window.z);
    }
};

UNPROJECTOR_TEST(TestFrameView, display, colour_ids, at 1.5)
#include "test_frame_view.moc"
