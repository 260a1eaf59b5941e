// The arrows, marks and labels of landmarks in the view: when they appear, and the user's choices.

#include "tests/support/test.h"

#include "gui/document/landmark_placing.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/axis_dragger.h"
#include "gui/landmarks/landmark_looks.h"
#include "gui/landmarks/landmark_loupe.h"
#include "gui/landmarks/landmark_marks.h"
#include "gui/landmarks/landmark_tool.h"
#include "tests/gui/window_user.h"

#include <QAction>
#include <QImage>
#include <QPainter>
#include <QSettings>
#include <QStatusBar>

#include <array>
#include <vector>

using namespace guitest;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using landmarks::Landmark;

namespace {

/// The middle of the cube's front face.
const glm::dvec3 kFront = kCubeCenter + glm::dvec3(0.0, 0.0, 1.0);

Landmark named(const char *name)
{
    Landmark landmark;
    landmark.name = name;
    return landmark;
}

/// A window with a selected landmark in the middle of the front face, and as many names that wait.
std::unique_ptr<MainWindow> windowWithLandmark(int waiting = 0)
{
    std::unique_ptr<MainWindow> window = cubeWindow(false);
    SceneDocument &document = window->document();
    const glm::dvec2 place = placeOf(*window, kFront);
    std::vector<Landmark> landmarks{
        landmarkOnSurface(document, {place.x, document.setup().surface.heightPixels - place.y}).value()};
    landmarks.front().name = "nasion";
    for (int i = 0; i < waiting; ++i)
        landmarks.push_back(named(i == 0 ? "bregma" : "lambda"));
    static_cast<void>(editLandmarks(document, landmarks, {QStringLiteral("put")}));
    document.sceneLandmarks().selectOnly(0);
    if (waiting > 0)
        document.sceneLandmarks().setNextUnplaced(1);
    return window;
}

/// A position on the arrow along x of the first landmark.
QPointF onArrow(MainWindow &window)
{
    const AxisArrow arrow = axisArrows(window.document().setup(), *window.document().landmarks()[0].world)[0];
    return arrow.from + 0.7 * (arrow.to - arrow.from);
}

void pointAt(MainWindow &window, const QPointF &local)
{
    sendMouse(window.view(), QEvent::MouseMove, local, Qt::NoButton, Qt::NoButton);
}

/// Drags from the place of the arrow. @return whether the first landmark moved
bool dragsLandmark(MainWindow &window)
{
    const WorldPoint before = *window.document().landmarks()[0].world;
    const QPointF at = onArrow(window);
    drag(window.view(), at, at + QPointF(24, 0), Qt::LeftButton);
    return *window.document().landmarks()[0].world != before;
}

QImage pictureOf(const std::vector<LandmarkMark> &marks, double radius)
{
    QImage image(80, 80, QImage::Format_RGB32);
    image.fill(Qt::gray);
    QPainter painter(&image);
    drawLandmarks(painter, marks, {}, radius);
    return image;
}

/// The number of pixels that differ from the ground.
int drawnPixels(const QImage &image)
{
    QImage ground(image.size(), image.format());
    ground.fill(Qt::gray);
    return differentPixels(image, ground);
}

LandmarkMark markInMiddle()
{
    LandmarkMark mark;
    mark.at = QPointF(40.0, 40.0);
    mark.color = Qt::red;
    return mark;
}

void choose(MainWindow &window, const char *text)
{
    QAction *action = actionOf(window, QLatin1String(text));
    QVERIFY2(action, text);
    action->trigger();
}

} // namespace

class TestLandmarkLooks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void init() { QSettings().clear(); }

    void noArrowsAppearUnasked()
    {
        const auto window = windowWithLandmark();
        part<LandmarkTool>(*window).setPlacing(true);
        const LookAt camera = window->document().scene().camera;
        QVERIFY(!dragsLandmark(*window));
        QVERIFY(window->document().scene().camera != camera);
    }

    void aClickOnAnArrowPlaces_data()
    {
        addColumn<int>("waiting");
        addColumn<bool>("hasArrows");
        newRow("no arrows") << 0 << false;
        newRow("arrows by key") << 0 << true;
        newRow("a name waits, no arrows") << 2 << false;
        newRow("a name waits, arrows by key") << 2 << true;
    }

    void aClickOnAnArrowPlaces()
    {
        QFETCH(int, waiting);
        QFETCH(bool, hasArrows);
        const auto window = windowWithLandmark(waiting);
        const std::vector<Landmark> &landmarks = window->document().landmarks();
        const Landmark before = landmarks[0];
        auto &tool = part<LandmarkTool>(*window);
        tool.setPlacing(true);
        QVERIFY(tool.setArrowsShown(hasArrows));
        const QPointF at = onArrow(*window);
        click(window->view(), at);
        QVERIFY(landmarks[0] == before);
        QVERIFY(landmarks.size() > 1 && landmarks[1].isPlaced());
        const QPointF placed = localOf(*window, landmarks[1].world->coordinates());
        QVERIFY(std::hypot(placed.x() - at.x(), placed.y() - at.y()) < 1.0);
        // Its arrows went with the selection.
        const LookAt camera = window->document().scene().camera;
        drag(window->view(), at + QPointF(0, 40), at + QPointF(30, 40), Qt::LeftButton);
        QVERIFY(window->document().scene().camera != camera);
    }

    /// Landmarks may be closer to each other than a mark is large.
    void aClickOnAMarkPlacesTheNameThatWaits()
    {
        const auto window = windowWithLandmark(2);
        const std::vector<Landmark> &landmarks = window->document().landmarks();
        const Landmark before = landmarks[0];
        part<LandmarkTool>(*window).setPlacing(true);
        const QPointF at = localOf(*window, kFront) + QPointF(3, 0);
        click(window->view(), at);
        QVERIFY(landmarks[0] == before);
        QVERIFY(landmarks[1].isPlaced());
        const QPointF placed = localOf(*window, landmarks[1].world->coordinates());
        QVERIFY(std::hypot(placed.x() - at.x(), placed.y() - at.y()) < 1.0);
        // A drag still moves the mark.
        const LookAt camera = window->document().scene().camera;
        drag(window->view(), localOf(*window, kFront), localOf(*window, kFront) + QPointF(-30, 0), Qt::LeftButton);
        QVERIFY(window->document().scene().camera == camera);
        QVERIFY(!landmarks[2].isPlaced());
    }

    void aClickOnAnArrowPicksOutsidePlacing()
    {
        const auto window = windowWithLandmark();
        QVERIFY(part<LandmarkTool>(*window).setArrowsShown(true));
        click(window->view(), onArrow(*window));
        QVERIFY(window->document().picks().pick());
        QVERIFY(dragsLandmark(*window)); // they are still there
    }

    void thePointerShowsTheArrows()
    {
        const auto window = windowWithLandmark();
        const QPointF mark = localOf(*window, kFront), arrow = onArrow(*window);
        pointAt(*window, mark + QPointF(0, 30));
        pointAt(*window, mark);
        for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) // along the arrow
            pointAt(*window, mark + share * (arrow - mark));
        QVERIFY(dragsLandmark(*window));
        QVERIFY(std::holds_alternative<landmarks::Free>(window->document().landmarks()[0].anchor));
        window->document().undoStack().undo();
        pointAt(*window, mark + QPointF(0, 60)); // away from mark and arrows
        QVERIFY(!dragsLandmark(*window));
    }

    void thePointerShowsNoneWhileANameWaits()
    {
        const auto window = windowWithLandmark(1);
        part<LandmarkTool>(*window).setPlacing(true);
        const QPointF mark = localOf(*window, kFront);
        pointAt(*window, mark + QPointF(0, 30));
        pointAt(*window, mark);
        QVERIFY(!dragsLandmark(*window));
    }

    void aPlacementShowsNoArrows()
    {
        const auto window = cubeWindow(false);
        part<LandmarkTool>(*window).setPlacing(true);
        const QPointF mark = localOf(*window, kFront);
        pointAt(*window, mark);
        click(window->view(), mark);
        pointAt(*window, mark + QPointF(1, 0)); // the pointer is still on the new mark
        QVERIFY(!dragsLandmark(*window));
        const QPointF now = localOf(*window, window->document().landmarks()[0].world->coordinates());
        pointAt(*window, now + QPointF(0, 30));
        pointAt(*window, now); // the user comes back to it
        QVERIFY(dragsLandmark(*window));
    }

    void aKeyShowsTheArrows()
    {
        const auto window = windowWithLandmark();
        SceneDocument &document = window->document();
        QAction *arrows = actionOf(*window, QStringLiteral("Axis Arrows"));
        QVERIFY(arrows);
        QCOMPARE(arrows->shortcut(), QKeySequence(Qt::Key_A));
        const QImage without = window->view().grabFramebuffer();
        arrows->trigger();
        QVERIFY(arrows->isChecked());
        QVERIFY(differentPixels(without, window->view().grabFramebuffer()) > 100);
        arrows->trigger();
        QVERIFY(!arrows->isChecked());
        QCOMPARE(differentPixels(without, window->view().grabFramebuffer()), 0);
        // They end with the selection.
        arrows->trigger();
        document.sceneLandmarks().clearSelection();
        QVERIFY(!arrows->isChecked());
        window->statusBar()->clearMessage();
        arrows->trigger();
        QVERIFY(!arrows->isChecked());
        QVERIFY2(window->statusBar()->currentMessage().startsWith(QStringLiteral("Select ")),
                 qPrintable(window->statusBar()->currentMessage()));
    }

    void aFreeLandmarkLooksDifferent()
    {
        const auto window = windowWithLandmark();
        SceneDocument &document = window->document();
        QVERIFY(!landmarkMarks(document)[0].isFree);
        QVERIFY(document.sceneLandmarks().moveTo(0, WorldPoint(kFront + glm::dvec3(0.1, 0.0, 0.2)), {}));
        const LandmarkMark moved = landmarkMarks(document)[0];
        QVERIFY(moved.isFree);
        QVERIFY2(landmarkTip(document, moved).contains(QStringLiteral("free")),
                 qPrintable(landmarkTip(document, moved)));
        // However certain it is: a file may give a free landmark's uncertainty.
        landmarks::LandmarkSet set = document.scene().landmarks;
        set.landmarks[0].uncertainty = WorldVector(0.1, 0.1, 0.1);
        QVERIFY(editLandmarkSet(document, std::move(set), {QStringLiteral("test")}));
        QVERIFY(landmarkMarks(document)[0].isFree);
        LandmarkMark disc = markInMiddle(), diamond = disc;
        diamond.isFree = true;
        QVERIFY(differentPixels(pictureOf({disc}, kMarkRadius), pictureOf({diamond}, kMarkRadius)) > 10);
        disc.isBehind = diamond.isBehind = true;
        QVERIFY(differentPixels(pictureOf({disc}, kMarkRadius), pictureOf({diamond}, kMarkRadius)) > 10);
    }

    void edgesAreInTheLoupeWhereTheyAreLong()
    {
        const auto ofLengths = [](std::initializer_list<double> lengths) {
            std::vector<QLineF> edges;
            for (const double length : lengths)
                edges.emplace_back(0.0, 0.0, length, 0.0);
            return edges;
        };
        QVERIFY(!leaveSurfaceVisible({}));
        QVERIFY(leaveSurfaceVisible(ofLengths({6.5})));
        QVERIFY(!leaveSurfaceVisible(ofLengths({5.5})));
        QVERIFY(leaveSurfaceVisible(ofLengths({1.0, 7.0, 30.0})));
        QVERIFY(!leaveSurfaceVisible(ofLengths({1.0, 2.0, 100.0}))); // one long edge among short ones
        const std::vector<QLineF> ofTriangles(std::size_t(3 * 48), QLineF(0.0, 0.0, 20.0, 0.0));
        QVERIFY(leaveSurfaceVisible(ofTriangles));
        std::vector<QLineF> ofMore = ofTriangles;
        ofMore.insert(ofMore.end(), 3, ofTriangles.front());
        QVERIFY(!leaveSurfaceVisible(ofMore)); // they are thin
    }

    void theLoupesEdgesAreAChoice()
    {
        const auto window = cubeWindow(false);
        part<LandmarkTool>(*window).setPlacing(true);
        pointAt(*window, localOf(*window, kFront)); // on the diagonal of the face: its edges are long
        const QImage whereLong = window->view().grabFramebuffer();
        choose(*window, "Never");
        const QImage never = window->view().grabFramebuffer();
        QVERIFY(differentPixels(whereLong, never) > 50);
        choose(*window, "Always");
        QCOMPARE(differentPixels(whereLong, window->view().grabFramebuffer()), 0);
        choose(*window, "Where They Are Long");
        QCOMPARE(differentPixels(whereLong, window->view().grabFramebuffer()), 0);
    }

    void labelsAreHiddenByAKey()
    {
        const auto window = windowWithLandmark();
        QAction *labels = actionOf(*window, QStringLiteral("Labels"));
        QVERIFY(labels && labels->isChecked());
        QCOMPARE(labels->shortcut(), QKeySequence(Qt::Key_H));
        const QImage with = window->view().grabFramebuffer();
        labels->trigger();
        const QImage without = window->view().grabFramebuffer();
        QVERIFY(differentPixels(with, without) > 200);
        QVERIFY(window->document().sceneLandmarks().setHidden({0}, true));
        QVERIFY(differentPixels(without, window->view().grabFramebuffer()) > 30); // the mark had stayed
        // A mark without a label takes no room for one.
        LandmarkMark empty = markInMiddle();
        QVERIFY(placedLabels({empty}, QFontMetricsF(QFont()), QRectF(0, 0, 80, 80)).empty());
    }

    void marksHaveASize()
    {
        const auto window = windowWithLandmark();
        const QImage medium = window->view().grabFramebuffer();
        choose(*window, "Large");
        QVERIFY(differentPixels(medium, window->view().grabFramebuffer()) > 20);
        choose(*window, "Medium");
        QCOMPARE(differentPixels(medium, window->view().grabFramebuffer()), 0);
        std::vector<int> drawn;
        for (const MarkSize size : {MarkSize::Small, MarkSize::Medium, MarkSize::Large})
            drawn.push_back(drawnPixels(pictureOf({markInMiddle()}, radiusOf(size))));
        QVERIFY2(drawn[0] > 20 && drawn[1] > 1.4 * drawn[0] && drawn[2] > 1.4 * drawn[1],
                 qPrintable(QStringLiteral("%1 %2 %3").arg(drawn[0]).arg(drawn[1]).arg(drawn[2])));
    }

    void choicesLast()
    {
        {
            const auto window = windowOfSize({1280, 800}, true);
            QVERIFY(part<LandmarkTool>(*window).looks().hasLabels);
            choose(*window, "Labels");
            choose(*window, "Small");
            choose(*window, "Never");
            QVERIFY(window->close());
        }
        {
            const auto window = windowOfSize({1280, 800}, true);
            const LandmarkLooks looks = part<LandmarkTool>(*window).looks();
            QVERIFY(!looks.hasLabels && looks.size == MarkSize::Small && looks.loupeEdges == LoupeEdges::Never);
            QVERIFY(!actionOf(*window, QStringLiteral("Labels"))->isChecked());
            QVERIFY(actionOf(*window, QStringLiteral("Small"))->isChecked());
            QVERIFY(window->close());
        }
        // A damaged file may have any number.
        QSettings().setValue(QStringLiteral("landmarks/markSize"), 77);
        QSettings().setValue(QStringLiteral("landmarks/loupeEdges"), -3);
        const auto window = windowOfSize({1280, 800}, true);
        const LandmarkLooks looks = part<LandmarkTool>(*window).looks();
        QVERIFY(looks.size == MarkSize::Large && looks.loupeEdges == LoupeEdges::WhereLong);
    }
};

UNPROJECTOR_TEST(TestLandmarkLooks, display)
#include "test_landmark_looks.moc"
