// Clicks that take a vertex, an edge or a face: chosen by key, marked under the pointer, exact.

#include "tests/support/test.h"

#include "gui/click/comparison_panel.h"
#include "gui/document/picks.h"
#include "gui/document/ray_casters.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>

#include <glm/geometric.hpp>

#include <cmath>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::unproject;
using unprojector::ray::Snap;

namespace {

/// The corner that is nearest to the eye.
const glm::dvec3 kCorner = kCubeCenter + glm::dvec3(1.0, 1.0, 1.0);
/// The middle of an edge from there, far from the diagonals of the faces, which are edges of
/// triangles as well.
const glm::dvec3 kOnEdge = kCubeCenter + glm::dvec3(1.0, 0.0, 1.0);

/// The cube's window with the focus in its view.
std::unique_ptr<MainWindow> activeWindow(bool isOrtho)
{
    auto window = cubeWindow(isOrtho);
    window->activateWindow();
    if (!QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds))
        qFatal("the window does not become active");
    window->view().setFocus();
    return window;
}

/// A position some pixels beside a world point, in no direction of the cube's edges.
QPointF beside(const MainWindow &window, const glm::dvec3 &world)
{
    return localOf(window, world) + QPointF(-2.5, 3.0);
}

QImage pictureOf(MainWindow &window)
{
    QCoreApplication::processEvents();
    return window.view().grabFramebuffer();
}

void hover(MainWindow &window, const QPointF &local)
{
    sendMouse(window.view(), QEvent::MouseMove, local, Qt::NoButton, Qt::NoButton);
}

} // namespace

class TestSnapModes : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void keysAndButtonsChoose_data()
    {
        addColumn<int>("key");
        addColumn<int>("modifiers");
        addColumn<int>("snap");
        const auto row = [](const char *name, Qt::Key key, Qt::KeyboardModifiers modifiers, Snap snap) {
            newRow(name) << int(key) << int(modifiers) << int(snap);
        };
        row("V: vertex", Qt::Key_V, Qt::NoModifier, Snap::Vertex);
        row("E: edge", Qt::Key_E, Qt::NoModifier, Snap::Edge);
        row("Shift F: face", Qt::Key_F, Qt::ShiftModifier, Snap::Face);
    }

    void keysAndButtonsChoose()
    {
        QFETCH(int, key);
        QFETCH(int, modifiers);
        QFETCH(int, snap);
        const auto window = activeWindow(false);
        QCOMPARE(int(window->document().picks().snap()), int(Snap::Surface));
        QTest::keyClick(&window->view(), Qt::Key(key), Qt::KeyboardModifiers(modifiers));
        QCOMPARE(int(window->document().picks().snap()), snap);
        const auto *button = window->findChild<QToolButton *>(QStringLiteral("snap"));
        int checked = 0;
        for (const QAction *action : button->menu()->actions()) {
            if (action->isChecked() && action->shortcut() == QKeySequence(modifiers | key)) {
                ++checked;
                QVERIFY(!button->icon().isNull());
                QVERIFY2(button->text().endsWith(action->iconText()), qPrintable(button->text()));
            }
        }
        QCOMPARE(checked, 1);
        QTest::keyClick(&window->view(), Qt::Key_S);
        QCOMPARE(int(window->document().picks().snap()), int(Snap::Surface));
    }

    void aClickTakesWhatIsChosen_data()
    {
        addColumn<bool>("isOrtho");
        addColumn<int>("snap");
        for (const bool isOrtho : {false, true}) {
            for (const Snap snap : {Snap::Surface, Snap::Vertex, Snap::Edge, Snap::Face})
                addRow("%s, %d", isOrtho ? "orthographic" : "perspective", int(snap)) << isOrtho << int(snap);
        }
    }

    void aClickTakesWhatIsChosen()
    {
        QFETCH(bool, isOrtho);
        QFETCH(int, snap);
        const auto window = cubeWindow(isOrtho);
        window->document().picks().setSnap(static_cast<Snap>(snap));
        const bool isEdge = static_cast<Snap>(snap) == Snap::Edge;
        click(window->view(), beside(*window, isEdge ? kOnEdge : kCorner));
        const PickedRay *ray = window->document().picks().pickedRay();
        QVERIFY(ray && ray->state == PickedRay::State::Answered && ray->met && ray->taken);
        QVERIFY(ray->met->object == window->document().picks().pick()->object);
        const glm::dvec3 surface = ray->met->hit.world.coordinates(), taken = ray->taken->hit.world.coordinates();
        // The depth's point lies on the mesh, within its precision.
        const WorldPoint &formula = *window->document().picks().pick()->point.world[Method::Formula];
        QVERIFY(glm::length(formula.coordinates() - surface) < 1e-5);
        const glm::dvec3 way = glm::abs(taken - kCubeCenter);
        int onFaces = 0; // of an edge two, of a corner three
        for (int axis = 0; axis < 3; ++axis)
            onFaces += std::abs(way[axis] - 1.0) < 1e-9 ? 1 : 0;
        // The panel names the snap's target, from its headline on.
        const ComparisonPanel panel(window->document());
        const QString text = panel.text();
        switch (static_cast<Snap>(snap)) {
        case Snap::Surface: QVERIFY2(text.startsWith(QStringLiteral("cube\n")), qPrintable(text)); break;
        case Snap::Vertex:
            QVERIFY2(text.startsWith(QStringLiteral("Vertex %1 of ").arg(ray->taken->hit.vertex.id)), qPrintable(text));
            QVERIFY2(text.contains(QStringLiteral("The vertex is accurate to ± ")), qPrintable(text));
            break;
        case Snap::Edge:
            QVERIFY2(text.startsWith(QStringLiteral("A point of edge ")), qPrintable(text));
            QVERIFY2(text.contains(QStringLiteral("The point on the edge is accurate to ± ")), qPrintable(text));
            break;
        case Snap::Face:
            QVERIFY2(text.startsWith(QStringLiteral("A point of face ")), qPrintable(text));
            QVERIFY2(text.contains(QStringLiteral("The point on the face is accurate to ± ")), qPrintable(text));
            break;
        }
        switch (static_cast<Snap>(snap)) {
        case Snap::Surface: QVERIFY(taken == surface && onFaces == 1); break;
        case Snap::Vertex: QCOMPARE(glm::length(taken - kCorner), 0.0); break;
        case Snap::Edge: QVERIFY(onFaces == 2 && glm::length(taken - surface) < 0.2); break;
        case Snap::Face: QVERIFY(onFaces == 1 && glm::length(taken - surface) < 1e-12); break;
        }
    }

    void whatAClickWouldTakeIsMarked_data()
    {
        addColumn<int>("snap");
        addColumn<bool>("isMarked");
        newRow("surface") << int(Snap::Surface) << false;
        newRow("vertex") << int(Snap::Vertex) << true;
        newRow("edge") << int(Snap::Edge) << true;
        newRow("face") << int(Snap::Face) << true;
    }

    void whatAClickWouldTakeIsMarked()
    {
        QFETCH(int, snap);
        QFETCH(bool, isMarked);
        const auto window = cubeWindow(false);
        window->document().picks().setSnap(static_cast<Snap>(snap));
        const QPointF away(3.0, 3.0);
        hover(*window, away);
        const QImage before = pictureOf(*window);
        hover(*window, beside(*window, kCorner));
        const QImage marked = pictureOf(*window);
        QCOMPARE(differentPixels(before, marked) > 0, isMarked);
        hover(*window, away);
        QCOMPARE(differentPixels(before, pictureOf(*window)), 0);
        hover(*window, beside(*window, kCorner));
        window->document().picks().setSnap(Snap::Surface);
        QCOMPARE(differentPixels(before, pictureOf(*window)), 0);
    }
};

UNPROJECTOR_TEST(TestSnapModes, display)
#include "test_snap_modes.moc"
