// The context menu of the view, and its hidden entries.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/text/number_text.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>

#include <glm/geometric.hpp>

using namespace guitest;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::unproject;

namespace {

constexpr double kStillPixels = 1e-3;

QMenu *openMenu(SceneView &view)
{
    for (QMenu *menu : view.findChildren<QMenu *>(QStringLiteral("viewMenu"))) {
        if (menu->isVisible())
            return menu;
    }
    return nullptr;
}

QAction *actionIn(SceneView &view, const char *name)
{
    QMenu *menu = openMenu(view);
    return menu ? menu->findChild<QAction *>(QLatin1String(name)) : nullptr;
}

void clickRight(SceneView &view, const QPointF &local)
{
    sendMouse(view, QEvent::MouseButtonPress, local, Qt::RightButton, Qt::RightButton);
    sendMouse(view, QEvent::MouseButtonRelease, local, Qt::RightButton, Qt::NoButton);
}

/// Opens the menu, triggers one entry and closes it.
void choose(SceneView &view, const QPointF &local, const char *name)
{
    clickRight(view, local);
    QAction *action = actionIn(view, name);
    QVERIFY2(action && action->isEnabled(), name);
    action->trigger();
    if (QMenu *menu = openMenu(view))
        menu->close();
}

} // namespace

class TestViewMenu : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void aRightClickOpensIt()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const LookAt before = window->document().setup().camera();
        clickRight(view, localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.2, 0.1)));
        QVERIFY(openMenu(view));
        QVERIFY(!window->document().picks().pick()); // until it is asked for
        openMenu(view)->close();
        // Qt reports the same click once more, by an event of its own: that is not for the window's
        // menu either.
        QContextMenuEvent again(QContextMenuEvent::Mouse, QPoint(50, 50), view.mapToGlobal(QPoint(50, 50)));
        QVERIFY(QCoreApplication::sendEvent(&view, &again) && again.isAccepted());
        QVERIFY(!openMenu(view));
        QVERIFY(window->document().setup().camera() == before);
    }

    void aRightDragDoesNot()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const LookAt before = window->document().setup().camera();
        const QPointF from(100.0, 100.0);
        drag(view, from, from + QPointF(QApplication::startDragDistance() + 5.0, 0.0), Qt::RightButton);
        QVERIFY(!openMenu(view));
        // The menu does not open after a drag there and back, or in the middle of another drag.
        sendMouse(view, QEvent::MouseButtonPress, from, Qt::RightButton, Qt::RightButton);
        sendMouse(view, QEvent::MouseMove, from + QPointF(40.0, 0.0), Qt::NoButton, Qt::RightButton);
        sendMouse(view, QEvent::MouseMove, from, Qt::NoButton, Qt::RightButton);
        sendMouse(view, QEvent::MouseButtonRelease, from, Qt::RightButton, Qt::NoButton);
        QVERIFY(!openMenu(view));
        QVERIFY(window->document().setup().camera() == before);
        sendMouse(view, QEvent::MouseButtonPress, from, Qt::MiddleButton, Qt::MiddleButton);
        sendMouse(view, QEvent::MouseButtonPress, from, Qt::RightButton, Qt::MiddleButton | Qt::RightButton);
        sendMouse(view, QEvent::MouseButtonRelease, from, Qt::RightButton, Qt::MiddleButton);
        sendMouse(view, QEvent::MouseButtonRelease, from, Qt::MiddleButton, Qt::NoButton);
        QVERIFY(!openMenu(view));
        // A tremble is no drag.
        sendMouse(view, QEvent::MouseButtonPress, from, Qt::RightButton, Qt::RightButton);
        sendMouse(view, QEvent::MouseMove, from + QPointF(1.0, 1.0), Qt::NoButton, Qt::RightButton);
        sendMouse(view, QEvent::MouseButtonRelease, from, Qt::RightButton, Qt::NoButton);
        QVERIFY(openMenu(view));
        openMenu(view)->close();
    }

    void theMenuKeyOpensItAtTheCrosshair()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        QContextMenuEvent key(QContextMenuEvent::Keyboard, QPoint(3, 3), view.mapToGlobal(QPoint(3, 3)));
        QCoreApplication::sendEvent(&view, &key);
        QAction *pick = actionIn(view, "pickHere");
        QVERIFY(pick);
        pick->trigger();
        const Surface &surface = window->document().setup().surface;
        QCOMPARE(window->document().picks().pick()->devicePixel.i, surface.widthPixels / 2);
        QCOMPARE(window->document().picks().pick()->devicePixel.j, surface.heightPixels / 2);
        QVERIFY(!openMenu(view)); // another point is picked now
    }

    void whatNeedsASurfaceIsGreyedWithoutOne_data()
    {
        addColumn<bool>("onSurface");
        addColumn<bool>("isPicked");
        newRow("on an object, nothing picked") << true << false;
        newRow("on the background, nothing picked") << false << false;
        newRow("on the background, a point picked") << false << true;
    }

    void whatNeedsASurfaceIsGreyedWithoutOne()
    {
        QFETCH(bool, onSurface);
        QFETCH(bool, isPicked);
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const QPointF surface = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.2, 0.1));
        if (isPicked)
            click(view, surface);
        clickRight(view, onSurface ? surface : QPointF(5.0, 6.0));
        QVERIFY(openMenu(view));
        for (const char *name : {"lookHere", "fitObject", "hideObject"})
            QCOMPARE(actionIn(view, name)->isEnabled(), onSurface);
        for (const char *name : {"pickHere", "fit"})
            QVERIFY(actionIn(view, name)->isEnabled());
        QCOMPARE(actionIn(view, "copyPoint")->isEnabled(), onSurface);
        QVERIFY(!actionIn(view, "showAll")->isEnabled());
        for (const QAction *action : openMenu(view)->actions())
            QVERIFY(action->isSeparator() || !action->toolTip().isEmpty());
        openMenu(view)->close();
    }

    void pickHerePicksThatPixel()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const QPointF local = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.2, 0.1));
        const DevicePixel pixel = pixelUnder(view, local);
        choose(view, local, "pickHere");
        QVERIFY(window->document().picks().pick() && window->document().picks().pick()->hit());
        QVERIFY(window->document().picks().pick()->devicePixel == pixel);
        // Keys go on from there.
        QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier);
        QTest::keyClick(&view, Qt::Key_Return);
        QCOMPARE(window->document().picks().pick()->devicePixel.i, pixel.i + 1);
    }

    void theCopiedPointHasAllDigits()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        click(view, localOf(*window, kCubeCenter + glm::dvec3(1.0, -0.5, 0.4))); // different from the copied point
        const QPointF local = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.2, 0.1));
        choose(view, local, "copyPoint");
        QCOMPARE(window->document().picks().pick()->devicePixel, pixelUnder(view, local));
        const WorldPoint point = *window->document().picks().pick()->point.world[Method::Formula];
        const QStringList numbers = QApplication::clipboard()->text().split(QStringLiteral(", "));
        QCOMPARE(numbers.size(), 3);
        QCOMPARE(numbers[0].toDouble(), point.x);
        QCOMPARE(numbers[1].toDouble(), point.y);
        QCOMPARE(numbers[2].toDouble(), point.z);
    }

    void whatTheModeTakesIsCopied()
    {
        const auto window = cubeWindow(false);
        window->document().picks().setSnap(ray::Snap::Vertex);
        const glm::dvec3 corner = kCubeCenter + glm::dvec3(1.0, 1.0, 1.0);
        choose(window->view(), localOf(*window, corner) + QPointF(-2.5, 3.0), "copyPoint");
        QCOMPARE(
            QApplication::clipboard()->text(),
            QStringLiteral("%1, %2, %3").arg(shortestText(corner.x), shortestText(corner.y), shortestText(corner.z)));
        // A click without a vertex within reach picks the surface.
        const QPointF onFace = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.2, 0.1));
        choose(window->view(), onFace, "copyPoint");
        QCOMPARE(window->document().picks().pickedPoint(),
                 std::optional(*window->document().picks().pick()->point.world[Method::Formula]));
        QVERIFY(
            QApplication::clipboard()->text().startsWith(shortestText(window->document().picks().pickedPoint()->x)));
    }

    void lookingAtAPointBringsItToTheMiddle()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        const QPointF local = localOf(*window, kCubeCenter + glm::dvec3(1.0, 0.6, -0.5));
        click(view, local);
        const glm::dvec3 point = window->document().picks().pick()->point.world[Method::Formula]->coordinates();
        choose(view, local, "lookHere");
        const Viewport &viewport = window->document().setup().viewport;
        QVERIFY(glm::length(placeOf(*window, point) - glm::dvec2(viewport.width, viewport.height) / 2.0)
                < kStillPixels);
    }

    void fittingShowsTheObjectThatWasClicked()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        const QPointF behind = localOf(*window, kTwoCubeCenters[1] + glm::dvec3(-0.8, 0.9, 1.0));
        click(view, behind);
        QCOMPARE(document.picks().pick()->object, std::optional<std::size_t>(1));
        choose(view, behind, "fitObject");
        const LookAt one = document.setup().camera();
        fitObject(document, 1);
        QVERIFY(distance(one.eye, document.setup().camera().eye) < 1e-9);
        choose(view, QPointF(2.0, 2.0), "fit");
        QVERIFY(distance(one.eye, document.setup().camera().eye) > 1.0);
    }

    void aHiddenObjectIsNeitherDrawnNorPicked()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        SceneDocument &document = window->document();
        // Near and far stay: fitted to the one that is left they would cut the other one away.
        QVERIFY(editProjection(document, {document.setup().projection(), true, false}, {QStringLiteral("Fixed")}));
        const QPointF front = localOf(*window, kCubeCenter + glm::dvec3(0.0, 0.0, 1.0));
        const QImage both = view.grabFramebuffer();
        const int steps = document.undoStack().count();
        choose(view, front, "hideObject");
        QCOMPARE(document.undoStack().count(), steps + 1);
        QVERIFY(document.objects()[0].isHidden);
        QVERIFY(differentPixels(view.grabFramebuffer(), both) > 1000);
        click(view, front);
        QVERIFY(!document.picks().pick()->hit() || document.picks().pick()->object == std::optional<std::size_t>(1));
        document.picks().clearPick();
        const QPointF other = localOf(*window, kTwoCubeCenters[1] + glm::dvec3(-0.8, 0.9, 1.0));
        click(view, other);
        QCOMPARE(document.picks().pick()->object, std::optional<std::size_t>(1)); // it kept its number
        document.picks().clearPick();
        choose(view, QPointF(2.0, 2.0), "showAll");
        QVERIFY(!hasHiddenObjects(document.scene()));
        QCOMPARE(differentPixels(view.grabFramebuffer(), both), 0);
        document.undoStack().undo();
        QVERIFY(document.objects()[0].isHidden);
        document.undoStack().undo();
        QCOMPARE(differentPixels(view.grabFramebuffer(), both), 0);
    }

    void itClosesWhenItsObjectsGo()
    {
        const auto window = twoCubesWindow();
        SceneView &view = window->view();
        clickRight(view, localOf(*window, kCubeCenter + glm::dvec3(0.0, 0.0, 1.0)));
        QVERIFY(openMenu(view));
        QVERIFY(removeObject(window->document(), 0));
        QVERIFY(!openMenu(view));
    }
};

UNPROJECTOR_TEST(TestViewMenu, display)
#include "test_view_menu.moc"
