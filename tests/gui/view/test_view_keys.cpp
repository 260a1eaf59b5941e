// Keys on the view: the standard views, fit, home, the projection; turning, moving, zooming and
// picking at the crosshair.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QSignalSpy>
#include <QStatusBar>

#include <glm/geometric.hpp>

#include <cmath>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

/// Turned about in doubles, read from a buffer of 24 bits once: only rounding moves it.
constexpr double kStillPixels = 1e-3;

/// The view has the focus.
std::unique_ptr<MainWindow> activeCubeWindow()
{
    auto window = cubeWindow(false);
    window->activateWindow();
    if (!QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds))
        qFatal("the window does not become active");
    window->view().setFocus();
    return window;
}

/// The pixel that Enter picks.
QPoint pickedByEnter(MainWindow &window)
{
    window.document().picks().clearPick();
    QTest::keyClick(&window.view(), Qt::Key_Return);
    if (!window.document().picks().pick())
        return {-1, -1};
    const DevicePixel &pixel = window.document().picks().pick()->devicePixel;
    return {pixel.i, pixel.j};
}

QPoint middleOf(const MainWindow &window)
{
    const Surface &surface = const_cast<MainWindow &>(window).document().setup().surface;
    return {surface.widthPixels / 2, surface.heightPixels / 2};
}

} // namespace

class TestViewKeys : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void keysLookFromTheSides_data()
    {
        addColumn<int>("key");
        addColumn<int>("modifiers");
        addColumn<glm::dvec3>("forward");
        addColumn<QString>("face");
        const auto row = [](const char *name, Qt::Key key, Qt::KeyboardModifiers modifiers, const glm::dvec3 &forward,
                            const char *face) {
            newRow(name) << int(key) << int(modifiers) << forward << QString::fromLatin1(face);
        };
        row("1: front", Qt::Key_1, Qt::NoModifier, {0.0, 0.0, -1.0}, "+z, blue");
        row("ctrl 1: back", Qt::Key_1, Qt::ControlModifier, {0.0, 0.0, 1.0}, "-z, yellow");
        row("3: right", Qt::Key_3, Qt::NoModifier, {-1.0, 0.0, 0.0}, "+x, red");
        row("ctrl 3: left", Qt::Key_3, Qt::ControlModifier, {1.0, 0.0, 0.0}, "-x, cyan");
        row("7: top", Qt::Key_7, Qt::NoModifier, {0.0, -1.0, 0.0}, "+y, green");
        row("ctrl 7: bottom", Qt::Key_7, Qt::ControlModifier, {0.0, 1.0, 0.0}, "-y, magenta");
    }

    void keysLookFromTheSides()
    {
        QFETCH(int, key);
        QFETCH(int, modifiers);
        QFETCH(glm::dvec3, forward);
        QFETCH(QString, face);
        const auto window = cubeWindow(false);
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        const LookAt before = window->document().setup().camera();
        QTest::keyClick(&window->view(), static_cast<Qt::Key>(key), static_cast<Qt::KeyboardModifiers>(modifiers));
        const LookAt &after = window->document().setup().camera();
        QVERIFY(glm::length(forwardOf(after) - forward) < 1e-12);
        QCOMPARE(after.center.coordinates(), before.center.coordinates());
        const QImage picture = window->view().grabFramebuffer();
        // The pixel is a little beside the middle, where the ground's lines cross the bottom.
        const int shown = faceOfColor(picture.pixelColor(picture.width() / 2 + 9, picture.height() / 2 + 7));
        QVERIFY(shown >= 0);
        QCOMPARE(QString::fromLatin1(cubeFaces()[static_cast<std::size_t>(shown)].name), face);
    }

    void keysFitGoHomeAndSwitchTheProjection()
    {
        const auto window = shownWindow(false, {500, 400});
        SceneDocument &document = window->document();
        openObjects(document, cubeScene());
        const Setup home = document.setup();
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        SceneView &view = window->view();

        QTest::keyClick(&view, Qt::Key_5);
        QVERIFY(!isPerspective(document.setup().projection()));
        QTest::keyClick(&view, Qt::Key_5);
        QVERIFY(isPerspective(document.setup().projection()));

        QTest::keyClick(&view, Qt::Key_1);
        turnWheel(view, QPointF(100.0, 80.0), 8);
        QTest::keyClick(&view, Qt::Key_F);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 world =
                kCubeCenter + glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            QVERIFY(QRectF(view.rect()).contains(localOf(*window, world)));
        }
        QVERIFY(glm::length(forwardOf(document.setup().camera()) - glm::dvec3(0.0, 0.0, -1.0)) < 1e-12);

        QTest::keyClick(&view, Qt::Key_Home);
        QVERIFY(document.setup().camera() == home.camera());
        QVERIFY(document.setup().projection() == home.projection());
    }

    void arrowsTurnAboutThePointAtTheCrosshair_data() { addArrows(); }

    void arrowsTurnAboutThePointAtTheCrosshair()
    {
        QFETCH(int, key);
        QFETCH(QPoint, way);
        const auto window = activeCubeWindow();
        SceneDocument &document = window->document();
        QTest::keyClick(&window->view(), Qt::Key_Enter);
        QVERIFY(document.picks().pick() && document.picks().pick()->hit());
        const glm::dvec3 point = document.picks().pick()->point.world[Method::Formula]->coordinates();
        const glm::dvec2 place = placeOf(*window, point);
        const glm::dvec3 before = forwardOf(document.setup().camera());
        QTest::keyClick(&window->view(), static_cast<Qt::Key>(key));
        QTest::keyClick(&window->view(), static_cast<Qt::Key>(key));
        const glm::dvec3 after = forwardOf(document.setup().camera());
        QVERIFY(glm::length(placeOf(*window, point) - place) < kStillPixels);
        // The scene turns the way of the arrow, the camera the other way: twice five degrees.
        constexpr double kTenDegrees = 3.14159265358979 / 18.0;
        const double yaw = std::atan2(before.z * after.x - before.x * after.z, before.x * after.x + before.z * after.z);
        QVERIFY(std::abs(yaw + way.x() * kTenDegrees) < 1e-9);
        QVERIFY(std::abs(std::asin(after.y) - std::asin(before.y) + way.y() * kTenDegrees) < 1e-9);
    }

    void shiftAndArrowsMove_data() { addArrows(); }

    /// The number is in the status bar, as after a mouse click, with any panel in front.
    void whatEnterPicksIsTold()
    {
        const auto window = activeCubeWindow();
        QSignalSpy told(&window->view(), &SceneView::hovered);
        QTest::keyClick(&window->view(), Qt::Key_Return);
        QVERIFY(window->document().picks().pick() && window->document().picks().pick()->hit());
        QTRY_COMPARE_WITH_TIMEOUT(told.count(), 1, kPatienceMilliseconds);
        QCOMPARE(told[0][0].value<PixelClick>().pixel, window->document().picks().pick()->devicePixel);
        const QString x = QStringLiteral("world (");
        bool isShown = false;
        for (const QLabel *label : window->statusBar()->findChildren<QLabel *>())
            isShown = isShown || label->text().contains(x);
        QVERIFY(isShown);
    }

    void shiftAndArrowsMove()
    {
        QFETCH(int, key);
        QFETCH(QPoint, way);
        const auto window = activeCubeWindow();
        SceneDocument &document = window->document();
        QTest::keyClick(&window->view(), Qt::Key_Enter);
        const glm::dvec3 point = document.picks().pick()->point.world[Method::Formula]->coordinates();
        const glm::dvec2 place = placeOf(*window, point);
        QTest::keyClick(&window->view(), static_cast<Qt::Key>(key), Qt::ShiftModifier);
        const double step = 0.05 * window->view().height() * window->view().devicePixelRatio();
        const glm::dvec2 moved = placeOf(*window, point) - place;
        QVERIFY(glm::length(moved - glm::dvec2(way.x(), -way.y()) * step) < kStillPixels); // window y points up
    }

    void plusAndMinusZoomToTheCrosshair_data()
    {
        addColumn<int>("key");
        addColumn<int>("modifiers");
        addColumn<double>("factor");
        newRow("plus") << int(Qt::Key_Plus) << int(Qt::NoModifier) << 1.2;
        newRow("plus, on Shift") << int(Qt::Key_Plus) << int(Qt::ShiftModifier) << 1.2;
        newRow("plus, of the number pad") << int(Qt::Key_Plus) << int(Qt::KeypadModifier) << 1.2;
        newRow("equal, where plus is") << int(Qt::Key_Equal) << int(Qt::NoModifier) << 1.2;
        newRow("page up") << int(Qt::Key_PageUp) << int(Qt::NoModifier) << 1.2;
        newRow("minus") << int(Qt::Key_Minus) << int(Qt::NoModifier) << 1.0 / 1.2;
        newRow("page down") << int(Qt::Key_PageDown) << int(Qt::NoModifier) << 1.0 / 1.2;
    }

    void plusAndMinusZoomToTheCrosshair()
    {
        QFETCH(int, key);
        QFETCH(int, modifiers);
        QFETCH(double, factor);
        const auto window = activeCubeWindow();
        SceneDocument &document = window->document();
        click(window->view(), localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.6, -0.5))); // the crosshair goes there
        const glm::dvec3 point = document.picks().pick()->point.world[Method::Formula]->coordinates();
        const glm::dvec2 place = placeOf(*window, point);
        const double before = distanceOf(document.setup().camera(), point);
        QTest::keyClick(&window->view(), static_cast<Qt::Key>(key), static_cast<Qt::KeyboardModifiers>(modifiers));
        QVERIFY(glm::length(placeOf(*window, point) - place) < kStillPixels);
        QVERIFY(std::abs(before / distanceOf(document.setup().camera(), point) - factor) < 1e-6);
    }

    void enterPicksAtTheCrosshair()
    {
        const auto window = activeCubeWindow();
        SceneView &view = window->view();
        QCOMPARE(pickedByEnter(*window), middleOf(*window)); // at first
        // A click puts it where it clicked; from there it goes pixel by pixel.
        const QPointF clicked = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.6, -0.5));
        const DevicePixel pixel = pixelUnder(view, clicked);
        click(view, clicked);
        const QPoint start(pixel.i, pixel.j);
        QCOMPARE(pickedByEnter(*window), start);
        QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier);
        QTest::keyClick(&view, Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(pickedByEnter(*window), start + QPoint(1, -1));
        QTest::keyClick(&view, Qt::Key_Down, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyClick(&view, Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(pickedByEnter(*window), start + QPoint(-9, 9));
        // It moves no camera and no pointer's readout, and picks the same as a click there.
        const Pick byKey = *window->document().picks().pick();
        click(view, QPointF(byKey.widget.x, byKey.widget.y));
        QCOMPARE(window->document().picks().pick()->window.z, byKey.window.z);
        QCOMPARE(window->document().picks().pick()->hit(), byKey.hit());
    }

    void theCrosshairStaysInTheView()
    {
        const auto window = activeCubeWindow();
        SceneView &view = window->view();
        const Surface &surface = window->document().setup().surface;
        click(view, QPointF(3.0, 4.0));
        for (int k = 0; k < 2; ++k) {
            QTest::keyClick(&view, Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
            QTest::keyClick(&view, Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
        }
        QCOMPARE(pickedByEnter(*window), QPoint(0, 0));
        click(view, QPointF(view.width() - 3.0, view.height() - 4.0));
        for (int k = 0; k < 2; ++k) {
            QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
            QTest::keyClick(&view, Qt::Key_Down, Qt::ControlModifier | Qt::ShiftModifier);
        }
        QCOMPARE(pickedByEnter(*window), QPoint(surface.widthPixels - 1, surface.heightPixels - 1));
        // The pixel does not exist in a smaller view.
        QVERIFY(resized(*window, {420, 360}));
        QCOMPARE(pickedByEnter(*window), middleOf(*window));
        // The crosshair starts in the middle of the viewport.
        ViewportRule rule;
        rule.kind = ViewportRule::Kind::Fixed;
        rule.fixed = {20.0, 30.0, 100.0, 80.0};
        QVERIFY(editViewport(window->document(), rule, {}, {QStringLiteral("Viewport")}));
        QCOMPARE(pickedByEnter(*window), QPoint(70, surface.heightPixels - 70));
    }

    void theCrosshairIsShownWhileKeysAreUsed()
    {
        const auto window = activeCubeWindow();
        SceneView &view = window->view();
        const QImage plain = view.grabFramebuffer();
        QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier);
        const QImage shown = view.grabFramebuffer();
        // Light arms about a pixel that stays free.
        const QPoint at = middleOf(*window) + QPoint(1, 0);
        const int arm = static_cast<int>(9.0 * view.devicePixelRatio());
        for (const QPoint &way : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
            QVERIFY(shown.pixelColor(at + way * arm).lightness() > 230);
        QCOMPARE(shown.pixel(at), plain.pixel(at));
        // The mouse takes over.
        click(view, QPointF(4.0, 4.0));
        const QImage clicked = view.grabFramebuffer(); // with the ring of a click on the background
        for (const QPoint &way : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
            QCOMPARE(clicked.pixel(at + way * arm), plain.pixel(at + way * arm));
        QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(view.grabFramebuffer() != clicked);
        view.clearFocus();
        QCOMPARE(view.grabFramebuffer(), clicked);
    }

    void tabGoesToTheViewAndOn()
    {
        const auto window = activeCubeWindow();
        SceneView &view = window->view();
        auto *field = new QLineEdit(window.get());
        field->show();
        const QImage plain = view.grabFramebuffer();
        QWidget::setTabOrder(field, &view);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(view.hasFocus());
        QVERIFY(view.grabFramebuffer() != plain); // the crosshair shows the focus
        QTest::keyClick(&view, Qt::Key_Tab);
        QVERIFY(!view.hasFocus());
        QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(5, 5));
        QVERIFY(view.hasFocus());
    }

    void keysInARowAreUndoneAsOne()
    {
        const auto window = activeCubeWindow();
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        const int steps = document.undoStack().index();
        const LookAt before = document.setup().camera();
        for (int k = 0; k < 3; ++k)
            QTest::keyClick(&view, Qt::Key_Left);
        QCOMPARE(document.undoStack().index(), steps + 1);
        const LookAt turned = document.setup().camera();
        for (int k = 0; k < 3; ++k)
            QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
        QTest::keyClick(&view, Qt::Key_Plus);
        QCOMPARE(document.undoStack().index(), steps + 3);
        QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier); // aiming is no step
        QTest::keyClick(&view, Qt::Key_Enter);
        QCOMPARE(document.undoStack().index(), steps + 3);
        document.undoStack().undo();
        document.undoStack().undo();
        QVERIFY(document.setup().camera() == turned);
        document.undoStack().undo();
        QVERIFY(document.setup().camera() == before);
    }

    void theViewsKeysComeBeforeTheWindowsShortcuts()
    {
        const auto window = activeCubeWindow();
        int taken = 0;
        for (const QKeySequence &key :
             {QKeySequence(Qt::Key_Left), QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Return)}) {
            auto *shortcut = new QShortcut(key, window.get());
            connect(shortcut, &QShortcut::activated, this, [&taken] { ++taken; });
        }
        const LookAt before = window->document().setup().camera();
        for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Plus, Qt::Key_Return})
            QTest::keyClick(&window->view(), key);
        QCOMPARE(taken, 0);
        QVERIFY(window->document().setup().camera() != before);
        QVERIFY(window->document().picks().pick());
    }

    void withoutAPictureKeysGoByTheCentre()
    {
        SceneDocument document;
        openObjects(document, cubeScene());
        SceneView view(document); // never shown: without OpenGL there is nothing to read
        view.resize(500, 400);
        document.setSurface(surfaceFromWidget(500, 400, view.devicePixelRatio()));
        const LookAt before = document.setup().camera();
        QTest::keyClick(&view, Qt::Key_Right);
        QVERIFY(distance(document.setup().camera().eye, before.eye) > 0.01);
        QVERIFY(distance(document.setup().camera().center, before.center) < 1e-9);
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(!document.picks().pick());
    }

private:
    static void addArrows()
    {
        addColumn<int>("key");
        addColumn<QPoint>("way");
        newRow("left") << int(Qt::Key_Left) << QPoint(-1, 0);
        newRow("right") << int(Qt::Key_Right) << QPoint(1, 0);
        newRow("up") << int(Qt::Key_Up) << QPoint(0, -1);
        newRow("down") << int(Qt::Key_Down) << QPoint(0, 1);
    }
};

UNPROJECTOR_TEST(TestViewKeys, display)
#include "test_view_keys.moc"
