// Mouse clicks read surfaces, and never decoration that is only drawn.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/picking.h"
#include "tests/support/patience.h"

#include <QAction>

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::unproject;

class TestPicking : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void theBackgroundHasNoSurface_data() { addProjections(); }

    void theBackgroundHasNoSurface()
    {
        QFETCH(bool, isOrtho);
        const auto window = cubeWindow(isOrtho);
        SceneView &view = window->view();
        const QImage empty = view.grabFramebuffer();
        const QPoint position(view.width() - 6, 7);
        QTest::mouseClick(&view, Qt::LeftButton, {}, position);
        QVERIFY(window->document().picks().pick());
        const Pick &pick = *window->document().picks().pick();
        QVERIFY(!pick.hit());
        QCOMPARE(pick.window.z, 1.0);
        QCOMPARE(heading(*window), QStringLiteral("Background: no surface here"));
        QVERIFY(window->message().isEmpty());
        // A ring about the pixel and nothing within it, since there is no point.
        const QImage ring = view.grabFramebuffer();
        const double ratio = ring.devicePixelRatio();
        const auto isAsBefore = [&](const QPointF &at) {
            const QPoint pixel = (at * ratio).toPoint();
            return ring.pixelColor(pixel) == empty.pixelColor(pixel);
        };
        const QPointF middle(pick.window.x / ratio, view.height() - pick.window.y / ratio);
        for (const double across : {-2.0, 0.0, 2.0})
            QVERIFY(isAsBefore(middle + QPointF(across, 0.0)));
        QVERIFY(!isAsBefore(middle - QPointF(7.0, 0.0)));
        QVERIFY(!isAsBefore(middle + QPointF(0.0, 7.0)));
        // The ray goes through the pixel, by hand.
        const Ray ray = rayThrough(pick.setup, centerUnder(view, position));
        for (const Result<WorldPoint> &end : {pick.rayNear.world[Method::Formula], pick.rayFar.world[Method::Formula]})
            QVERIFY(glm::length(glm::cross(end->coordinates() - ray.origin, ray.direction)) < 1e-9);
        const ProjectionWindow w = projectionWindow(pick.setup.projection());
        QVERIFY(std::abs(distanceOf(pick.setup.camera(), pick.rayNear.world[Method::Formula]->coordinates())
                         - w.nearDistance)
                < 1e-9);
        QVERIFY(
            std::abs(distanceOf(pick.setup.camera(), pick.rayFar.world[Method::Formula]->coordinates()) - w.farDistance)
            < 1e-9);
        // A surface pick does leave a marker.
        click(view, localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.0, 0.0)));
        QVERIFY(view.grabFramebuffer() != empty);
        // The background is a click like any other: the surface's marker goes.
        QTest::mouseClick(&view, Qt::LeftButton, {}, position);
        QCOMPARE(view.grabFramebuffer(), ring);
    }

    void whatIsOnlyDrawnIsNeverPicked_data()
    {
        addColumn<bool>("isOrtho");
        addColumn<bool>("smooth");
        newRow("perspective") << false << false;
        newRow("orthographic") << true << false;
        newRow("perspective, smooth edges") << false << true;
    }

    void whatIsOnlyDrawnIsNeverPicked()
    {
        QFETCH(bool, isOrtho);
        QFETCH(bool, smooth);
        const auto window = shownWindow(smooth, {560, 460});
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        // The cubes are before and behind the origin: the clip distances are fitted to the objects and
        // cut off the decoration.
        std::vector<SceneObject> cubes = cubeScene();
        cubes.push_back(cubes.front());
        cubes.back().transform = {Translate{{-3.0, 1.0, 2.5}}};
        openObjects(document, std::move(cubes));
        setCamera(document, {WorldPoint(0.5, 5.0, 9.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}});
        if (isOrtho)
            switchProjection(document);
        const QImage picture = view.grabFramebuffer();
        const auto colorAt = [&](const QPointF &local) {
            const DevicePixel pixel = pixelUnder(view, local);
            return picture.pixelColor(pixel.i, pixel.j);
        };
        const auto isBackground = [&](const QPointF &local) {
            click(view, local);
            return document.picks().pick() && !document.picks().pick()->hit()
                   && document.picks().pick()->window.z == 1.0;
        };

        // Clicks on the axes: x red, y green, z blue. The line is visible, and nothing is picked.
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 point(0.0);
            point[axis] = 0.8;
            const QPointF local = localOf(*window, point);
            QVERIFY(view.rect().contains(local.toPoint()));
            const QColor color = colorAt(local);
            const std::array<int, 3> channels{color.red(), color.green(), color.blue()};
            QCOMPARE(int(std::max_element(channels.begin(), channels.end()) - channels.begin()), axis);
            QVERIFY(color.saturation() > 60);
            QVERIFY(isBackground(local));
        }
        // A click on a crossing of ground lines, away from axes and cube: darker than its surroundings.
        const double spacing = document.ground().spacing;
        const glm::dvec3 crossing(std::round(1.5 / spacing) * spacing, document.ground().box.lowest.y,
                                  std::round(1.5 / spacing) * spacing);
        const QPointF onLine = localOf(*window, crossing),
                      beside = localOf(*window, crossing + glm::dvec3(0.5, 0.0, 0.5) * spacing);
        QVERIFY(view.rect().contains(onLine.toPoint()) && view.rect().contains(beside.toPoint()));
        QVERIFY(colorAt(onLine).lightness() < colorAt(beside).lightness() - 4);
        QVERIFY(isBackground(onLine));
        // A click on the corner's triad.
        QVERIFY(isBackground(QPointF(42.0, view.height() - 42.0)));
    }

    void theAxesInTheCornerLeaveTheViewportToTheScene_data()
    {
        addColumn<QRect>("viewport"); // y from the bottom; empty: the whole window
        addColumn<int>("side");       // logical pixels; 0: hidden
        newRow("the whole window") << QRect() << 84;
        newRow("a large viewport") << QRect(30, 20, 400, 360) << 84;
        newRow("a smaller one: smaller axes") << QRect(120, 100, 220, 200) << 50;
        newRow("50 x 50: none") << QRect(60, 70, 50, 50) << 0;
        newRow("long and low: none") << QRect(10, 10, 450, 120) << 0;
    }

    void theAxesInTheCornerLeaveTheViewportToTheScene()
    {
        QFETCH(QRect, viewport);
        QFETCH(int, side);
        const auto window = shownWindow(false, {500, 400});
        SceneDocument &document = window->document();
        openObjects(document, {}); // nothing coloured but the axes
        const double ratio = window->view().devicePixelRatio();
        ViewportRule rule;
        if (!viewport.isEmpty()) {
            rule.kind = ViewportRule::Kind::Fixed;
            rule.fixed = {std::round(viewport.x() * ratio), std::round(viewport.y() * ratio),
                          std::round(viewport.width() * ratio), std::round(viewport.height() * ratio)};
        }
        QVERIFY(editViewport(document, rule, {}, {QStringLiteral("Viewport")}));
        const QImage picture = window->view().grabFramebuffer();
        QRect colored;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (picture.pixelColor(x, y).saturation() > 120)
                    colored |= QRect(x, y, 1, 1);
            }
        }
        QCOMPARE(colored.isEmpty(), side == 0);
        const int pixels = static_cast<int>(std::lround(side * ratio));
        const QRect corner(static_cast<int>(rule.kind == ViewportRule::Kind::Fixed ? rule.fixed.x : 0.0),
                           picture.height() - pixels
                               - static_cast<int>(rule.kind == ViewportRule::Kind::Fixed ? rule.fixed.y : 0.0),
                           pixels, pixels);
        QVERIFY(side == 0 || corner.contains(colored));
        QVERIFY(side == 0 || colored.width() > pixels / 3);
    }

    void clickingTheMarkerGivesTheSamePoint()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const QPointF position = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.2, -0.3));
        click(view, position);
        const glm::dvec3 first = picked(*window);
        const double depth = window->document().picks().pick()->window.z;
        settle(30); // the marker is on the screen
        click(view, position);
        QCOMPARE(window->document().picks().pick()->window.z, depth);
        QCOMPARE(picked(*window), first);
    }

    void smoothEdgesCanBeSwitchedWhileAPickIsShown()
    {
        const auto window = cubeWindow(false);
        QAction *smooth = nullptr;
        for (QAction *action : window->findChildren<QAction *>()) {
            if (action->text() == QStringLiteral("&Smooth Edges"))
                smooth = action;
        }
        QVERIFY(smooth && !smooth->isChecked());
        const QPointF position = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.2, -0.3));
        click(window->view(), position);
        const glm::dvec3 before = picked(*window);
        for (const bool on : {true, false}) {
            const glm::dvec3 shown = picked(*window);
            smooth->trigger();
            QCOMPARE(smooth->isChecked(), on);
            settle(30);
            QCOMPARE(picked(*window), shown); // nothing that was picked is lost
            click(window->view(), position);
            QVERIFY(window->document().picks().pick()->hit());
            QCOMPARE(picked(*window), before); // smoothing moves no depth
        }
    }

    void thePointerIsReadOutWithoutPicking()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const auto readOut = [&] {
            for (const QLabel *label : window->findChildren<QLabel *>()) {
                if (label->accessibleName() == QStringLiteral("World coordinate under the pointer"))
                    return label->text();
            }
            return QString();
        };
        const QPointF position = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.2, -0.3));
        const DevicePixel pixel = pixelUnder(view, position);
        sendMouse(view, QEvent::MouseMove, position, Qt::NoButton, Qt::NoButton);
        QTRY_VERIFY_WITH_TIMEOUT(readOut().startsWith(QStringLiteral("world (4.25, "))
                                     || readOut().startsWith(QStringLiteral("world (4.2, ")),
                                 kPatienceMilliseconds);
        QVERIFY2(readOut().endsWith(QStringLiteral("pixel (%1, %2)").arg(pixel.i).arg(pixel.j)), qPrintable(readOut()));
        sendMouse(view, QEvent::MouseMove, QPointF(view.width() - 5.0, 5.0), Qt::NoButton, Qt::NoButton);
        QTRY_VERIFY_WITH_TIMEOUT(readOut().startsWith(QStringLiteral("background, pixel")), kPatienceMilliseconds);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view, &leave);
        QVERIFY(readOut().isEmpty());
        QVERIFY(!window->document().picks().pick());
    }
};

UNPROJECTOR_TEST(TestPicking, display, at 1.5)
#include "test_picking.moc"
