// Curves between placed points: in the document, in files, in their list and in the view; and
// measures in the view.

#include "tests/support/test.h"

#include "core/examples/solids.h"
#include "core/ray/closest_place.h"
#include "gui/document/camera_looks.h"
#include "gui/document/landmark_files.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/curves_view.h"
#include "gui/landmarks/measure_mark.h"
#include "gui/landmarks/measures_view.h"
#include "gui/view/curve_shapes.h"
#include "gui/widgets/segmented_switch.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"
#include "tests/gui/window_user.h"
#include "tests/support/patience.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>

#include <glm/geometric.hpp>

#include <cmath>
#include <numeric>

using namespace guitest;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::mesh;
using namespace unprojector::scene;
using landmarks::CurveKind;
using landmarks::Landmark;
using Shape = ShownMeasure::Shape;

namespace {

/// Points on the top of the cube and on its front, as far from the edge between them; and on its
/// right side.
const glm::dvec3 kTop = kCubeCenter + glm::dvec3(0.0, 1.0, 0.5), kFront = kCubeCenter + glm::dvec3(0.0, 0.25, 1.0),
                 kRight = kCubeCenter + glm::dvec3(1.0, 0.0, 0.0);

Landmark heldAt(const SceneObject &object, const glm::dvec3 &world, const std::string &name)
{
    const auto placement = worldFromObject(object.transform);
    const glm::dvec3 inObject(glm::inverse(placement) * glm::dvec4(world, 1.0));
    Landmark landmark;
    landmark.name = name;
    landmark.object = object.name;
    landmark.world = WorldPoint(world);
    landmark.anchor = ray::ClosestPlaces::build(object.model, {})->to(ObjectPoint(inObject))->anchor;
    landmark.uncertainty = WorldVector(0.01, 0.01, 0.01);
    return landmark;
}

/// Three points on the cube.
void putPoints(SceneDocument &document)
{
    const SceneObject &cube = document.objects()[0];
    QVERIFY(editLandmarks(
        document, {heldAt(cube, kTop, "top"), heldAt(cube, kFront, "front"), heldAt(cube, kRight, "right")}, {"put"}));
}

std::unique_ptr<SceneDocument> cubeDocument()
{
    auto document = std::make_unique<SceneDocument>();
    document->setSurface({800, 600, 1.0});
    openObjects(*document, cubeScene());
    putPoints(*document);
    return document;
}

void add(SceneDocument &document, const Landmark &landmark)
{
    std::vector<Landmark> landmarks = document.landmarks();
    landmarks.push_back(landmark);
    QVERIFY(editLandmarks(document, std::move(landmarks), {"add"}));
}

double lengthOf(SceneDocument &document, std::size_t curve)
{
    const auto &line = document.curves().line(curve).line;
    return line ? line->length.value : std::nan("");
}

} // namespace

class TestCurves : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void pointsAreJoinedAsOneStep()
    {
        const auto document = cubeDocument();
        QCOMPARE(document->curves().join({0, 1}, CurveKind::Geodesic), QString());
        QCOMPARE(document->undoStack().undoText(), "Join Curve 1");
        QVERIFY(std::abs(lengthOf(*document, 0) - 1.25) < 1e-6);
        QVERIFY(document->curves().line(0).line->length.error.has_value());
        document->curves().setCount(0, 5);
        document->curves().setCount(0, 7); // one after the other is one step
        QCOMPARE(document->undoStack().undoText(), "Semilandmarks of Curve 1");
        const auto set = document->curves().withSemilandmarks();
        const std::vector<WorldPoint> &seven = set->curves[0].semilandmarks;
        QCOMPARE(seven.size(), std::size_t(7));
        QVERIFY(distance(seven[0], WorldPoint(kTop)) < 1e-6 && distance(seven[6], WorldPoint(kFront)) < 1e-6);
        document->undoStack().undo();
        QCOMPARE(document->curves().all()[0].count, 10u);
        document->curves().setKind(0, CurveKind::PlaneSection);
        QVERIFY(std::abs(lengthOf(*document, 0) - 1.25) < 1e-6);
        document->curves().rename(0, "brow");
        QCOMPARE(document->curves().all()[0].name, "brow");
        document->curves().remove(0);
        QCOMPARE(document->undoStack().undoText(), "Remove brow");
        QVERIFY(document->curves().all().empty());
        document->undoStack().undo();
        QVERIFY(std::abs(lengthOf(*document, 0) - 1.25) < 1e-6);
    }

    void curvesFollowTheirPoints()
    {
        const auto document = cubeDocument();
        QCOMPARE(document->curves().join({0, 1, 2}, CurveKind::Geodesic), QString());
        const double before = lengthOf(*document, 0);
        QVERIFY(document->sceneLandmarks().move(
            1, heldAt(document->objects()[0], kCubeCenter + glm::dvec3(0.5, 0.5, 1.0), "")));
        const double moved = lengthOf(*document, 0);
        QVERIFY(std::abs(moved - before) > 0.1);
        QVERIFY(document->sceneLandmarks().rename(1, "chin"));
        QCOMPARE(document->curves().all()[0].points[1], "chin");
        QCOMPARE(lengthOf(*document, 0), moved);
        QVERIFY(document->sceneLandmarks().reorder(2, 0));
        QCOMPARE(lengthOf(*document, 0), moved);
        // The curve is stretched with its object: the length is the world's.
        QVERIFY(editTransform(*document, 0, {Scale{glm::dvec3(2.0)}}, {"scale"}));
        QVERIFY(std::abs(lengthOf(*document, 0) - 2.0 * moved) < 1e-5);
        while (document->undoStack().canUndo())
            document->undoStack().undo();
        QVERIFY(document->curves().all().empty());
    }

    void curvesSayWhyTheyDoNotGo()
    {
        const auto document = cubeDocument();
        QCOMPARE(document->curves().join({0, 1}, CurveKind::Geodesic), QString());
        const auto reason = [&] { return document->curves().line(0).reason; };
        QVERIFY(document->sceneLandmarks().setMissing({1}));
        QCOMPARE(reason(), "“front” is missing on this specimen");
        QVERIFY(!document->curves().line(0).line);
        QVERIFY(document->sceneLandmarks().placeAgain({1}));
        QCOMPARE(reason(), "“front” is not placed yet");
        document->undoStack().undo();
        document->undoStack().undo();
        QVERIFY(document->sceneLandmarks().moveTo(1, WorldPoint(kFront + glm::dvec3(0, 0, 1))));
        QCOMPARE(reason(), "“front” is not on a surface; select it and press B");
        document->undoStack().undo();
        QVERIFY(document->sceneLandmarks().remove({1}));
        QCOMPARE(reason(), "there is no landmark “front”");
        document->undoStack().undo();
        QVERIFY(document->sceneLandmarks().rename(2, "front"));
        QCOMPARE(reason(), "several landmarks are called “front”; rename all but one");
        document->undoStack().undo();
        QCOMPARE(reason(), QString());
        QVERIFY(document->curves().line(0).line.has_value());
    }

    void joiningIsRefusedInWords()
    {
        const auto document = cubeDocument();
        QCOMPARE(document->curves().join({0}, CurveKind::Geodesic), "a curve needs at least two landmarks");
        QVERIFY(document->sceneLandmarks().rename(1, ""));
        QCOMPARE(document->curves().join({0, 1}, CurveKind::Geodesic),
                 "landmark 2 has no name; give it one, because curves refer to landmarks by name");
        document->undoStack().undo();
        std::vector<SceneObject> other = cubeScene();
        other[0].name = "other";
        QVERIFY(addObjects(*document, other));
        add(*document, heldAt(document->objects()[1], kFront, "there"));
        QCOMPARE(document->curves().join({0, 3}, CurveKind::Geodesic), "“there” lies on another object than “top”");
        QVERIFY(document->curves().all().empty());
    }

    void largeModelsAreWorkedOutAside()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        SceneObject ball;
        ball.name = "ball";
        auto model = std::make_shared<Model>();
        model->meshes.push_back(examples::sphereMesh(1.0, 5));
        model->bounds = boundsOf(model->meshes);
        ball.model = model;
        openObjects(document, {ball});
        QVERIFY(editLandmarks(document, {heldAt(ball, {1, 0, 0}, "a"), heldAt(ball, {0, 1, 0}, "b")}, {"put"}));
        QCOMPARE(document.curves().join({0, 1}, CurveKind::Geodesic), QString());
        QVERIFY(document.curves().line(0).isComputing);
        QVERIFY(!document.curves().line(0).line);
        QTRY_VERIFY_WITH_TIMEOUT(!document.curves().line(0).isComputing, kPatienceMilliseconds);
        QVERIFY(std::abs(lengthOf(document, 0) - 1.5708) < 2e-3);
        // After the move the old line stays until the new one is computed; it is not drawn as the
        // curve.
        QVERIFY(document.sceneLandmarks().move(1, heldAt(ball, {0, 0, 1}, "b")));
        QVERIFY(document.curves().line(0).isComputing && document.curves().line(0).line);
        QVERIFY(curveShapes(document).lines.empty() && !curveShapes(document).former.empty());
        QVERIFY(document.sceneLandmarks().move(1, heldAt(ball, {0, -1, 0}, "b"))); // while the other is under way
        document.curves().complete();
        QVERIFY(distance(document.curves().line(0).line->path.back(), WorldPoint(0, -1, 0)) < 0.05);
        QVERIFY(!curveShapes(document).lines.empty());
        QVERIFY(document.sceneLandmarks().move(1, heldAt(ball, {0, 0, 1}, "b"))); // and it may end while it works
    }

    void aComputationIsCancelledInItsRow()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        SceneObject ball;
        ball.name = "ball";
        auto model = std::make_shared<Model>();
        model->meshes.push_back(examples::sphereMesh(1.0, 5));
        model->bounds = boundsOf(model->meshes);
        ball.model = model;
        openObjects(document, {ball});
        CurvesView view(document);
        view.show();
        QVERIFY(editLandmarks(document, {heldAt(ball, {1, 0, 0}, "a"), heldAt(ball, {-0.9, 0.1, 0.2}, "b")}, {"put"}));
        QCOMPARE(document.curves().join({0, 1}, CurveKind::Geodesic), QString());
        auto *rows = view.findChild<QTreeWidget *>();
        QTreeWidgetItem *row = rows->topLevelItem(0);
        constexpr int kLength = 4;
        auto *button = qobject_cast<QToolButton *>(rows->itemWidget(row, kLength));
        QVERIFY(button);
        QCOMPARE(button->text(), "Cancel, 0 %");
        button->click();
        QTRY_VERIFY(document.curves().line(0).isCancelled);
        QVERIFY(!document.curves().line(0).isComputing && !document.curves().line(0).line);
        QVERIFY(row->text(kLength).startsWith("cancelled"));
        QVERIFY(!rows->itemWidget(row, kLength));
        QTRY_VERIFY_WITH_TIMEOUT(!document.curves().isComputing(), kPatienceMilliseconds);
        QVERIFY(document.curves().line(0).isCancelled); // its late result is not used
        QSignalSpy progressed(&document.curves(), &SceneCurves::progressed);
        document.curves().computeAgain();
        QVERIFY(rows->itemWidget(row, kLength));
        QTRY_VERIFY_WITH_TIMEOUT(document.curves().line(0).line, kPatienceMilliseconds);
        QVERIFY(!document.curves().line(0).isCancelled && !rows->itemWidget(row, kLength));
        QVERIFY(progressed.size() >= 3);
        document.curves().cancel(); // nothing is under way
        QVERIFY(document.curves().line(0).line);
    }

    void whoWaitsForCurvesMayGiveUp()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        SceneObject ball;
        ball.name = "ball";
        auto model = std::make_shared<Model>();
        model->meshes.push_back(examples::sphereMesh(1.0, 5));
        model->bounds = boundsOf(model->meshes);
        ball.model = model;
        openObjects(document, {ball});
        QVERIFY(editLandmarks(document, {heldAt(ball, {1, 0, 0}, "a"), heldAt(ball, {0, 1, 0}, "b")}, {"put"}));
        QCOMPARE(document.curves().join({0, 1}, CurveKind::Geodesic), QString());
        int asked = 0;
        document.curves().setWaiting([&] {
            ++asked;
            const SceneCurves::Progress progress = document.curves().progress();
            return progress.count != 1 || progress.done > 1; // given up
        });
        const QTemporaryDir folder;
        const QString name = folder.filePath("p.csv");
        LandmarkFiles files(document, nullptr);
        QVERIFY(!files.exportTo(name.toStdU16String()));
        QCOMPARE(asked, 1);
        QVERIFY(!QFile::exists(name));     // not without them in silence
        document.curves().setWaiting([&] { // a caller blocks meanwhile: there is no second question
            return document.curves().complete();
        });
        QVERIFY(files.exportTo(name.toStdU16String()));
        QVERIFY(QFile::exists(name));
        QVERIFY(!document.curves().isComputing());
    }

    void filesHaveTheSemilandmarks()
    {
        const auto document = cubeDocument();
        QCOMPARE(document->curves().join({0, 1}, CurveKind::Geodesic), QString());
        document->curves().setCount(0, 6);
        const QTemporaryDir folder;
        const auto fileOf = [&](const char *name) {
            return std::filesystem::path(folder.filePath(QLatin1String(name)).toStdU16String());
        };
        LandmarkFiles files(*document, nullptr);
        QVERIFY(files.exportTo(fileOf("p.csv")) && files.exportTo(fileOf("p.tps")) && files.exportTo(fileOf("p.pts")));
        const auto textOf = [&](const char *name) {
            QFile file(folder.filePath(QLatin1String(name)));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        // The ends are landmarks, which are there already.
        QVERIFY(textOf("p.csv").contains("Curve 1:05,") && !textOf("p.csv").contains("Curve 1:06,"));
        QVERIFY(textOf("p.tps").contains("CURVES=1\nPOINTS=4\n"));
        QCOMPARE(textOf("p.pts").split('\n')[1].trimmed(), QByteArray("7"));
        QCOMPARE(textOf("p.sliders.csv"), QByteArray("before,slide,after\n1,4,5\n4,5,6\n5,6,7\n6,7,2\n"));
        const auto curves = document->curves().all();
        QVERIFY(editLandmarkSet(*document, {}, {"away"}));
        QVERIFY(files.importFrom(fileOf("p.csv")));
        QVERIFY(document->curves().all() == curves);
        QVERIFY(std::abs(lengthOf(*document, 0) - 1.25) < 1e-6);
        // Curves of another program have no points to go through: they are where the file has them.
        QVERIFY(editLandmarkSet(*document, {}, {"away"}));
        QVERIFY(files.importFrom(fileOf("p.tps")));
        QCOMPARE(document->curves().all().size(), std::size_t(1));
        QCOMPARE(document->curves().line(0).line->path.size(), std::size_t(4));
        const auto set = document->curves().withSemilandmarks();
        QCOMPARE(set->curves[0].semilandmarks.size(), std::size_t(4));
    }

    void theListEditsCurves()
    {
        const auto document = cubeDocument();
        CurvesView view(*document);
        QVERIFY(view.isHidden() && !view.joinButton()->isEnabled());
        document->sceneLandmarks().select({0, 1});
        QVERIFY(view.joinButton()->isEnabled());
        view.joinButton()->menu()->actions()[0]->trigger();
        QCOMPARE(document->curves().all().size(), std::size_t(1));
        QVERIFY(!view.isHidden());
        auto *rows = view.findChild<QTreeWidget *>();
        QCOMPARE(rows->topLevelItem(0)->text(0), "Curve 1");
        QCOMPARE(rows->topLevelItem(0)->text(1), "top – front");
        QVERIFY2(rows->topLevelItem(0)->text(4).startsWith("1.25"), qPrintable(rows->topLevelItem(0)->text(4)));
        // After joining, typed digits are its count. So they edit its row, in any current column.
        view.show();
        QVERIFY(!view.focusWidget() || view.focusWidget() == rows);
        document->undoStack().undo();
        rows->clearFocus();
        document->sceneLandmarks().select({0, 1});
        view.join(CurveKind::Geodesic);
        QCOMPARE(view.focusWidget(), rows);
        // A number being typed counts when the file is written.
        QTest::keyClicks(rows, "7");
        view.applyTyped();
        QCOMPARE(document->curves().all()[0].count, 7u);
        QTRY_VERIFY_WITH_TIMEOUT(!rows->viewport()->findChild<QLineEdit *>(), kPatienceMilliseconds);
        view.applyTyped();
        QCOMPARE(document->curves().all()[0].count, 7u);
        // The list has no room for missing rows.
        QVERIFY(rows->maximumHeight() < rows->header()->height() + 3 * rows->sizeHintForRow(0));
        rows->setCurrentItem(rows->topLevelItem(0), 1);
        QKeyEvent asked(QEvent::ShortcutOverride, Qt::Key_2, Qt::NoModifier, "2");
        asked.ignore();
        QCoreApplication::sendEvent(rows, &asked);
        QVERIFY(asked.isAccepted()); // not a key of the camera
        const auto type = [rows](const QString &digits) {
            QTest::keyClicks(rows, digits.left(1));
            auto *editor = rows->viewport()->findChild<QLineEdit *>();
            QVERIFY(editor);
            QTest::keyClicks(editor, digits.mid(1));
            QTest::keyClick(editor, Qt::Key_Return);
            QTRY_VERIFY_WITH_TIMEOUT(!rows->viewport()->findChild<QLineEdit *>(), kPatienceMilliseconds);
        };
        type("25");
        QTRY_COMPARE_WITH_TIMEOUT(document->curves().all()[0].count, 25u, kPatienceMilliseconds);
        const auto *reason = view.findChild<QLabel *>();
        for (const char *refused : {"5000", "1"}) { // not capped in silence
            type(refused);
            QTRY_VERIFY2_WITH_TIMEOUT(reason->isVisible()
                                          && reason->text().contains(QStringLiteral("“%1”").arg(refused)),
                                      qPrintable(reason->text()), kPatienceMilliseconds);
            QVERIFY2(reason->text().contains("2 to 1000"), qPrintable(reason->text()));
            QCOMPARE(document->curves().all()[0].count, 25u);
            QCOMPARE(rows->topLevelItem(0)->text(3), "25");
        }
        type("1000");
        QTRY_COMPARE_WITH_TIMEOUT(document->curves().all()[0].count, 1000u, kPatienceMilliseconds);
        QVERIFY(!reason->isVisible());
        rows->topLevelItem(0)->setText(0, "ridge");
        QTRY_COMPARE_WITH_TIMEOUT(document->curves().all()[0].name, "ridge", kPatienceMilliseconds);
        QVERIFY(document->sceneLandmarks().setMissing({1}));
        QCOMPARE(rows->topLevelItem(0)->text(4), "“front” is missing on this specimen");
        rows->setCurrentItem(rows->topLevelItem(0));
        document->curves().remove(0);
        QVERIFY(view.isHidden());
    }

    void theLengthAlongTheSurfaceIsAMeasure()
    {
        const auto document = cubeDocument();
        MeasuresView view(*document);
        document->sceneLandmarks().select({0, 1});
        auto *rows = view.findChild<QTreeWidget *>();
        QCOMPARE(rows->topLevelItemCount(), 2);
        QCOMPARE(rows->topLevelItem(1)->text(0), "Along the surface");
        QVERIFY(rows->topLevelItem(1)->text(2).startsWith("1.25 ± "));
        QVERIFY(view.csv().contains("\nAlong the surface,top – front,1.25"));
        QVERIFY(document->sceneLandmarks().moveTo(1, WorldPoint(0, 0, 0)));
        QCOMPARE(rows->topLevelItem(1)->text(2), "“front” is not on a surface; select it and press B");
        std::vector<Landmark> many(21, document->landmarks()[0]);
        QVERIFY(editLandmarks(*document, many, {"many"}));
        std::vector<std::size_t> all(many.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        document->sceneLandmarks().select(all);
        QCOMPARE(rows->topLevelItem(rows->topLevelItemCount() - 1)->text(2), "it can have at most 20 landmarks");
    }

    void curvesAreDrawnOnTheSurface()
    {
        const std::unique_ptr<MainWindow> window = cubeWindow(false);
        SceneDocument &document = window->document();
        putPoints(document);
        QVERIFY(document.sceneLandmarks().setHidden({2}, true));
        const QImage before = window->view().grabFramebuffer();
        QCOMPARE(document.curves().join({0, 1}, CurveKind::Geodesic), QString());
        const QImage after = window->view().grabFramebuffer();
        QVERIFY(differentPixels(before, after) > 50);
        // The middle of the front's part shows the curve, in the usual colour of points.
        const QPointF at = localOf(*window, kCubeCenter + glm::dvec3(0.0, 0.55, 1.0));
        bool isDrawn = false;
        for (int x = -3; x <= 3; ++x) {
            const QColor color = after.pixelColor(at.toPoint() * after.devicePixelRatio() + QPoint(x, 0));
            isDrawn = isDrawn || (color.red() > 200 && color.green() > 150 && color.blue() < 100);
        }
        QVERIFY(isDrawn);
        QVERIFY(document.sceneLandmarks().setHidden({0}, true));
        QVERIFY(curveShapes(document).lines.empty());
    }

    void theChosenMeasureIsShown_data()
    {
        addColumn<QString>("kind");
        addColumn<int>("points");
        addColumn<int>("lines");
        newRow("distance") << "Distance" << 2 << 1;
        newRow("surface") << "Along the surface" << 2 << 0;
        newRow("angle") << "Angle" << 3 << 26;
        newRow("length") << "Length along" << 3 << 2;
        newRow("height") << "Height" << 4 << 5;
    }

    void theChosenMeasureIsShown()
    {
        QFETCH(QString, kind);
        QFETCH(int, points);
        QFETCH(int, lines);
        const std::unique_ptr<MainWindow> window = cubeWindow(false);
        SceneDocument &document = window->document();
        putPoints(document);
        add(document, heldAt(document.objects()[0], kCubeCenter + glm::dvec3(0.7, 0.9, 1.0), "more"));
        auto *measures = window->findChild<MeasuresView *>();
        QVERIFY(measures);
        std::vector<std::size_t> indices(static_cast<std::size_t>(points));
        std::iota(indices.begin(), indices.end(), std::size_t(0));
        document.sceneLandmarks().select(indices);
        QVERIFY(!measureMark(document));
        const QImage before = window->view().grabFramebuffer();
        auto *rows = measures->findChild<QTreeWidget *>();
        const QList<QTreeWidgetItem *> items = rows->findItems(kind, Qt::MatchExactly);
        QVERIFY(!items.isEmpty());
        const QString value = items[0]->text(2);
        emit rows->itemClicked(items[0], 0);
        const auto mark = measureMark(document);
        QVERIFY(mark);
        QCOMPARE(mark->label.label, value);
        QCOMPARE(int(mark->lines.size()), lines);
        QVERIFY(differentPixels(before, window->view().grabFramebuffer()) > 200);
        // Its label keeps clear of the points' labels.
        std::vector<LandmarkMark> marks = landmarkMarks(document);
        marks.push_back(mark->label);
        const auto labels =
            placedLabels(marks, QFontMetricsF(window->font()), QRectF(window->view().rect()), mark->lines);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            for (std::size_t k = i + 1; k < labels.size(); ++k)
                QVERIFY(!labels[i].box.intersects(labels[k].box));
        }
        QVERIFY(std::any_of(labels.begin(), labels.end(),
                            [&](const PlacedLabel &label) { return label.mark + 1 == marks.size(); }));
        emit rows->itemClicked(rows->findItems(kind, Qt::MatchExactly)[0], 0); // once more
        QVERIFY(!measureMark(document));
    }

    void theMirrorPlaneIsShown()
    {
        const std::unique_ptr<MainWindow> window = cubeWindow(false);
        SceneDocument &document = window->document();
        const auto at = [&](double x, double y, const char *name) {
            add(document, heldAt(document.objects()[0], kCubeCenter + glm::dvec3(x, y, 1.0), name));
        };
        at(-0.8, 0.5, "eye left");
        at(0.8, 0.5, "eye right");
        at(-0.6, -0.7, "lip left");
        at(0.7, -0.7, "lip right");
        at(0.1, 0.0, "nose");
        auto *measures = window->findChild<MeasuresView *>();
        auto *rows = measures->findChild<QTreeWidget *>();
        measures->findChild<SegmentedSwitch *>()->setChoice(1);
        const auto choose = [&](const QString &kind, int which) {
            const QList<QTreeWidgetItem *> items = rows->findItems(kind, Qt::MatchExactly);
            QVERIFY(which < items.size());
            emit rows->itemClicked(items[which], 0);
        };
        const QImage before = window->view().grabFramebuffer();
        choose(QStringLiteral("Mirror plane"), 0);
        auto mark = measureMark(document);
        QVERIFY(mark);
        QCOMPARE(mark->plane.size(), qsizetype(4));
        QCOMPARE(mark->images.size(), std::size_t(5)); // two a pair, and the nose's
        QCOMPARE(mark->lines.size(), std::size_t(5));
        QCOMPARE(mark->label.label, QStringLiteral("Mirror plane"));
        QVERIFY(differentPixels(before, window->view().grabFramebuffer()) > 200);
        choose(QStringLiteral("Asymmetry"), 1);
        mark = measureMark(document);
        QVERIFY(mark && mark->plane.size() == 4);
        QCOMPARE(mark->images.size(), std::size_t(2));
        QCOMPARE(mark->label.label, rows->findItems(QStringLiteral("Asymmetry"), Qt::MatchExactly)[1]->text(2));
        choose(QStringLiteral("Plane distance"), 0);
        mark = measureMark(document);
        QVERIFY(mark);
        QCOMPARE(mark->images.size(), std::size_t(1));
        // The line ends on the plane: half the way to the image.
        QVERIFY(QLineF(mark->lines[0].p2(), (mark->lines[0].p1() + mark->images[0]) / 2.0).length() < 1.0);
        for (int row = 0; row < rows->topLevelItemCount(); ++row)
            QVERIFY2(!rows->topLevelItem(row)->toolTip(1).contains(QStringLiteral(": .")),
                     qPrintable(rows->topLevelItem(row)->toolTip(1)));
    }

    void joinTakesTheOrderOfTheSelection()
    {
        const auto document = cubeDocument();
        CurvesView view(*document);
        SceneLandmarks &landmarks = document->sceneLandmarks();
        landmarks.selectOnly(2);
        landmarks.toggle(0);
        landmarks.toggle(1);
        view.join(CurveKind::Geodesic);
        QCOMPARE(document->curves().all().size(), std::size_t(1));
        const std::vector<std::string> order{landmarks.all()[2].name, landmarks.all()[0].name, landmarks.all()[1].name};
        QVERIFY(document->curves().all()[0].points == order);
    }

    void measuresTakeTheOrderOfTheSelection()
    {
        const auto document = cubeDocument();
        MeasuresView view(*document);
        SceneLandmarks &landmarks = document->sceneLandmarks();
        landmarks.selectOnly(1);
        landmarks.toggle(0);
        landmarks.toggle(2);
        // From the front over the edge to the top; from there over the other edge, two wide and half as deep.
        const double straight = std::hypot(0.75, 0.5) + std::hypot(1.0, 1.0, 0.5), along = 1.25 + std::hypot(2.0, 0.5);
        const auto valueOf = [&view](const QString &row) {
            for (const QString &line : view.csv().split(u'\n')) {
                if (line.startsWith(row))
                    return line.mid(row.size()).section(u',', 0, 0).toDouble();
            }
            return std::nan("");
        };
        QVERIFY(std::abs(valueOf("Length along,front – top – right,") - straight) < 1e-6);
        QVERIFY(std::abs(valueOf("Along the surface,front – top – right,") - along) < 1e-6);
        // A kept measure selects its landmarks in its own order.
        landmarks::LandmarkSet set = document->scene().landmarks;
        set.measures = {{"way", landmarks::MeasureKind::Surface, {"right", "front", "top"}}};
        QVERIFY(editLandmarkSet(*document, set, {"keep"}));
        view.findChild<SegmentedSwitch *>()->setChoice(2);
        auto *rows = view.findChild<QTreeWidget *>();
        QCOMPARE(rows->topLevelItem(0)->text(2), "click to compute");
        emit rows->itemClicked(rows->topLevelItem(0), 0);
        QVERIFY(landmarks.selectionInOrder() == (std::vector<std::size_t>{2, 1, 0}));
        QVERIFY(std::abs(valueOf("way,along the surface: right – front – top,") - 1.25 - std::hypot(2.0, 0.25)) < 1e-6);
        // It selects them at once: none of them is next to place, and nothing is computed again.
        QVERIFY(landmarks.setMissing({1}));
        const std::optional<std::size_t> next = landmarks.nextUnplaced();
        landmarks.clearSelection();
        int changes = 0;
        connect(document.get(), &SceneDocument::changed, this, [&changes] { ++changes; });
        emit rows->itemClicked(rows->topLevelItem(0), 0);
        QVERIFY(landmarks.selectionInOrder() == (std::vector<std::size_t>{2, 1, 0}));
        QVERIFY(landmarks.nextUnplaced() == next);
        emit rows->itemClicked(rows->topLevelItem(0), 0);
        QCOMPARE(changes, 1);
    }
};

UNPROJECTOR_TEST(TestCurves, display)
#include "test_curves.moc"
