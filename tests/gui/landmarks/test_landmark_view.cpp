// Placed points in the view: placed, selected and moved by mouse and by keys, and their display.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/landmark_placing.h"
#include "gui/document/landmark_views.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/landmark_loupe.h"
#include "gui/landmarks/landmark_marks.h"
#include "gui/landmarks/landmark_tool.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QAction>
#include <QImage>
#include <QMouseEvent>
#include <QStatusBar>
#include <QStyleHints>
#include <QToolTip>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

using namespace guitest;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;
using namespace unprojector::unproject;
using landmarks::Landmark;

namespace {

/// The middle of the cube's front face.
const glm::dvec3 kFront = kCubeCenter + glm::dvec3(0.0, 0.0, 1.0);

Landmark pointAt(const glm::dvec3 &world, const char *name)
{
    Landmark landmark;
    landmark.name = name;
    landmark.world = WorldPoint(world);
    return landmark;
}

const Landmark &only(MainWindow &window)
{
    return window.document().landmarks().front();
}

/// The position of a world point in the picture, origin top-left.
DevicePoint deviceOf(MainWindow &window, const glm::dvec3 &world)
{
    const glm::dvec2 place = placeOf(window, world);
    return {place.x, window.document().setup().surface.heightPixels - place.y};
}

/// A point on the front face, placed by the document.
void putPoint(MainWindow &window)
{
    const auto there = landmarkOnSurface(window.document(), deviceOf(window, kFront));
    QVERIFY(there);
    Landmark landmark = *there;
    landmark.name = "nasion";
    QVERIFY(editLandmarks(window.document(), {landmark}, {QStringLiteral("put")}));
}

/// Triggers the menu's action of a key.
void trigger(MainWindow &window, const QKeySequence &key)
{
    for (QAction *action : window.findChildren<QAction *>()) {
        if (action->shortcut() == key) {
            action->trigger();
            return;
        }
    }
    QFAIL(qPrintable(key.toString()));
}

double heightOverFront(const WorldPoint &point)
{
    return point.z - kFront.z;
}

} // namespace

class TestLandmarkView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void aClickPlacesOnRelease()
    {
        const auto window = cubeWindow(false);
        trigger(*window, Qt::Key_P);
        QVERIFY(part<LandmarkTool>(*window).isPlacing());
        const QPointF at = localOf(*window, kFront);
        sendMouse(window->view(), QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
        QVERIFY(window->document().landmarks().empty());
        sendMouse(window->view(), QEvent::MouseMove, at + QPointF(1, 0), Qt::NoButton, Qt::LeftButton);
        sendMouse(window->view(), QEvent::MouseButtonRelease, at + QPointF(1, 0), Qt::LeftButton, Qt::NoButton);
        QCOMPARE(window->document().landmarks().size(), std::size_t{1});
        QVERIFY(std::holds_alternative<landmarks::OnTriangle>(only(*window).anchor));
        QVERIFY(std::abs(heightOverFront(*only(*window).world)) < 1e-6);
        QVERIFY(std::abs(only(*window).world->x - kFront.x) < 0.05);
        QVERIFY(!window->document().picks().pick());
        QVERIFY(window->document().sceneLandmarks().current() == 0u);
        QCOMPARE(window->document().undoStack().undoText(), QStringLiteral("Place Landmark 1"));

        const LookAt camera = window->document().scene().camera;
        drag(window->view(), at + QPointF(30, 20), at + QPointF(80, 30), Qt::LeftButton);
        QCOMPARE(window->document().landmarks().size(), std::size_t{1});
        QVERIFY(window->document().scene().camera != camera);
        click(window->view(), QPointF(4, 4)); // the background
        QCOMPARE(window->document().landmarks().size(), std::size_t{1});
    }

    void outsidePlacingClicksPick()
    {
        const auto window = cubeWindow(false);
        click(window->view(), localOf(*window, kFront));
        QVERIFY(window->document().picks().pick());
        QVERIFY(window->document().landmarks().empty());
    }

    void marksFollowAPreviewedCamera()
    {
        const auto window = cubeWindow(false);
        putPoint(*window);
        const QPointF before = localOf(*window, kFront);
        for (int i = 0; i < 2; ++i) // the second changes nothing: the marks are known
            click(window->view(), before + QPointF(3, 2));
        SceneSettings settings = window->document().scene();
        LookAt camera = settings.camera;
        camera.eye += WorldVector(0.7, 0.0, 0.0);
        camera.center += WorldVector(0.7, 0.0, 0.0);
        settings.camera = camera;
        QVERIFY(window->document().preview(settings));
        const QPointF at = localOf(*window, kFront);
        QVERIFY(std::hypot(at.x() - before.x(), at.y() - before.y()) > 20.0);
        click(window->view(), at + QPointF(3, 2));
        QVERIFY(window->document().sceneLandmarks().selection() == std::vector<std::size_t>{0});
        QVERIFY(!window->document().picks().pick());
    }

    void aMarkIsSelectedAndDragged()
    {
        const auto window = cubeWindow(false);
        putPoint(*window);
        const QPointF at = localOf(*window, kFront);
        click(window->view(), at + QPointF(3, 2)); // beside its middle
        QVERIFY(window->document().sceneLandmarks().selection() == std::vector<std::size_t>{0});
        QVERIFY(!window->document().picks().pick());
        QVERIFY(length(*only(*window).world - WorldPoint(kFront)) < 1e-9); // a click moves nothing

        const int steps = window->document().undoStack().count();
        const LookAt camera = window->document().scene().camera;
        drag(window->view(), at + QPointF(3, 2), at + QPointF(23, 12), Qt::LeftButton);
        QCOMPARE(window->document().undoStack().count(), steps + 1);
        QCOMPARE(window->document().undoStack().undoText(), QStringLiteral("Move nasion"));
        QVERIFY(window->document().scene().camera == camera);
        QVERIFY(std::abs(heightOverFront(*only(*window).world)) < 1e-6);
        // The point went with the pointer: the grabbed position stays under it.
        const QPointF now = localOf(*window, only(*window).world->coordinates());
        QVERIFY(std::hypot(now.x() - at.x() - 20, now.y() - at.y() - 10) < 1e-6);
        // A point dragged off the mesh stays at the last position on it.
        drag(window->view(), now, QPointF(2, 2), Qt::LeftButton);
        QVERIFY(only(*window).world);
        QVERIFY(window->document().sceneLandmarks().all().size() == 1);
        window->document().undoStack().setIndex(steps);
        QVERIFY(length(*only(*window).world - WorldPoint(kFront)) < 1e-9);
        click(window->view(), QPointF(4, 4));
        QVERIFY(window->document().picks().pick()); // away from marks, clicks pick
    }

    void aPointNobodyChoseStaysWhereItIs()
    {
        const auto window = cubeWindow(false);
        putPoint(*window);
        const LookAt camera = window->document().scene().camera;
        const QPointF at = localOf(*window, kFront);
        drag(window->view(), at, at + QPointF(20, 10), Qt::LeftButton);
        QVERIFY(window->document().scene().camera != camera); // the view was turned
        QVERIFY(length(*only(*window).world - WorldPoint(kFront)) < 1e-9);
    }

    void selectedMarksAreDraggedTogether()
    {
        const auto window = cubeWindow(false);
        SceneDocument &document = window->document();
        putPoint(*window);
        const WorldPoint beside(kFront + glm::dvec3(0.3, 0.2, 0.0)), stays(kFront - glm::dvec3(0.3, 0.2, 0.0));
        QVERIFY(document.sceneLandmarks().place(pointAt(beside.coordinates(), "beside")));
        QVERIFY(document.sceneLandmarks().place(pointAt(stays.coordinates(), "stays")));
        document.sceneLandmarks().select({0, 1});
        const std::vector<Landmark> before = document.landmarks();
        const int steps = document.undoStack().count();
        const QPointF at = localOf(*window, kFront), other = localOf(*window, before[1].world->coordinates());
        drag(window->view(), at, at + QPointF(-12, 8), Qt::LeftButton);
        const std::vector<Landmark> &after = document.landmarks();
        const QPointF way = localOf(*window, after[0].world->coordinates()) - at;
        QVERIFY(std::hypot(way.x() + 12, way.y() - 8) < 1e-6);
        const QPointF otherWay = localOf(*window, after[1].world->coordinates()) - other;
        QVERIFY(std::hypot(otherWay.x() + 12, otherWay.y() - 8) < 1e-6);
        QVERIFY(after[2] == before[2]); // not selected
        QCOMPARE(document.undoStack().count(), steps + 1);
        document.undoStack().undo();
        QVERIFY(document.landmarks() == before);
    }

    void whatIsToldGoesWithTheView()
    {
        const auto window = cubeWindow(false);
        SceneView &view = window->view();
        std::vector<WidgetPoint> told;
        connect(&view, &SceneView::hovered, this, [&told](const PixelClick &click) { told.push_back(click.position); });
        sendMouse(view, QEvent::MouseMove, localOf(*window, kFront), Qt::NoButton, Qt::NoButton);
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), std::size_t(1), kPatienceMilliseconds);
        LookAt camera = window->document().scene().camera;
        camera.eye += WorldVector(0.2, 0.0, 0.0);
        setCamera(window->document(), camera); // as by a key, while the pointer rests
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), std::size_t(2), kPatienceMilliseconds);
        QVERIFY(told[0] == told[1]);
    }

    void escapeEndsADragAndThenPlacing()
    {
        const auto window = cubeWindow(false);
        putPoint(*window);
        part<LandmarkTool>(*window).setPlacing(true);
        const QPointF at = localOf(*window, kFront);
        sendMouse(window->view(), QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
        sendMouse(window->view(), QEvent::MouseMove, at + QPointF(30, 0), Qt::NoButton, Qt::LeftButton);
        QVERIFY(length(*only(*window).world - WorldPoint(kFront)) > 0.1);
        QTest::keyClick(&window->view(), Qt::Key_Escape);
        QVERIFY(length(*only(*window).world - WorldPoint(kFront)) < 1e-9);
        QVERIFY(part<LandmarkTool>(*window).isPlacing());
        sendMouse(window->view(), QEvent::MouseMove, at + QPointF(60, 0), Qt::NoButton, Qt::LeftButton);
        sendMouse(window->view(), QEvent::MouseButtonRelease, at + QPointF(60, 0), Qt::LeftButton, Qt::NoButton);
        QVERIFY(length(*only(*window).world - WorldPoint(kFront)) < 1e-9);
        QCOMPARE(window->document().landmarks().size(), std::size_t{1});
        QTest::keyClick(&window->view(), Qt::Key_Escape);
        QVERIFY(!part<LandmarkTool>(*window).isPlacing());
    }

    /// Each row: the second press, and whether it is refused.
    void aDoubleClickPlacesOneLandmark_data()
    {
        addColumn<QEvent::Type>("type");
        addColumn<QPointF>("way");
        addColumn<int>("share"); // of the double-click's interval after the first press, percent
        addColumn<bool>("isRefused");
        newRow("double-click") << QEvent::MouseButtonDblClick << QPointF(1, 0) << 50 << true;
        newRow("as a press") << QEvent::MouseButtonPress << QPointF(2, 0) << 50 << true;
        newRow("another point") << QEvent::MouseButtonPress << QPointF(20, 0) << 20 << false;
        newRow("later") << QEvent::MouseButtonPress << QPointF(2, 0) << 200 << false; // selects the marker
    }

    void aDoubleClickPlacesOneLandmark()
    {
        QFETCH(QEvent::Type, type);
        QFETCH(QPointF, way);
        QFETCH(int, share);
        QFETCH(bool, isRefused);
        for (const bool isLast : {false, true}) { // of a template: the first click ends placing
            const auto window = cubeWindow(false);
            SceneDocument &document = window->document();
            Landmark toPlace;
            toPlace.name = "only";
            if (isLast)
                QVERIFY(editLandmarks(document, {toPlace}, {QStringLiteral("template")}));
            document.picks().rayCasters().complete(document.objects());
            part<LandmarkTool>(*window).setPlacing(true);
            SceneView &view = window->view();
            const auto click = [&view](QEvent::Type press, const QPointF &at, quint64 milliseconds) {
                for (const bool isPress : {true, false}) {
                    QMouseEvent event(isPress ? press : QEvent::MouseButtonRelease, at, view.mapToGlobal(at),
                                      Qt::LeftButton, isPress ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
                    event.setTimestamp(milliseconds);
                    QCoreApplication::sendEvent(&view, &event);
                }
            };
            const QPointF at = localOf(*window, kFront);
            const LookAt camera = *document.scene().camera;
            const auto wait = quint64(QGuiApplication::styleHints()->mouseDoubleClickInterval() * share / 100);
            click(QEvent::MouseButtonPress, at, 10000);
            QCOMPARE(document.landmarks().size(), std::size_t(1));
            const Landmark first = document.landmarks()[0];
            QVERIFY(first.isPlaced());
            click(type, at + way, 10000 + wait);
            QVERIFY(document.scene().camera == camera);
            QVERIFY(document.landmarks()[0] == first);
            QCOMPARE(QToolTip::text().contains(QStringLiteral("double-click places nothing")), isRefused);
            if (isRefused) { // nor does a third click
                click(QEvent::MouseButtonPress, at + way, 10000 + wait + wait);
                QCOMPARE(document.landmarks().size(), std::size_t(1));
            } else if (!isLast) {
                QCOMPARE(document.landmarks().size(), std::size_t(way.x() > 10.0 ? 2 : 1));
            }
            QToolTip::hideText();
            QTRY_VERIFY_WITH_TIMEOUT(!QToolTip::isVisible(), kPatienceMilliseconds);
        }
    }

    void arrowKeysMoveByPixels_data()
    {
        addColumn<int>("key");
        addColumn<int>("modifiers");
        addColumn<QPointF>("way"); // device pixels, y up
        newRow("right") << int(Qt::Key_Right) << int(Qt::NoModifier) << QPointF(1, 0);
        newRow("up") << int(Qt::Key_Up) << int(Qt::NoModifier) << QPointF(0, 1);
        newRow("ten to the left") << int(Qt::Key_Left) << int(Qt::ShiftModifier) << QPointF(-10, 0);
        newRow("a tenth down") << int(Qt::Key_Down) << int(Qt::AltModifier) << QPointF(0, -0.1);
    }

    void arrowKeysMoveByPixels()
    {
        QFETCH(int, key);
        QFETCH(int, modifiers);
        QFETCH(QPointF, way);
        const auto window = cubeWindow(false);
        putPoint(*window);
        window->document().sceneLandmarks().selectOnly(0);
        const LookAt camera = window->document().scene().camera;
        part<LandmarkTool>(*window).setPlacing(true);
        const glm::dvec2 before = placeOf(*window, only(*window).world->coordinates());
        const int steps = window->document().undoStack().count();
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&window->view(), Qt::Key(key), Qt::KeyboardModifiers(modifiers));
        const glm::dvec2 after = placeOf(*window, only(*window).world->coordinates());
        QVERIFY(glm::length(after - before - 3.0 * glm::dvec2(way.x(), way.y())) < 1e-6);
        QVERIFY(std::abs(heightOverFront(*only(*window).world)) < 1e-6);
        QCOMPARE(window->document().undoStack().count(), steps + 1);
        QVERIFY(window->document().scene().camera == camera);
        // Otherwise they turn the view.
        part<LandmarkTool>(*window).setPlacing(false);
        QTest::keyClick(&window->view(), Qt::Key_Right);
        QVERIFY(window->document().scene().camera != camera);
    }

    void arrowKeysMoveAllThatIsSelected()
    {
        const auto window = cubeWindow(false);
        SceneDocument &document = window->document();
        Landmark missing = pointAt(kFront, "missing");
        missing.world.reset();
        QVERIFY(editLandmarks(document,
                              {pointAt(kFront, "a"), pointAt(kFront + glm::dvec3(0.4, 0.3, 0.0), "b"),
                               pointAt(kFront - glm::dvec3(0.4, 0.3, 0.0), "not selected"),
                               pointAt(kCubeCenter, "behind"), missing},
                              {QStringLiteral("put")}));
        document.picks().rayCasters().complete(document.objects());
        document.sceneLandmarks().select({0, 1, 3, 4}, 1);
        part<LandmarkTool>(*window).setPlacing(true);
        const std::vector<Landmark> before = document.landmarks();
        const int steps = document.undoStack().count();
        QTest::keyClick(&window->view(), Qt::Key_Right);
        QTest::keyClick(&window->view(), Qt::Key_Right);
        const std::vector<Landmark> &after = document.landmarks();
        for (const std::size_t index : {0u, 1u}) {
            const glm::dvec2 from = placeOf(*window, before[index].world->coordinates()),
                             to = placeOf(*window, after[index].world->coordinates());
            QVERIFY(glm::length(to - from - glm::dvec2(2.0, 0.0)) < 1e-6);
        }
        QVERIFY(after[2] == before[2] && after[3] == before[3] && after[4] == before[4]);
        QCOMPARE(document.undoStack().count(), steps + 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Move 2 landmarks"));
        document.undoStack().undo();
        QVERIFY(document.landmarks() == before);
    }

    void deleteRemovesWhatIsSelected()
    {
        const auto window = cubeWindow(false);
        QVERIFY(editLandmarks(window->document(), {pointAt(kFront, "a"), pointAt(kCubeCenter, "b")},
                              {QStringLiteral("put")}));
        QTest::keyClick(&window->view(), Qt::Key_Delete);
        QCOMPARE(window->document().landmarks().size(), std::size_t{2});
        window->document().sceneLandmarks().selectOnly(0);
        QTest::keyClick(&window->view(), Qt::Key_Delete);
        QCOMPARE(window->document().landmarks().size(), std::size_t{1});
        QCOMPARE(only(*window).name, std::string("b"));
        QTest::keyClick(&window->view(), Qt::Key_Delete); // nothing is selected any more
        QCOMPARE(window->document().landmarks().size(), std::size_t{1});
    }

    void marksSayWhatIsBehind()
    {
        const auto window = cubeWindow(false);
        Landmark hidden = pointAt(kFront, "hidden"), missing = pointAt(kFront, "missing");
        hidden.isHidden = true;
        missing.world.reset();
        QVERIFY(editLandmarks(
            window->document(),
            {pointAt(kFront, "front"), pointAt(kCubeCenter - glm::dvec3(0, 0, 1), "back"), hidden, missing,
             pointAt(kCubeCenter + glm::dvec3(0, 2, 0), "above"),
             pointAt(kFront - glm::dvec3(0, 0, 1e-4), "a little inside"),
             pointAt(window->document().scene().camera->eye.coordinates() + glm::dvec3(4, 3, 5), "behind the eye")},
            {QStringLiteral("put")}));
        const std::vector<LandmarkMark> marks = landmarkMarks(window->document());
        QStringList seen, behind;
        for (const LandmarkMark &mark : marks) {
            const QString name = QString::fromStdString(window->document().landmarks()[mark.index].name);
            (mark.isBehind ? behind : seen) << name;
            QCOMPARE(mark.label.contains(QStringLiteral("behind")), mark.isBehind);
            QCOMPARE(landmarkTip(window->document(), mark).contains(QStringLiteral("hides it")), mark.isBehind);
            const DevicePoint at = deviceOf(*window, window->document().landmarks()[mark.index].world->coordinates());
            const double ratio = window->document().setup().surface.devicePixelRatio;
            QVERIFY(std::hypot(at.x - ratio * mark.at.x(), at.y - ratio * mark.at.y()) < 1e-6);
        }
        QCOMPARE(seen, QStringList({"front", "above", "a little inside"}));
        QCOMPARE(behind, QStringList("back"));
        // A point that is cut away is hidden; one that a plane has laid open is visible.
        setClipPlanes(window->document(), {{0, 0, -1, kCubeCenter.z - 0.5}});
        for (const LandmarkMark &mark : landmarkMarks(window->document())) {
            const std::string &name = window->document().landmarks()[mark.index].name;
            if (name == "front")
                QVERIFY(mark.isBehind);
            if (name == "back")
                QVERIFY(!mark.isBehind);
        }
    }

    void aMarkBehindTakesNoClick()
    {
        const auto window = cubeWindow(false);
        // A point on the back face, seen through the middle of the front.
        const glm::dvec3 eye = window->document().scene().camera->eye.coordinates();
        const glm::dvec3 along = kFront - eye;
        const glm::dvec3 back = eye + along * ((kCubeCenter.z - 1.0 - eye.z) / along.z);
        SceneDocument &document = window->document();
        QVERIFY(editLandmarks(document, {pointAt(back, "back")}, {QStringLiteral("put")}));
        const QPointF at = localOf(*window, kFront);
        const std::vector<LandmarkMark> marks = landmarkMarks(document);
        QVERIFY(marks.size() == 1 && marks[0].isBehind);
        QVERIFY(markUnder(marks, at) && !markUnder(marks, at, true));
        click(window->view(), at);
        QVERIFY(document.sceneLandmarks().selection().empty());
        QVERIFY(document.picks().pick()); // the object in front is read
        trigger(*window, Qt::Key_P);
        click(window->view(), at);
        QCOMPARE(document.landmarks().size(), std::size_t(2)); // and placed on
        QVERIFY(std::abs(heightOverFront(*document.landmarks()[1].world)) < 1e-6);
    }

    void everyObjectCountsItsOwnTriangles()
    {
        const auto window = twoCubesWindow();
        SceneDocument &document = window->document();
        QCOMPARE(renameObject(document, 1, QStringLiteral("second")), NameFault::None);
        document.picks().rayCasters().complete(document.objects());
        // The first cube hides the second there, so its triangle is hit; the second has one of the same
        // index.
        const DevicePoint at = deviceOf(*window, kTwoCubeCenters[1]);
        const std::optional<Landmark> front = landmarkOnSurface(document, at);
        QVERIFY(front && std::holds_alternative<landmarks::OnTriangle>(front->anchor));
        QCOMPARE(front->object, document.objects()[0].name);
        Landmark hidden = *front;
        hidden.world = WorldPoint(kTwoCubeCenters[1]);
        QVERIFY(editLandmarks(document, {hidden}, {QStringLiteral("put")}));
        QVERIFY(!landmarkMarks(document)[0].isBehind); // of one triangle, its flatness is no depth
        hidden.object = document.objects()[1].name;
        QVERIFY(editLandmarks(document, {hidden}, {QStringLiteral("put")}));
        QVERIFY(landmarkMarks(document)[0].isBehind);
    }

    void hiddenPointsAreNotMovedNorRemoved()
    {
        const auto window = cubeWindow(false);
        SceneDocument &document = window->document();
        putPoint(*window);
        QVERIFY(document.sceneLandmarks().place(pointAt(kFront + glm::dvec3(0.2, 0.0, 0.0), "seen")));
        trigger(*window, Qt::Key_P);
        document.sceneLandmarks().select({0, 1}, 0);
        QVERIFY(document.sceneLandmarks().setHidden({0}, true));
        const std::vector<Landmark> before = document.landmarks();
        const LookAt camera = document.scene().camera;
        QTest::keyClick(&window->view(), Qt::Key_Right);
        QVERIFY(document.landmarks() == before);
        QVERIFY(document.scene().camera != camera); // nothing can be moved: the drag turns the view
        QTest::keyClick(&window->view(), Qt::Key_Delete);
        QCOMPARE(document.landmarks().size(), std::size_t(1));
        QCOMPARE(only(*window).name, std::string("nasion"));
        QTest::keyClick(&window->view(), Qt::Key_Delete); // hidden, it stays
        QCOMPARE(document.landmarks().size(), std::size_t(1));
    }

    void aDragEndsWithItsPoint()
    {
        const auto window = cubeWindow(false);
        SceneDocument &document = window->document();
        putPoint(*window);
        const Landmark other = pointAt(kFront + glm::dvec3(0.5, 0.5, 0.0), "other");
        QVERIFY(document.sceneLandmarks().place(other));
        document.sceneLandmarks().selectOnly(0);
        const QPointF at = localOf(*window, kFront);
        sendMouse(window->view(), QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
        sendMouse(window->view(), QEvent::MouseMove, at + QPointF(12, 0), Qt::NoButton, Qt::LeftButton);
        QVERIFY(length(*only(*window).world - WorldPoint(kFront)) > 1e-3);
        QVERIFY(document.sceneLandmarks().remove({0})); // as by a key of the window: another point has its index now
        sendMouse(window->view(), QEvent::MouseMove, at + QPointF(30, 0), Qt::NoButton, Qt::LeftButton);
        sendMouse(window->view(), QEvent::MouseButtonRelease, at + QPointF(30, 0), Qt::LeftButton, Qt::NoButton);
        QVERIFY(only(*window) == other);
    }

    void marksAreInThePicture()
    {
        const auto window = cubeWindow(false);
        const QImage without = window->view().grabFramebuffer();
        Landmark landmark = pointAt(kFront, "nasion");
        landmark.color = glm::u8vec3(250, 20, 200);
        QVERIFY(editLandmarks(window->document(), {landmark}, {QStringLiteral("put")}));
        const QImage with = window->view().grabFramebuffer();
        const glm::dvec2 place = placeOf(*window, kFront);
        const double ratio = with.devicePixelRatio();
        const QColor there = with.pixelColor(int(place.x + 2.5 * ratio), int(with.height() - place.y));
        QVERIFY2(std::abs(there.red() - 250) < 12 && std::abs(there.green() - 20) < 12
                     && std::abs(there.blue() - 200) < 12,
                 qPrintable(there.name()));
        QVERIFY(differentPixels(without, with) > 200); // with its label
        // The rest of the picture is unchanged.
        QVERIFY(window->document().sceneLandmarks().setHidden({0}, true));
        QCOMPARE(differentPixels(without, window->view().grabFramebuffer()), 0);
    }

    void labelsNeverOverlap_data()
    {
        addColumn<int>("count");
        addColumn<double>("spread");
        newRow("a few far apart") << 8 << 700.0;
        newRow("a few at one place") << 8 << 1.0;
        newRow("500 all over") << 500 << 760.0;
        newRow("500 in a heap") << 500 << 120.0;
    }

    void labelsNeverOverlap()
    {
        QFETCH(int, count);
        QFETCH(double, spread);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<LandmarkMark> marks;
        for (int i = 0; i < count; ++i) {
            LandmarkMark mark;
            mark.index = static_cast<std::size_t>(i);
            mark.at = QPointF(20.0 + spread * share(random), 20.0 + 0.7 * spread * share(random));
            mark.isCurrent = mark.isSelected = i == count / 2;
            mark.label = QStringLiteral("point %1").arg(i + 1);
            marks.push_back(mark);
        }
        const QRectF area(0, 0, 800, 600);
        const QFontMetricsF metrics(QFont(QStringLiteral("sans"), 10));
        const QPointF current = marks[static_cast<std::size_t>(count / 2)].at;
        const std::vector<QLineF> arrows{{current, current + QPointF(50.0, 5.0)},
                                         {current, current - QPointF(0.0, 50.0)}};
        const std::vector<PlacedLabel> labels = placedLabels(marks, metrics, area);
        QVERIFY(!labels.empty());
        for (const PlacedLabel &label : placedLabels(marks, metrics, area, arrows)) {
            for (const QLineF &arrow : arrows) {
                for (const double way : {0.2, 0.4, 0.6, 0.8, 1.0})
                    QVERIFY(!label.box.contains(arrow.pointAt(way)));
            }
        }
        QVERIFY(marks[labels.front().mark].isCurrent);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QVERIFY(area.contains(labels[i].box));
            QVERIFY(labels[i].box.width() >= metrics.horizontalAdvance(marks[labels[i].mark].label));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!labels[i].box.intersects(labels[j].box));
            for (const LandmarkMark &mark : marks)
                QVERIFY(!labels[i].box.contains(mark.at));
        }
        if (count < 10)
            QCOMPARE(labels.size(), marks.size());
    }

    void theCameraFacesThePoint()
    {
        const auto window = cubeWindow(false);
        putPoint(*window);
        window->document().sceneLandmarks().selectOnly(0);
        const double away = distance(window->document().scene().camera->eye, window->document().scene().camera->center);
        trigger(*window, Qt::Key_G);
        const LookAt camera = window->document().scene().camera;
        QVERIFY(distance(camera.center, WorldPoint(kFront)) < 1e-9);
        QVERIFY(distance(camera.eye, WorldPoint(kFront + away * glm::dvec3(0, 0, 1))) < 1e-6);
        // Onto a face that looks up, where "up" is no side.
        const SceneObject &cube = window->document().objects()[0];
        for (std::uint32_t triangle = 0; triangle < 12; ++triangle) {
            const auto normal = normalAt(landmarks::OnTriangle{triangle, glm::dvec3(1.0 / 3.0)}, cube);
            QVERIFY(normal && std::abs(length(*normal) - 1.0) < 1e-12);
            Landmark landmark;
            landmark.world = WorldPoint(kCubeCenter + normal->coordinates());
            landmark.object = cube.name;
            landmark.anchor = landmarks::OnTriangle{triangle, glm::dvec3(1.0 / 3.0)};
            QVERIFY(editLandmarks(window->document(), {landmark}, {QStringLiteral("put")}));
            goToLandmark(window->document(), 0);
            const LookAt there = window->document().scene().camera;
            QVERIFY(std::abs(dot(normalized(there.eye - there.center), *normal) - 1.0) < 1e-9);
            const std::vector<LandmarkMark> marks = landmarkMarks(window->document());
            QCOMPARE(marks.size(), std::size_t{1});
            QVERIFY(!marks[0].isBehind);
        }
    }

    void theZoomIsAsCloseAsAsked()
    {
        const auto window = cubeWindow(false);
        putPoint(*window);
        goToLandmark(window->document(), 0);
        for (const double half : {0.01, 1e-4, 0.05}) {
            zoomToLandmark(window->document(), 0, half);
            const auto there = landmarkOnSurface(window->document(), deviceOf(*window, kFront));
            QVERIFY(there);
            QVERIFY(std::abs(there->uncertainty->x - half) < 0.01 * half);
            QVERIFY(std::abs(there->uncertainty->y - half) < 0.01 * half);
        }
    }

    void pointsGoBackOntoTheSurface()
    {
        const auto window = cubeWindow(false);
        SceneDocument &document = window->document();
        QVERIFY(editLandmarks(document, {pointAt(kFront + glm::dvec3(0.25, 0.5, 0.75), "a"), pointAt(kFront, "b")},
                              {QStringLiteral("put")}));
        document.sceneLandmarks().selectOnly(0);
        const int steps = document.undoStack().count();
        trigger(*window, Qt::Key_B);
        QVERIFY(distance(*only(*window).world, WorldPoint(kFront + glm::dvec3(0.25, 0.5, 0.0))) < 1e-6);
        QVERIFY(std::holds_alternative<landmarks::OnTriangle>(only(*window).anchor));
        QCOMPARE(only(*window).object, document.objects()[0].name);
        QCOMPARE(document.undoStack().count(), steps + 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Put a on the surface"));
        QVERIFY(std::holds_alternative<landmarks::Free>(document.landmarks()[1].anchor)); // not selected
    }

    void keysForPointsSayThatThereIsNone_data()
    {
        addColumn<QKeySequence>("key");
        addColumn<bool>("isMissing");
        newRow("go, nothing selected") << QKeySequence(Qt::Key_G) << false;
        newRow("go, a missing point") << QKeySequence(Qt::Key_G) << true;
        newRow("zoom") << QKeySequence(Qt::SHIFT | Qt::Key_G) << false;
        newRow("back, nothing selected") << QKeySequence(Qt::Key_B) << false;
        newRow("back, a missing point") << QKeySequence(Qt::Key_B) << true;
        newRow("join") << QKeySequence(Qt::Key_J) << false;
        newRow("join one point") << QKeySequence(Qt::SHIFT | Qt::Key_J) << true;
    }

    void keysForPointsSayThatThereIsNone()
    {
        QFETCH(QKeySequence, key);
        QFETCH(bool, isMissing);
        const auto window = cubeWindow(false);
        SceneDocument &document = window->document();
        if (isMissing) {
            Landmark landmark;
            landmark.name = "nasion";
            QVERIFY(editLandmarks(document, {landmark}, {QStringLiteral("put")}));
            document.sceneLandmarks().selectOnly(0);
        }
        const int steps = document.undoStack().count();
        window->statusBar()->clearMessage();
        trigger(*window, key);
        QVERIFY2(window->statusBar()->currentMessage().startsWith(QStringLiteral("Select ")),
                 qPrintable(window->statusBar()->currentMessage()));
        QCOMPARE(document.undoStack().count(), steps);
    }

    void theLoupeShowsThePlace()
    {
        const auto window = cubeWindow(false);
        const QPointF at = localOf(*window, kFront);
        sendMouse(window->view(), QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
        const QImage without = window->view().grabFramebuffer();
        const Surface &surface = window->document().setup().surface;
        const DevicePoint place = deviceFromWidget(surface, WidgetPoint(at.x(), at.y()));
        const QRectF box = loupeBox(surface, place);
        QVERIFY(!box.contains(at));
        QVERIFY(loupeBox(surface, deviceFromWidget(surface, {box.center().x(), box.center().y()})) != box);
        part<LandmarkTool>(*window).setPlacing(true);
        sendMouse(window->view(), QEvent::MouseMove, at + QPointF(1, 0), Qt::NoButton, Qt::NoButton);
        const QImage with = window->view().grabFramebuffer();
        // The loupe shows the blue face; outside, the picture is the same.
        const double ratio = with.devicePixelRatio();
        const QPointF inside = box.topLeft() + QPointF(20.5, 20.5);
        QCOMPARE(faceOfColor(with.pixelColor((inside * ratio).toPoint())), 4);
        QVERIFY(with.pixelColor((at * ratio).toPoint()) == without.pixelColor((at * ratio).toPoint()));
        QVERIFY(differentPixels(without, with) > 1000);
        // The loupe also shows the edges of the face where they are near.
        const QPointF corner = localOf(*window, kCubeCenter + glm::dvec3(1, 0, 1));
        const ray::SceneRays *rays = window->document().picks().rays();
        QVERIFY(rays);
        QVERIFY(loupeEdges(*rays, deviceFromWidget(surface, {corner.x(), corner.y()})).size() >= 6);
        part<LandmarkTool>(*window).setPlacing(false);
        QCOMPARE(differentPixels(without, window->view().grabFramebuffer()), 0);
    }

    void arrowsMoveOffTheSurface_data()
    {
        addColumn<int>("axis");
        newRow("x") << 0;
        newRow("y") << 1;
        newRow("z") << 2;
    }

    void arrowsMoveOffTheSurface()
    {
        QFETCH(int, axis);
        const auto window = cubeWindow(false);
        putPoint(*window);
        SceneDocument &document = window->document();
        document.sceneLandmarks().selectOnly(0);
        part<LandmarkTool>(*window).setPlacing(true);
        QVERIFY(part<LandmarkTool>(*window).setArrowsShown(true));
        const std::array<AxisArrow, 3> arrows = axisArrows(document.setup(), *only(*window).world);
        const AxisArrow &arrow = arrows[static_cast<std::size_t>(axis)];
        QVERIFY(arrow.isUsable);
        const QPointF grabbed = arrow.from + 0.7 * (arrow.to - arrow.from);
        QVERIFY(axisUnder(arrows, grabbed) == axis);
        const int steps = document.undoStack().count();
        drag(window->view(), grabbed, grabbed + 0.5 * (arrow.to - arrow.from), Qt::LeftButton);
        QCOMPARE(document.undoStack().count(), steps + 1);
        QVERIFY(std::holds_alternative<landmarks::Free>(only(*window).anchor));
        const glm::dvec3 way = only(*window).world->coordinates() - kFront;
        QVERIFY(way[axis] > 0.05);
        QVERIFY(std::abs(way[(axis + 1) % 3]) < 1e-12 && std::abs(way[(axis + 2) % 3]) < 1e-12);
        // The grabbed position went with the pointer: both moves are one share of the arrow, but for
        // perspective.
        const QPointF from = localOf(*window, kFront), to = localOf(*window, only(*window).world->coordinates());
        QVERIFY(std::hypot(to.x() - from.x() - 0.5 * (arrow.to - arrow.from).x(),
                           to.y() - from.y() - 0.5 * (arrow.to - arrow.from).y())
                < 6.0);
        document.undoStack().undo();
        QVERIFY(std::holds_alternative<landmarks::OnTriangle>(only(*window).anchor));
    }

    void windowsAreGrabbedWithTheirPoints()
    {
        const auto window = cubeWindow(false);
        Landmark landmark = pointAt(kFront, "nasion");
        landmark.color = glm::u8vec3(250, 20, 200);
        QVERIFY(editLandmarks(window->document(), {landmark}, {QStringLiteral("put")}));
        const QImage picture = window->grab().toImage();
        const QPointF at = window->view().mapTo(window.get(), localOf(*window, kFront));
        const QColor there = picture.pixelColor(((at + QPointF(2.5, 0)) * picture.devicePixelRatio()).toPoint());
        QVERIFY2(std::abs(there.red() - 250) < 12 && std::abs(there.green() - 20) < 12, qPrintable(there.name()));
    }
};

UNPROJECTOR_TEST(TestLandmarkView, display, at 1.5)
#include "test_landmark_view.moc"
