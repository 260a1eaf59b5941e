// The mouse on the view: when a pick happens, what stays under the pointer, and what can never be
// picked.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/picking.h"

#include <QApplication>

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

class TestNavigation : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theLeftButtonPicksBeforeItIsReleased()
    {
        const auto window = cubeWindow(false);
        int picks = 0;
        SceneView &view = window->view();
        const QPoint position = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.1, 0.2)).toPoint();
        connect(&window->document(), &SceneDocument::changed, this,
                [&picks](Changes changes) { picks += changes.testFlag(Change::Pick) ? 1 : 0; });
        QTest::mousePress(&view, Qt::LeftButton, {}, position);
        QCOMPARE(picks, 1);
        QVERIFY(window->document().picks().pick() && window->document().picks().pick()->hit());
        QCOMPARE(heading(*window), QStringLiteral("cube"));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, position);
        QCOMPARE(picks, 1);
        // Other buttons pick nothing.
        for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton})
            QTest::mouseClick(&view, button, {}, position);
        QTest::mouseClick(&view, Qt::LeftButton, Qt::ShiftModifier, position);
        QCOMPARE(picks, 1);
    }

    void aTrembleIsNoDrag()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const QPointF position = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.1, 0.2));
        const LookAt before = window->document().setup().camera();
        for (const auto &[button, modifiers] :
             {std::pair(Qt::LeftButton, Qt::NoModifier), std::pair(Qt::LeftButton, Qt::ShiftModifier),
              std::pair(Qt::MiddleButton, Qt::NoModifier)}) {
            sendMouse(view, QEvent::MouseButtonPress, position, button, button, modifiers);
            const double most = QApplication::startDragDistance() - 1.0;
            for (const QPointF &step : {QPointF(1.0, 0.0), QPointF(1.0, -1.0), QPointF(-most, 0.0), QPointF(0.0, 0.0)})
                sendMouse(view, QEvent::MouseMove, position + step, Qt::NoButton, button, modifiers);
            sendMouse(view, QEvent::MouseButtonRelease, position, button, Qt::NoButton, modifiers);
            QVERIFY(window->document().setup().camera() == before);
        }
        QVERIFY(window->document().picks().pick()); // of the first, which was a click
        // It becomes a drag at the desktop's drag distance.
        drag(view, position, position + QPointF(QApplication::startDragDistance(), 0.0), Qt::LeftButton);
        QVERIFY(window->document().setup().camera() != before);
    }

    void aDragLeavesThePickAlone_data()
    {
        addColumn<bool>("fromSurface");
        addColumn<bool>("hasFormer");
        newRow("on the surface, nothing picked") << true << false;
        newRow("on the surface, another point picked") << true << true;
        newRow("on the background, nothing picked") << false << false;
        newRow("on the background, a point picked") << false << true;
    }

    void aDragLeavesThePickAlone()
    {
        QFETCH(bool, fromSurface);
        QFETCH(bool, hasFormer);
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        if (hasFormer) {
            click(view, localOf(*window, kCubeCenter + glm::dvec3(1.0, -0.4, 0.5)));
            // The object moves after the click: that is not forgotten either.
            QVERIFY(editTransform(document, 0, {Translate{kCubeCenter + glm::dvec3(0.0, 0.1, 0.0)}},
                                  {QStringLiteral("Move")}));
        }
        const auto point = [&] { return document.picks().pick() ? std::optional(picked(*window)) : std::nullopt; };
        const std::optional<glm::dvec3> former = point();
        QCOMPARE(former.has_value(), hasFormer);
        const QString said = heading(*window);
        const LookAt before = document.setup().camera();
        const int steps = document.undoStack().index();

        const QPointF from =
            fromSurface ? localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.6, -0.5)) : QPointF(6.0, 7.0);
        sendMouse(view, QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        QVERIFY(document.picks().pick()); // at once
        QCOMPARE(document.picks().pick()->hit(), fromSurface);
        QVERIFY(point() != former || !fromSurface);
        QCOMPARE(document.undoStack().index(), steps);
        sendMouse(view, QEvent::MouseMove, from + QPointF(30.0, 8.0), Qt::NoButton, Qt::LeftButton);
        QVERIFY(point() == former);
        QVERIFY(document.setup().camera() != before);
        sendMouse(view, QEvent::MouseMove, from + QPointF(45.0, 8.0), Qt::NoButton, Qt::LeftButton);
        sendMouse(view, QEvent::MouseButtonRelease, from, Qt::LeftButton, Qt::NoButton); // back where it began
        QVERIFY(point() == former);
        QCOMPARE(document.picks().sinceClick().isObjectMoved, hasFormer);
        QCOMPARE(heading(*window), said);
        // The whole drag is one step.
        QCOMPARE(document.undoStack().index(), steps + 1);
        document.undoStack().undo();
        QVERIFY(document.setup().camera() == before);
        QVERIFY(point() == former);
    }

    void aFormerPickOfAnObjectThatWentStaysAway()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        const QPointF place = localOf(*window, kCubeCenter + glm::dvec3(0.2, 0.2, 1.0));
        click(view, place);
        QCOMPARE(document.picks().pick()->object, std::optional<std::size_t>(0));
        sendMouse(view, QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
        QVERIFY(removeObject(document, 0));
        sendMouse(view, QEvent::MouseMove, place + QPointF(40.0, 0.0), Qt::NoButton, Qt::LeftButton);
        QVERIFY(!document.picks().pick());
        sendMouse(view, QEvent::MouseButtonRelease, place + QPointF(40.0, 0.0), Qt::LeftButton, Qt::NoButton);
    }

    void aDragTurnsAboutThePickedPoint_data() { addProjections(); }

    void aDragTurnsAboutThePickedPoint()
    {
        QFETCH(bool, isOrtho);
        const auto window = cubeWindow(isOrtho);
        SceneView &view = window->view();
        const QPointF from = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.6, -0.5));
        const LookAt before = window->document().setup().camera();
        click(view, from);
        const glm::dvec3 point = picked(*window);
        drag(view, from, from + QPointF(70.0, -25.0), Qt::LeftButton);
        QVERIFY(isAt(*window, point, centerUnder(view, from), kStillPixels));
        const LookAt &after = window->document().setup().camera();
        // 70 of the height's logical pixels of half a turn about world up: the scene turns right, the
        // camera left.
        const glm::dvec3 f = forwardOf(before), g = forwardOf(after);
        const double yaw = std::atan2(f.z * g.x - f.x * g.z, f.x * g.x + f.z * g.z);
        QVERIFY(std::abs(yaw + 3.14159265358979 * 70.0 / view.height()) < 1e-9);
        QVERIFY(std::asin(g.y) > std::asin(f.y)); // upwards: the camera sinks and looks less down
        QCOMPARE(glm::length(after.center.coordinates() - after.eye.coordinates()),
                 glm::length(before.center.coordinates() - before.eye.coordinates()));
        // The pick keeps the camera of its click.
        QVERIFY(window->document().picks().pick()->setup.camera() == before);
    }

    void aSecondButtonStartsNoOtherDrag_data()
    {
        addColumn<int>("first");
        addColumn<int>("second");
        addColumn<bool>("turns");
        newRow("middle while turning") << int(Qt::LeftButton) << int(Qt::MiddleButton) << true;
        newRow("left while moving") << int(Qt::MiddleButton) << int(Qt::LeftButton) << false;
    }

    void aSecondButtonStartsNoOtherDrag()
    {
        QFETCH(int, first);
        QFETCH(int, second);
        QFETCH(bool, turns);
        const auto one = static_cast<Qt::MouseButton>(first), other = static_cast<Qt::MouseButton>(second);
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        const QPointF position = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.1, 0.2));
        int picks = 0;
        connect(&document, &SceneDocument::changed, this,
                [&picks](Changes changes) { picks += changes.testFlag(Change::Pick) ? 1 : 0; });
        const auto forward = [&] { return forwardOf(document.setup().camera()); };
        const int steps = document.undoStack().index();

        sendMouse(view, QEvent::MouseButtonPress, position, one, one);
        sendMouse(view, QEvent::MouseMove, position + QPointF(20.0, 0.0), Qt::NoButton, one);
        glm::dvec3 before = forward();
        sendMouse(view, QEvent::MouseButtonPress, position + QPointF(20.0, 0.0), other, one | other);
        sendMouse(view, QEvent::MouseMove, position + QPointF(40.0, 0.0), Qt::NoButton, one | other);
        QCOMPARE(glm::length(forward() - before) > 0.01, turns);
        // It does not end the first drag either.
        sendMouse(view, QEvent::MouseButtonRelease, position + QPointF(40.0, 0.0), other, one);
        const LookAt camera = document.setup().camera();
        before = forward();
        sendMouse(view, QEvent::MouseMove, position + QPointF(60.0, 0.0), Qt::NoButton, one);
        QVERIFY(document.setup().camera() != camera);
        QCOMPARE(glm::length(forward() - before) > 0.01, turns);
        sendMouse(view, QEvent::MouseButtonRelease, position + QPointF(60.0, 0.0), one, Qt::NoButton);
        QCOMPARE(picks, turns ? 2 : 0); // at the press, and the previous pick when it turned
        QVERIFY(!document.picks().pick());
        QCOMPARE(document.undoStack().index(), steps + 1);
    }

    void aHandThatReadsNothingGoesByTheCentre_data()
    {
        addColumn<int>("button");
        newRow("turning") << int(Qt::LeftButton);
        newRow("moving") << int(Qt::MiddleButton);
    }

    void aHandThatReadsNothingGoesByTheCentre()
    {
        QFETCH(int, button);
        SceneDocument document;
        openObjects(document, cubeScene());
        SceneView view(document); // never shown: without OpenGL there is nothing to read
        view.resize(500, 400);
        document.setSurface(surfaceFromWidget(500, 400, view.devicePixelRatio()));
        const Setup before = document.setup();
        const WorldPoint center = before.camera().center;
        drag(view, QPointF(100.0, 50.0), QPointF(160.0, 50.0), static_cast<Qt::MouseButton>(button));
        const LookAt after = document.setup().camera();
        if (button == Qt::LeftButton) {
            QVERIFY(distance(after.eye, before.camera().eye) > 0.1);
            QVERIFY(distance(after.center, center) < 1e-9);
        } else {
            const double way = 60.0 * worldPerLogicalPixel(before, center);
            QVERIFY(std::abs(distance(after.center, center) - way) < 1e-9 * way);
        }
    }

    void panningKeepsThePointUnderThePointer_data()
    {
        addColumn<bool>("isOrtho");
        addColumn<int>("button");
        addColumn<int>("modifiers");
        for (const bool isOrtho : {false, true}) {
            const char *projection = isOrtho ? "orthographic" : "perspective";
            addRow("middle button, %s", projection) << isOrtho << int(Qt::MiddleButton) << int(Qt::NoModifier);
            addRow("shift and left button, %s", projection) << isOrtho << int(Qt::LeftButton) << int(Qt::ShiftModifier);
        }
    }

    void panningKeepsThePointUnderThePointer()
    {
        QFETCH(bool, isOrtho);
        QFETCH(int, button);
        QFETCH(int, modifiers);
        const auto window = cubeWindow(isOrtho);
        SceneView &view = window->view();
        const double ratio = view.devicePixelRatio();
        const QPointF from = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.6, -0.5));
        click(view, from);
        const glm::dvec3 point = picked(*window);
        const glm::dvec3 forward = forwardOf(window->document().setup().camera());
        const QPointF way(-90.0, 40.0);
        drag(view, from, from + way, static_cast<Qt::MouseButton>(button),
             static_cast<Qt::KeyboardModifiers>(modifiers));
        // Window y points up.
        QVERIFY(isAt(*window, point, centerUnder(view, from) + glm::dvec2(way.x(), -way.y()) * ratio, kStillPixels));
        QVERIFY(glm::length(forwardOf(window->document().setup().camera()) - forward) < 1e-12);
        QCOMPARE(picked(*window), point);
    }

    void theWheelKeepsThePointUnderThePointer_data() { addProjections(); }

    void theWheelKeepsThePointUnderThePointer()
    {
        QFETCH(bool, isOrtho);
        const auto window = cubeWindow(isOrtho);
        SceneView &view = window->view();
        const QPointF position = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.6, -0.5));
        click(view, position);
        const glm::dvec3 point = picked(*window);
        const auto size = [&] {
            return glm::length(placeOf(*window, point + glm::dvec3(0.0, 0.01, 0.0)) - placeOf(*window, point));
        };
        const double before = size();
        for (const int notches : {1, 3, -2}) {
            turnWheel(view, position, notches);
            QVERIFY(isAt(*window, point, centerUnder(view, position), kStillPixels));
        }
        // Two notches closer in all, 1.2 each; the offset of 0.01 lies a little behind or before the
        // point.
        QVERIFY(std::abs(size() / before - 1.44) < 0.01);
        turnWheel(view, position, -6);
        QVERIFY(isAt(*window, point, centerUnder(view, position), kStillPixels));
        QVERIFY(size() < before);
        // Over the background there is a place to zoom to as well.
        const LookAt camera = window->document().setup().camera();
        const Projection projection = window->document().setup().projection();
        turnWheel(view, QPointF(4.0, 4.0), 1);
        QVERIFY(window->document().setup().camera() != camera || window->document().setup().projection() != projection);
    }

    void aDoubleClickBringsThePointToTheMiddle_data() { addProjections(); }

    void aDoubleClickBringsThePointToTheMiddle()
    {
        QFETCH(bool, isOrtho);
        const auto window = cubeWindow(isOrtho);
        SceneView &view = window->view();
        const QPoint position = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.6, -0.5)).toPoint();
        QTest::mouseDClick(&view, Qt::LeftButton, {}, position);
        QVERIFY(window->document().picks().pick() && window->document().picks().pick()->hit());
        const Viewport &viewport = window->document().setup().viewport;
        QVERIFY(isAt(*window, picked(*window), {viewport.width / 2.0, viewport.height / 2.0}, kStillPixels));
        // A drag on the background leaves the camera alone.
        const LookAt camera = window->document().setup().camera();
        QTest::mouseDClick(&view, Qt::LeftButton, {}, QPoint(view.width() - 5, 5));
        QVERIFY(window->document().setup().camera() == camera);
    }

    void draggingOnTheBackgroundMovesTheCameraAllTheSame()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const glm::dvec3 center = window->document().setup().camera().center.coordinates();
        const QPointF from(view.width() - 30.0, 30.0);
        drag(view, from, from + QPointF(-40.0, 10.0), Qt::LeftButton);
        QVERIFY(!window->document().picks().pick());
        const LookAt turned = window->document().setup().camera();
        QVERIFY(turned.center.coordinates() != center);
        drag(view, from, from + QPointF(-40.0, 10.0), Qt::MiddleButton);
        QVERIFY(turned.eye.coordinates() != window->document().setup().camera().eye.coordinates());
    }
};

UNPROJECTOR_TEST(TestNavigation, display, at 1.5)
#include "test_navigation.moc"
