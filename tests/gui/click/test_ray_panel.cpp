// The comparison's report on the ray's hit on the mesh, case by case: its coordinates, their
// distance from the formula's, the one to trust, and the copied text. No window of OpenGL is
// needed.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/told_changes.h"

#include "core/examples/solids.h"
#include "gui/click/comparison_model.h"
#include "gui/click/comparison_panel.h"
#include "gui/click/other_programs_view.h"
#include "gui/click/ray_model.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/text/ray_text.h"
#include "gui/widgets/whole_table.h"
#include "tests/support/mesh_model.h"
#include "tests/support/patience.h"

#include <QLabel>

#include <memory>
#include <optional>

using namespace unprojector;
using namespace unprojector::gui;
using namespace documenttest;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::ray;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

Mesh pointAt(const glm::vec3 &position)
{
    Mesh mesh;
    mesh.kind = Mesh::Kind::Points;
    mesh.positions = {position};
    return mesh;
}

/// Opens two cubes of edge 2 behind each other, "front" and "back", and a point, seen along -z from
/// (0, 0, 12): the fronts are at z = 1 and -4. A pixel is 0.02 wide.
void openCubes(SceneDocument &document)
{
    const auto cube = modelOf(examples::cubeMesh(2.0));
    document.setSurface({400, 300, 1.0});
    Scene scene;
    scene.camera = scene.home = {WorldPoint(0, 0, 12), WorldPoint(0, 0, 0), {0, 1, 0}};
    scene.projection = Ortho{-4, 4, -3, 3, 1, 41};
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    scene.objects = {{"front", {}, cube, {}},
                     {"back", {}, cube, {Translate{{0, 0, -5}}}},
                     {"point", {}, modelOf(pointAt({3, 0, 0})), {}}};
    QVERIFY(document.open(scene));
}

/// The depth sample of a height.
DepthSample at(double z, std::size_t object)
{
    return {(12.0 - z - 1.0) / 40.0, object, 24};
}
const DepthSample kBackground{1.0, {}, 24};

QString said(const QWidget &panel, const char *accessibleName)
{
    for (const QLabel *label : panel.findChildren<QLabel *>()) {
        if (label->accessibleName() == QLatin1String(accessibleName))
            return label->text().replace(QChar::Nbsp, u' ');
    }
    return {};
}

double value(const ComparisonPanel &panel, int row, int column)
{
    const QVariant v = panel.rayModel().index(row, column).data(CoordinatesModel::kValueRole);
    return v.isValid() ? v.toDouble() : std::nan("");
}

} // namespace

Q_DECLARE_METATYPE(DepthSample)

class TestRayPanel : public QObject {
    Q_OBJECT

private slots:
    void eachSituationIsExplained_data()
    {
        addColumn<WidgetPoint>("position");
        addColumn<DepthSample>("sample");
        addColumn<QStringList>("expected");
        const auto row = [](const char *name, const WidgetPoint &position, const DepthSample &sample,
                            const QStringList &expected) { newRow(name) << position << sample << expected; };
        const WidgetPoint onCube(220, 140), beside(20, 20), nearPoint(352, 146);
        row("the same surface", onCube, at(1.0, 0), {" from the formula, in depth steps 0. Trust the exact hit"});
        row("a step off", onCube, at(1.0 - 40.0 / 16777215.0, 0),
            {"Exact hit: 0.000002 from the formula, in depth steps 1. Trust the exact hit"});
        row("another part of it", onCube, at(-1.0, 0), {"2 before the formula: an edge", "Trust the exact hit"});
        row("another object is drawn behind", onCube, at(-4.0, 1),
            {"The ray meets front, 5 before back", "Trust the exact hit"});
        row("another object is drawn before", onCube, at(3.0, 1),
            {"The ray meets front, 2 behind back", "Trust the exact hit"});
        row("two surfaces at one depth", onCube, at(1.0, 1),
            {"Two surfaces at one depth, ", "back is drawn, the ray meets front."});
        row("only drawn", beside, at(1.0, 0), {"The ray meets nothing, front is drawn", "Trust the formula"});
        row("only met", onCube, kBackground, {"The ray meets front, nothing is drawn", "Trust the exact hit"});
        row("nothing", beside, kBackground, {"The ray meets no mesh either."});
        row("a point of a cloud", nearPoint, at(0.0, 2), {"The ray takes the nearest point", "it is the file's"});
        row("a point beside which nothing is drawn", nearPoint, kBackground,
            {"The ray takes the nearest point, within 8"});
    }

    void eachSituationIsExplained()
    {
        QFETCH(WidgetPoint, position);
        QFETCH(DepthSample, sample);
        QFETCH(QStringList, expected);
        SceneDocument document;
        openCubes(document);
        const ComparisonPanel panel(document);
        QCOMPARE(said(panel, "Exact hit"), QString());
        pickAt(document, position, sample);
        const QString text = said(panel, "Exact hit");
        for (const QString &part : expected)
            QVERIFY2(text.contains(part), qPrintable(text));
    }

    void anEdgeInThePixelIsTold_data()
    {
        addColumn<WidgetPoint>("position");
        addColumn<DepthSample>("sample");
        addColumn<Snap>("snap");
        addColumn<QString>("expected");
        const QString centre = QStringLiteral(" The ± is for the pixel's centre only.");
        // The cube in front is moved by a quarter of a pixel to the right.
        newRow("over the back") << WidgetPoint(150, 140) << at(1.0, 0) << Snap::Surface
                                << "This pixel holds an edge of the surface: 5 behind it lies back." + centre;
        newRow("a vertex has none") << WidgetPoint(150, 200) << at(1.0, 0) << Snap::Vertex << QString();
        newRow("on the background") << WidgetPoint(250, 140) << kBackground << Snap::Surface
                                    << QStringLiteral("This pixel holds an edge of front. The click is beside it.");
        newRow("three pixels before") << WidgetPoint(147, 140) << kBackground << Snap::Surface << QString();
        newRow("in the middle") << WidgetPoint(220, 140) << at(1.0, 0) << Snap::Surface << QString();
    }

    void anEdgeInThePixelIsTold()
    {
        QFETCH(WidgetPoint, position);
        QFETCH(DepthSample, sample);
        QFETCH(Snap, snap);
        QFETCH(QString, expected);
        SceneDocument document;
        openCubes(document);
        QVERIFY(editTransform(document, 0, {Translate{{0.005, 0, 0}}}, {QStringLiteral("move")}));
        document.picks().setSnap(snap);
        const ComparisonPanel panel(document);
        pickAt(document, position, sample);
        QTRY_COMPARE_WITH_TIMEOUT(document.picks().pickedRay()->state, PickedRay::State::Answered,
                                  kPatienceMilliseconds);
        QCOMPARE(said(panel, "Edge in the pixel"), expected);
        QCOMPARE(panel.text().contains("holds an edge"), !expected.isEmpty());
    }

    void theTableHasTheRaysNumbers()
    {
        SceneDocument document;
        openCubes(document);
        const ComparisonPanel panel(document);
        for (int column = 0; column < RayModel::ColumnCount; ++column)
            QCOMPARE(panel.rayModel().index(0, column).data().toString(), QStringLiteral("–"));
        pickAt(document, WidgetPoint(220, 140), at(0.5, 0));
        const SceneHit &hit = document.picks().pickedRay()->met->hit;
        const WorldPoint formula = *document.picks().pick()->point.world[Method::Formula];
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(value(panel, axis, RayModel::Met) == hit.world[axis]);
            const QVariant off =
                panel.model().index(axis, ComparisonModel::RayDifference).data(CoordinatesModel::kValueRole);
            QVERIFY(off.toDouble() == formula[axis] - hit.world[axis]);
            QVERIFY(value(panel, axis, RayModel::Normal) == (axis == 2 ? 1.0 : 0.0));
            QVERIFY(value(panel, axis, RayModel::Taken) == 1.0);
        }
        QCOMPARE(panel.rayModel().headerData(RayModel::Taken, Qt::Horizontal).toString(), QStringLiteral("Vertex"));
        const QString detail = said(panel, "Triangle, vertex and edge");
        QVERIFY2(detail.startsWith(QStringLiteral("Triangle %1, barycentric (").arg(hit.triangle->triangle)),
                 qPrintable(detail));
        QVERIFY2(detail.contains(QStringLiteral("vertex %1 is 1.0 away").arg(hit.vertex.id))
                     || detail.contains(QStringLiteral("vertex %1 is 1 away").arg(hit.vertex.id)),
                 qPrintable(detail));
        // The black digits are those certain by mesh and arithmetic.
        const QModelIndex cell = panel.rayModel().index(0, RayModel::Met);
        QVERIFY(cell.data(CoordinatesModel::kCertainLengthRole).toInt() >= 8);
        // A background pixel whose ray hits nothing has no values.
        pickAt(document, WidgetPoint(20, 20), kBackground);
        QVERIFY(std::isnan(value(panel, 0, RayModel::Met)) && std::isnan(value(panel, 0, RayModel::Taken)));
    }

    void whatAClickTakesIsShown_data()
    {
        addColumn<int>("snap");
        addColumn<WidgetPoint>("position");
        addColumn<QString>("head");
        addColumn<QList<double>>("point");
        addColumn<QStringList>("detail");
        const auto row = [](const char *name, Snap snap, const WidgetPoint &position, const char *head,
                            const QList<double> &point, const QStringList &detail) {
            newRow(name) << int(snap) << position << QString::fromLatin1(head) << point << detail;
        };
        // The cube's corner (1, 1, 1) is at pixel (250, 100), its right edge at column 250.
        row("a vertex", Snap::Vertex, WidgetPoint(246, 104), "Vertex", {1, 1, 1}, {"Snapped to vertex", "of triangle"});
        row("no vertex", Snap::Vertex, WidgetPoint(220, 120), "Vertex", {}, {"No vertex is visible within 8 pixels."});
        row("an edge", Snap::Edge, WidgetPoint(246, 119.5), "On edge", {1, 0.61, 1}, {"the nearest point of edge"});
        row("no edge", Snap::Edge, WidgetPoint(170, 160), "On edge", {}, {"No edge is visible within 8 pixels."});
        row("a face", Snap::Face, WidgetPoint(220, 140), "On face", {0.41, 0.19, 1},
            {"Snapped to face", "0 x + 0 y + 1 z = 1"});
        row("no face", Snap::Face, WidgetPoint(20, 20), "On face", {}, {"No face is visible within 8 pixels."});
    }

    void whatAClickTakesIsShown()
    {
        QFETCH(int, snap);
        QFETCH(WidgetPoint, position);
        QFETCH(QString, head);
        QFETCH(QList<double>, point);
        QFETCH(QStringList, detail);
        SceneDocument document;
        openCubes(document);
        const ComparisonPanel panel(document);
        document.picks().setSnap(static_cast<Snap>(snap));
        pickAt(document, position, at(1.0, 0));
        QCOMPARE(panel.rayModel().headerData(RayModel::Taken, Qt::Horizontal).toString(), head);
        for (int axis = 0; axis < 3; ++axis) {
            if (point.isEmpty())
                QVERIFY(std::isnan(value(panel, axis, RayModel::Taken)));
            else if (static_cast<Snap>(snap) == Snap::Vertex)
                QVERIFY2(value(panel, axis, RayModel::Taken) == point[axis], "its exact coordinate");
            else
                QVERIFY(std::abs(value(panel, axis, RayModel::Taken) - point[axis]) < 1e-12);
        }
        const QString text = said(panel, "Triangle, vertex and edge");
        for (const QString &part : detail)
            QVERIFY2(text.contains(part), qPrintable(text));
        // A later snap mode does not change this pick.
        document.picks().setSnap(Snap::Surface);
        QCOMPARE(said(panel, "Triangle, vertex and edge"), text);
    }

    void theAnswerComesByItself()
    {
        SceneDocument document;
        openCubes(document);
        const ComparisonPanel panel(document);
        QVERIFY(addObjects(document, {{"ball", {}, modelOf(examples::sphereMesh(1.5, 7)), {}}}));
        pickAt(document, WidgetPoint(200, 150), at(1.5, 3));
        QCOMPARE(said(panel, "Exact hit"), rayPreparingText());
        QVERIFY(std::isnan(value(panel, 2, RayModel::Met)));
        QVERIFY(QTest::qWaitFor([&] { return document.picks().pickedRay()->state == PickedRay::State::Answered; },
                                kPatienceMilliseconds));
        QVERIFY2(said(panel, "Exact hit").contains("Trust the exact hit"), qPrintable(said(panel, "Exact hit")));
        QVERIFY(std::abs(value(panel, 2, RayModel::Met) - 1.5) < 1e-3);
    }

    /// A pixel is 0.02 wide: half of it left and up is 0.0141 off. The cube's upper edge is at row 100;
    /// above it is the far plane.
    void otherProgramsAnswerTheSameClick()
    {
        SceneDocument document;
        openCubes(document);
        const auto pickOf = [&document](const WidgetPoint &position, const DepthSample &sample) {
            pickAt(document, position, sample);
            QTRY_VERIFY_WITH_TIMEOUT(document.picks().pickedRay()->state == PickedRay::State::Answered,
                                     kPatienceMilliseconds);
        };
        ComparisonPanel panel(document);
        pickOf({220, 140}, at(1.0, 0));
        QVERIFY(document.picks().pickedRay()->others);
        // The frame around the pixel is unknown if the scene has a cloud.
        QVERIFY(!(*document.picks().pickedRay()->others)[2].point);
        QVERIFY(removeObject(document, 2));
        pickOf({220, 140}, at(1.0, 0));
        const WorldPoint formula = *document.picks().pick()->point.world[Method::Formula];
        for (const OtherAnswer &answer : *document.picks().pickedRay()->others) {
            QVERIFY(answer.point);
            if (answer.program != OtherProgram::Vtk)
                QVERIFY(std::abs(distance(*answer.point, formula) - 0.02 * std::sqrt(0.5)) < 1e-5);
        }
        QVERIFY(panel.text().contains("MeshLab\t0.0141"));
        const auto *table = panel.findChild<OtherProgramsView *>()->findChild<WholeTable *>();
        QCOMPARE(table->verticalHeaderItem(2)->text(), QStringLiteral("MeshLab"));
        QCOMPARE(table->item(2, 0)->text(), QStringLiteral("0.0141"));
        QCOMPARE(table->item(2, 1)->text(), QStringLiteral("forgets the 1 in height − 1 − y"));
        panel.findChild<OtherProgramsView *>()->findChild<WholeTable *>()->setCurrentCell(2, 0);
        const QString reason = said(panel, "Its point and its reason");
        QVERIFY2(reason.startsWith("MeshLab: It gets (") && reason.contains("Height − y without the 1"),
                 qPrintable(reason));

        pickOf({220, 100}, at(1.0, 0));
        const OtherAnswer &meshLab = (*document.picks().pickedRay()->others)[2];
        QVERIFY(meshLab.program == OtherProgram::MeshLab);
        QVERIFY(std::abs(meshLab.point->z - -29.0) < 1e-9); // far is 41 before the eye
        pickAt(document, WidgetPoint(20, 20), kBackground);
        QVERIFY(!document.picks().pickedRay()->others);
        QVERIFY(!panel.text().contains("MeshLab"));
    }

    void allOfItIsCopied()
    {
        SceneDocument document;
        openCubes(document);
        const ComparisonPanel panel(document);
        pickAt(document, WidgetPoint(220, 140), at(1.0, 0));
        const QString copied = panel.text().replace(QChar::Nbsp, u' ');
        QVERIFY(copied.contains(panel.rayModel().text()));
        QVERIFY(copied.contains(said(panel, "Exact hit")) && copied.contains(said(panel, "Triangle, vertex and edge")));
        QVERIFY(panel.rayModel().text().contains(shortestText(document.picks().pickedRay()->met->hit.world.x)));
        const QModelIndex cell = panel.rayModel().index(1, RayModel::Met);
        QCOMPARE(panel.rayModel().pointAt(cell).size(), std::size_t(3));
        QCOMPARE(panel.rayModel().pointNameAt(cell), QStringLiteral("rayOnMesh"));
    }
};

UNPROJECTOR_TEST(TestRayPanel)
#include "test_ray_panel.moc"
