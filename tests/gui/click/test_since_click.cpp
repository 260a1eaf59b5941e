// The message about a pick when the document has changed since, and its repetition by a new pick.

#include "tests/support/test.h"

#include "gui/click/answer_view.h"
#include "gui/click/comparison_model.h"
#include "gui/click/comparison_panel.h"
#include "gui/click/then_and_now.h"
#include "gui/click/then_and_now_view.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/document/since_click_text.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/widgets/segmented_switch.h"
#include "gui/widgets/whole_table.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include <glm/matrix.hpp>

#include <cmath>
#include <functional>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::pipeline;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

using Happening = std::function<void(SceneDocument &)>;

QPushButton *againButton(const QWidget &panel)
{
    for (QPushButton *button : panel.findChildren<QPushButton *>()) {
        if (button->text() == QStringLiteral("Pick a&gain"))
            return button;
    }
    return nullptr;
}

QString labelText(const QWidget &panel, const char *accessibleName)
{
    for (const QLabel *label : panel.findChildren<QLabel *>()) {
        if (label->accessibleName() == QLatin1String(accessibleName))
            return label->text();
    }
    return {};
}

/// Opens a scene seen from (0, 0, 5) by glFrustum with near 2 and far 10 in 400 x 300; the pixel in
/// the middle lies on z = 0. Picks it.
void openAndPick(SceneDocument &document)
{
    Scene scene;
    scene.camera = scene.home = {WorldPoint(0, 0, 5), WorldPoint(0, 0, 0), {0, 1, 0}};
    scene.projection = Frustum{-1, 1, -1, 1, 2, 10};
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    scene.objects = cubeScene();
    scene.objects.front().name = "cube";
    document.setSurface({400, 300, 1.0});
    QVERIFY(document.open(scene));
    // z = 20 / (10 (1 - d) + 2 d) = 5 for d = 0.75.
    pickAt(document, WidgetPoint(200.0, 150.0), {0.75, 0, 24});
    QVERIFY(document.picks().pick());
}

LookAt cameraAt(double x, double y, double z)
{
    return {WorldPoint(x, y, z), WorldPoint(x, y, z - 5.0), {0, 1, 0}};
}

} // namespace

class TestSinceClick : public QObject {
    Q_OBJECT

private slots:
    void whatHappenedSinceTheClickIsSaid_data()
    {
        addColumn<Happening>("happening");
        addColumn<QStringList>("said");
        addColumn<QStringList>("notSaid");
        addColumn<bool>("canCompute");
        const QStringList changed{QStringLiteral("The view has changed since this click")};
        const QStringList outside{QStringLiteral("outside")};
        const auto row = [](const char *name, const Happening &happening, const QStringList &said,
                            const QStringList &notSaid,
                            bool canCompute = true) { newRow(name) << happening << said << notSaid << canCompute; };
        const auto camera = [](double x, double y, double z) {
            return [=](SceneDocument &document) { setCamera(document, cameraAt(x, y, z)); };
        };
        row(
            "nothing", [](SceneDocument &) {}, {QStringLiteral("as it was")}, changed + outside, false);
        row("a step to the side", camera(0.5, 0, 5), changed, outside);
        row(
            "undone",
            [](SceneDocument &document) {
                setCamera(document, cameraAt(0.5, 0, 5));
                document.undoStack().undo();
            },
            {QStringLiteral("as it was")}, changed + outside, false);
        row("far away", camera(0, 0, 12), changed + QStringList{QStringLiteral("z > w: behind the far plane")}, {});
        row("too near", camera(0, 0, 1.5), changed + QStringList{QStringLiteral("z < −w: before the near plane")}, {});
        row("past it", camera(0, 0, -3), changed + QStringList{QStringLiteral("w < 0: behind the eye")}, {});
        row("to the right", camera(4, 0, 5), changed + QStringList{QStringLiteral("x < −w: left of the view volume")},
            {});
        row("down", camera(0, -4, 5), changed + QStringList{QStringLiteral("y > w: above the view volume")}, {});
        row("down, to the left", camera(-4, -4, 5),
            changed + QStringList{QStringLiteral("x > w"), QStringLiteral("y > w")}, {});
        row(
            "the window's size",
            [](SceneDocument &document) {
                document.setSurface({500, 300, 1.0});
            },
            changed, outside);
        row(
            "near and far",
            [](SceneDocument &document) {
                QVERIFY(
                    editProjection(document, {Frustum{-1, 1, -1, 1, 1, 10}, false, false}, {QStringLiteral("Near")}));
            },
            changed, outside);
        row(
            "the object hidden", [](SceneDocument &document) { QVERIFY(setObjectHidden(document, 0, true)); },
            {QStringLiteral("The object of this click is hidden now")}, changed + outside);
        row(
            "the object hidden and shown",
            [](SceneDocument &document) {
                QVERIFY(setObjectHidden(document, 0, true));
                QVERIFY(setObjectHidden(document, 0, false));
            },
            {QStringLiteral("as it was")}, changed + outside, false);
        row(
            "the point cut away",
            [](SceneDocument &document) {
                QVERIFY(editClipPlanes(document, {{0, 0, -1, -0.5}}, {}, {QStringLiteral("Cut")}));
            },
            {QStringLiteral("A clip plane cuts the point of this click away now")}, changed + outside);
        row(
            "cut along the point",
            [](SceneDocument &document) {
                QVERIFY(editClipPlanes(document, {{0, 0, -1, 0}, {0, 0, 1, 0}}, {}, {QStringLiteral("Cut")}));
            },
            {QStringLiteral("as it was")}, changed + outside, false);
        row(
            "the object taken out and put back",
            [](SceneDocument &document) {
                QVERIFY(removeObject(document, 0));
                QVERIFY(!document.picks().pick());
                document.undoStack().undo();
            },
            {QStringLiteral("as it was")}, changed + outside, false);
        row(
            "the object moved",
            [](SceneDocument &document) {
                QVERIFY(editTransform(document, 0, {Translate{{1000, 0, 0}}}, {QStringLiteral("Move")}));
            },
            {QStringLiteral("The object was moved since this click")}, changed + outside);
        row(
            "the object moved, near and far with it",
            [](SceneDocument &document) {
                QVERIFY(editProjection(document, {document.scene().projection, false, true}, {QStringLiteral("Fit")}));
                QVERIFY(editTransform(document, 0, {Translate{{0, 0, -1000}}}, {QStringLiteral("Move")}));
            },
            {QStringLiteral("The object was moved since this click")}, changed + outside);
    }

    void whatHappenedSinceTheClickIsSaid()
    {
        QFETCH(Happening, happening);
        QFETCH(QStringList, said);
        QFETCH(QStringList, notSaid);
        QFETCH(bool, canCompute);
        SceneDocument document;
        openAndPick(document);
        ComparisonPanel panel(document);
        PipelinePanel pipeline(document);
        pipeline.show();
        happening(document);
        const QString text = labelText(panel, "Since the click");
        QCOMPARE(againButton(panel)->parentWidget()->isHidden(), !canCompute);
        if (!canCompute)
            return;
        for (const QString &part : said)
            QVERIFY2(text.contains(part), qPrintable(text));
        QVERIFY2( // in the same words
            pipeline.model().status().contains(said.first()), qPrintable(pipeline.model().status()));
        for (const QString &part : notSaid) {
            QVERIFY2(!text.contains(part), qPrintable(text));
            QVERIFY2(!pipeline.model().status().contains(part), qPrintable(pipeline.model().status()));
        }
        QVERIFY(againButton(panel)->isEnabled());
        // Another click uses the current view. It cannot hit an object that is not drawn.
        const bool isDrawn = !document.objects()[0].isHidden && document.scene().clipPlanes.empty();
        pickAt(document, WidgetPoint(200.0, 150.0), isDrawn ? DepthSample{0.75, 0, 24} : DepthSample{1.0, {}, 24});
        QVERIFY(againButton(panel)->parentWidget()->isHidden()); // nothing has changed since, so there is no message
    }

    void aBackgroundSaysOnlyThatTheViewChanged()
    {
        SceneDocument document;
        openAndPick(document);
        pickAt(document, WidgetPoint(200.0, 150.0), {1.0, {}, 24});
        ComparisonPanel panel(document);
        QCOMPARE(panel.findChild<AnswerView *>()->heading(), QStringLiteral("Background: no surface here"));
        setCamera(document, cameraAt(0, 0, -30));
        const QString text = labelText(panel, "Since the click");
        QVERIFY2(text.contains(QStringLiteral("has changed")) && !text.contains(QStringLiteral("outside")),
                 qPrintable(text));
    }

    void chainDepthAndFormulasStayThoseOfTheClick()
    {
        SceneDocument document;
        openAndPick(document);
        ComparisonPanel panel(document);
        QCOMPARE(labelText(panel, "Depth"), QStringLiteral("0.75, as read"));
        const QString whole = panel.text();
        setCamera(document, cameraAt(1, 2, 12));
        setProjection(document, Ortho{-3, 3, -3, 3, 1, 9});
        document.setSurface({500, 400, 2.0});
        QString now = panel.text();
        const QString since = labelText(panel, "Since the click") + u'\n' + panel.findChild<ThenAndNowView *>()->text();
        QVERIFY(now.contains(since));
        QCOMPARE(now.remove(since), whole);
    }

    void thePipelineCallsNoDepthReadThatWasNot()
    {
        SceneDocument document;
        openAndPick(document);
        PipelinePanel panel(document);
        panel.setDirection(PipelineDirection::Backward);
        panel.show();
        const auto says = [&panel](const char *part) {
            for (const QLabel *label : panel.findChildren<QLabel *>()) {
                if (label->text().contains(QLatin1String(part)))
                    return true;
            }
            return false;
        };
        QVERIFY(says("depth as read"));
        setCamera(document, cameraAt(0, 0, 12));
        QVERIFY(!says("depth as read") && !says("depth read"));
        QVERIFY(says("depth computed"));
        QVERIFY(says("z > w: behind the far plane"));
        document.undoStack().undo();
        QVERIFY(says("depth as read"));
    }

    void valuesNowStandBesideThoseOfTheClick()
    {
        SceneDocument document;
        openAndPick(document);
        ComparisonPanel panel(document);
        panel.show();
        panel.setOpenFolds({QStringLiteral("now")});
        const auto &view = *panel.findChild<ThenAndNowView *>();
        QVERIFY(!view.isVisible() && !view.parentWidget()->isVisible()); // it takes no room
        setCamera(document, cameraAt(0.5, 0, 5));
        QVERIFY(view.isVisible());
        // 400 pixels are 5 units wide at z = 0: half a unit is 40 pixels.
        const std::vector<ThenAndNow> rows = thenAndNow(document);
        QCOMPARE(rows.size(), std::size_t(9));
        QCOMPARE(rows[0].name, QStringLiteral("Window x"));
        QCOMPARE(rows[0].then, QStringLiteral("200.5"));
        QCOMPARE(rows[0].now, QStringLiteral("160.50"));
        QCOMPARE(rows[1].then, QStringLiteral("149.5"));
        QVERIFY(std::abs(rows[3].now.toDouble() - rows[3].then.toDouble() + 0.5) < 1e-5); // eye x
        QVERIFY(std::abs(rows[2].then.toDouble() - 0.75) < 1e-6);
        // Only these two differ, and that is seen without colours.
        for (int row = 0; row < 9; ++row) {
            const bool differs = row == 0 || row == 3;
            QCOMPARE(rows[std::size_t(row)].differs, differs);
            QCOMPARE(rows[std::size_t(row)].now == rows[std::size_t(row)].then, !differs);
            QCOMPARE(view.table().item(row, 1)->text(), rows[std::size_t(row)].now);
            QCOMPARE(view.table().item(row, 1)->font().bold(), differs);
            QCOMPARE(view.table().verticalHeaderItem(row)->text().endsWith(u'≠'), differs);
        }
        QVERIFY2(panel.text().contains(QStringLiteral("Window x\t200.5\t160.5\n")), qPrintable(panel.text()));
        document.undoStack().undo();
        QVERIFY(!view.isVisible());
    }

    void thePointNowIsOnItsObject()
    {
        SceneDocument document;
        openAndPick(document);
        const glm::dmat4 before = worldFromObject(document.objects()[0].transform);
        const WorldPoint then = *document.picks().pickedPoint();
        QVERIFY(editTransform(document, 0, {Translate{kCubeCenter + glm::dvec3(0.2, 0.1, -0.5)}, Scale{{1.1, 1, 1}}},
                              {QStringLiteral("Move")}));
        const glm::dmat4 moved = worldFromObject(document.objects()[0].transform) * glm::inverse(before);
        const WorldPoint now(glm::dvec3(moved * glm::dvec4(then.coordinates(), 1.0)));
        const std::vector<ThenAndNow> rows = thenAndNow(document);
        QCOMPARE(rows.size(), std::size_t(9));
        const auto window = windowFromWorld(document.setup(), now);
        for (int axis = 0; axis < 3; ++axis) {
            const ThenAndNow &world = rows[std::size_t(6 + axis)];
            QVERIFY2(std::abs(world.then.toDouble() - then[axis]) < 1e-4, qPrintable(world.then));
            QVERIFY2(std::abs(world.now.toDouble() - now[axis]) < 1e-4, qPrintable(world.now));
            const QString shown = rows[std::size_t(axis)].now;
            QVERIFY2(std::abs(shown.toDouble() - (*window)[axis]) < (axis < 2 ? 0.1 : 1e-4), qPrintable(shown));
        }
    }

    void behindTheEyeThereIsNoWindowPoint()
    {
        SceneDocument document;
        openAndPick(document);
        ComparisonPanel panel(document);
        setCamera(document, cameraAt(0, 0, -3));
        const std::vector<ThenAndNow> rows = thenAndNow(document);
        for (std::size_t row = 0; row < 3; ++row)
            QCOMPARE(rows[row].now, QStringLiteral("–"));
        QVERIFY(std::abs(rows[5].now.toDouble() - 3.0) < 1e-4);
        QVERIFY(placeNowText(document).contains(QStringLiteral("w < 0: behind the eye")));
        QVERIFY(panel.findChild<ThenAndNowView *>()->text().contains(placeNowText(document)));
        setCamera(document, cameraAt(0, 0, 12));
        QVERIFY(placeNowText(document).contains(QStringLiteral("z > w: behind the far plane")));
        setCamera(document, cameraAt(0.5, 0, 5));
        QVERIFY(placeNowText(document).isEmpty());
    }

    void rowsOfTheSameValueArePlain()
    {
        SceneDocument document;
        openAndPick(document);
        QVERIFY(editProjection(document, {Frustum{-1, 1, -1, 1, 2, 20}, false, false}, {QStringLiteral("Far")}));
        const std::vector<ThenAndNow> rows = thenAndNow(document);
        for (std::size_t row = 0; row < rows.size(); ++row)
            QCOMPARE(rows[row].differs, row == 2); // d = f (z - n) / (z (f - n)) = 20 × 3 / (5 × 18)
        QVERIFY2(std::abs(rows[2].now.toDouble() - 2.0 / 3.0) < 1e-4, qPrintable(rows[2].now));
    }

    void changesOfTheSetupHaveBothValues()
    {
        SceneDocument document;
        openAndPick(document);
        QVERIFY(setupChanges(document).isEmpty());
        setCamera(document, cameraAt(0.5, 0, 5));
        QCOMPARE(setupChanges(document), QStringList{QStringLiteral("Eye position: (0, 0, 5) → (0.5, 0, 5)")});
        document.undoStack().undo();
        QVERIFY(editProjection(document, {Frustum{-2, 2, -2, 2, 2, 11}, false, false}, {QStringLiteral("Lens")}));
        QCOMPARE(setupChanges(document), (QStringList{QStringLiteral("Vertical field of view: 53.1301° → 90°"),
                                                      QStringLiteral("Far: 10 → 11")}));
        document.undoStack().undo();
        QVERIFY(
            editProjection(document, {Frustum{-1, 1, -1, 1, 2, 10.0000001}, false, false}, {QStringLiteral("Far")}));
        QCOMPARE(setupChanges(document), QStringList{QStringLiteral("Far: 10 → 10.0000001")});
        document.undoStack().undo();
        // An off-centre window, without another field of view in y.
        QVERIFY(editProjection(document, {Frustum{-1, 3, -1, 1, 2, 10}, false, false}, {QStringLiteral("Shift")}));
        QCOMPARE(setupChanges(document),
                 (QStringList{QStringLiteral("Aspect: 1 → 2"),
                              QStringLiteral("Centre of the projection window at near 1: (0, 0) → (0.5, 0)")}));
        document.undoStack().undo();
        // Up, though the last bits of the direction differ.
        LookAt turned = cameraAt(0, 0, 5);
        turned.center.x = 1e-15;
        turned.up = {1, 0, 0};
        setCamera(document, turned);
        QCOMPARE(setupChanges(document), QStringList{QStringLiteral("Up direction: (0, 1, 0) → (1, 0, 0)")});
        document.undoStack().undo();
        document.setSurface({500, 300, 1.0});
        QCOMPARE(setupChanges(document), (QStringList{QStringLiteral("Viewport: (0, 0) 400 × 300 → (0, 0) 500 × 300"),
                                                      QStringLiteral("Window size: 400 × 300 → 500 × 300")}));
    }

    void changesOfABoxHaveItsEdgesAndAngles()
    {
        SceneDocument document;
        openAndPick(document);
        const auto oblique = [](double left, double right, double theta) {
            return ProjectionRule{
                Oblique{{left, right, -1, 1, 2, 10}, radiansFromDegrees(theta), radiansFromDegrees(60)}, false, false};
        };
        QVERIFY(editProjection(document, oblique(-1, 1, 45), {QStringLiteral("Box")}));
        pickAt(document, WidgetPoint(200.0, 150.0), {0.4, 0, 24});
        QVERIFY(editProjection(document, oblique(0, 2, 50), {QStringLiteral("Shear")}));
        QCOMPARE(setupChanges(document),
                 (QStringList{QStringLiteral("Projection window: x -1 … 1, y -1 … 1 → x 0 … 2, y -1 … 1"),
                              QStringLiteral("Shear angles: θ 45°, φ 60° → θ 50°, φ 60°")}));
    }

    void rowsOfEqualTextsArePlain()
    {
        SceneDocument document;
        openAndPick(document);
        // A shift far below the last certain digit, but above rounding.
        for (const double shift : {1e-9, 3e-8, 1e-6, 1e-4}) {
            setCamera(document, cameraAt(shift, 0, 5));
            for (const ThenAndNow &row : thenAndNow(document))
                QVERIFY2(row.differs == (row.then != row.now), qPrintable(row.name + row.then + row.now));
            document.undoStack().undo();
        }
    }

    void aBackgroundHasOnlyTheChangesOfTheSetup()
    {
        SceneDocument document;
        openAndPick(document);
        pickAt(document, WidgetPoint(200.0, 150.0), {1.0, {}, 24});
        setCamera(document, cameraAt(0, 0, 6));
        QVERIFY(thenAndNow(document).empty() && placeNowText(document).isEmpty());
        QCOMPARE(setupChanges(document), QStringList{QStringLiteral("Eye position: (0, 0, 5) → (0, 0, 6)")});
    }

    void thePipelineShowsTheValuesAtTheClick()
    {
        SceneDocument document;
        openAndPick(document);
        PipelinePanel panel(document);
        panel.show();
        auto &values = *panel.findChild<SegmentedSwitch *>(QStringLiteral("values"));
        const auto numbers = [&panel] { return panel.model().text().section(u'\n', 1); };
        for (const PipelineDirection direction : {PipelineDirection::Forward, PipelineDirection::Backward}) {
            panel.setDirection(direction);
            const QString then = numbers();
            QVERIFY(!values.isVisible());
            setCamera(document, cameraAt(1, 2, 9));
            setProjection(document, Ortho{-3, 3, -3, 3, 1, 12});
            QVERIFY(editTransform(document, 0, {Translate{{5, 0, 0}}}, {QStringLiteral("Move")}));
            document.setSurface({500, 400, 1.0});
            QVERIFY(values.isVisible());
            QCOMPARE(values.choice(), 1);
            const QString now = numbers();
            QVERIFY(now != then);
            values.setChoice(0);
            QCOMPARE(numbers(), then);
            QVERIFY2(panel.model().status().startsWith(QStringLiteral("Values at the click")),
                     qPrintable(panel.model().status()));
            // The panel rejects a typed point while it shows the values at the click.
            panel.model().point(PointModel::Space::World)->typeAll(QStringLiteral("1 2 3"));
            QVERIFY(!document.scene().givenPoint);
            values.setChoice(1);
            QCOMPARE(numbers(), now);
            document.setSurface({400, 300, 1.0});
            for (int i = 0; i < 3; ++i)
                document.undoStack().undo();
        }
    }

    void thePipelineFollowsTheViewAgain()
    {
        SceneDocument document;
        openAndPick(document);
        PipelinePanel panel(document);
        panel.show();
        panel.showClickValues();
        QVERIFY(!panel.model().showsClick()); // they are those now
        setCamera(document, cameraAt(0.5, 0, 5));
        QVERIFY(!panel.model().showsClick());
        panel.showClickValues();
        QVERIFY(panel.model().showsClick());
        setCamera(document, cameraAt(1, 0, 5)); // turns no more
        QVERIFY(panel.model().showsClick());
        document.undoStack().undo();
        document.undoStack().undo();
        QVERIFY(!panel.model().showsClick());
        setCamera(document, cameraAt(0.5, 0, 5));
        QVERIFY(!panel.model().showsClick());
        panel.showClickValues();
        pickAt(document, WidgetPoint(200.0, 150.0), {0.75, 0, 24});
        setCamera(document, cameraAt(1, 0, 5));
        QVERIFY(!panel.model().showsClick());
    }

    void computingAgainPicksTheSamePixelOfTheViewAsItIs()
    {
        const auto window = cubeWindow(false);
        SceneDocument &document = window->document();
        const QPointF position = localOf(*window, kCubeCenter);
        window->view().onLButtonDown(WidgetPoint(position.x(), position.y()));
        const Pick before = *document.picks().pick();
        QVERIFY(before.hit());
        QPushButton *again = againButton(part<ComparisonPanel>(*window));
        QVERIFY(again->parentWidget()->isHidden());
        LookAt camera = document.setup().camera();
        camera.eye.z += 0.5;
        setCamera(document, camera);
        QVERIFY(!again->parentWidget()->isHidden() && again->isEnabled());
        QVERIFY(*document.picks().pick()->point.world[Method::Formula] == *before.point.world[Method::Formula]);
        again->click();
        const Pick &after = *document.picks().pick();
        QCOMPARE(after.devicePixel, before.devicePixel);
        QVERIFY(after.setup == document.setup());
        QVERIFY(after.hit() && *after.point.world[Method::Formula] != *before.point.world[Method::Formula]);
        QVERIFY(again->parentWidget()->isHidden());
    }

    void aPositionThatIsGoneCannotBePickedAgain()
    {
        SceneDocument document;
        openAndPick(document);
        ComparisonPanel panel(document);
        QSignalSpy requests(&panel, &ComparisonPanel::pickRequested);
        document.setSurface({500, 300, 1.0});
        againButton(panel)->click();
        QCOMPARE(requests.count(), 1);
        document.setSurface({100, 100, 1.0});
        QVERIFY(!againButton(panel)->isEnabled());
    }
};

UNPROJECTOR_TEST(TestSinceClick, display)
#include "test_since_click.moc"
