// The list of the last picks as the panel shows it: rows, showing one again, comparing two, copying
// all. No window of OpenGL.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/told_changes.h"

#include "gui/click/comparison_panel.h"
#include "gui/click/earlier_picks_view.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/text/number_text.h"
#include "gui/widgets/fold.h"
#include "gui/widgets/whole_table.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QToolButton>

using namespace unprojector;
using namespace unprojector::gui;
using namespace documenttest;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

void click(SceneDocument &document, double x, std::optional<std::size_t> object = 0, double depth = 0.5)
{
    pickAt(document, WidgetPoint(x, 300.0), {object ? depth : 1.0, object, 24});
}

struct Desk {
    Desk() { openScene(document); }
    SceneDocument document;
    EarlierPicksView view{document};

    QString cell(int row, int column) { return view.table().item(row, column)->text(); }
    QString head(int row) { return view.table().verticalHeaderItem(row)->text(); }
    void select(int row, bool isToo = false)
    {
        view.table().selectionModel()->select(
            view.table().model()->index(row, 0),
            (isToo ? QItemSelectionModel::Select : QItemSelectionModel::ClearAndSelect) | QItemSelectionModel::Rows);
    }
    QString copied(const QString &form)
    {
        for (QAction *action : view.findChildren<QAction *>()) {
            if (action->text().remove(u'&') == form)
                action->trigger();
        }
        return QApplication::clipboard()->text();
    }
};

} // namespace

Q_DECLARE_METATYPE(Verb)

class TestEarlierPicks : public QObject {
    Q_OBJECT

private slots:
    void aRowTellsThePick()
    {
        Desk desk;
        click(desk.document, 412.0);
        const Pick &pick = *desk.document.picks().pick();
        QCOMPARE(desk.view.table().rowCount(), 1);
        QCOMPARE(desk.head(0), QStringLiteral("• 1"));
        QCOMPARE(desk.cell(0, 1), pointText(*pick.point.world[Method::Formula], pick.uncertainty.world));
        QCOMPARE(desk.cell(0, 2), QStringLiteral("(412, 300)"));
        click(desk.document, 3.0, std::nullopt);
        QCOMPARE(desk.cell(0, 0), QStringLiteral("Background"));
        QCOMPARE(desk.cell(0, 1), QStringLiteral("–"));
        QCOMPARE(desk.head(0), QStringLiteral("• 2"));
        QCOMPARE(desk.head(1), QStringLiteral("1"));
    }

    void theNewestRowIsTheFirst()
    {
        Desk desk;
        click(desk.document, 100.0);
        click(desk.document, 200.0);
        QCOMPARE(desk.cell(0, 2), QStringLiteral("(200, 300)"));
        QCOMPARE(desk.cell(1, 2), QStringLiteral("(100, 300)"));
    }

    void aRowShowsItsPickAgain()
    {
        Desk desk;
        click(desk.document, 100.0);
        click(desk.document, 200.0);
        desk.select(1);
        QCOMPARE(desk.document.picks().pick()->devicePixel.i, 100);
        QCOMPARE(desk.head(1), QStringLiteral("• 1"));
        QCOMPARE(desk.view.table().rowCount(), 2);
        QCOMPARE(desk.view.table().selectionModel()->selectedRows().size(), 1);
    }

    void twoRowsAreCompared()
    {
        Desk desk;
        click(desk.document, 100.0, 0, 0.25);
        const WorldPoint first = *desk.document.picks().pickedPoint();
        click(desk.document, 250.0, 1, 0.5);
        const WorldPoint second = *desk.document.picks().pickedPoint();
        desk.select(1, true); // the shown one is selected
        QCOMPARE(desk.document.picks().pick()->devicePixel.i, 250);
        const QStringList lines = desk.view.difference().split(u'\n');
        QCOMPARE(lines[0], QStringLiteral("From pick 1 to pick 2"));
        const double told = lines[1].section(u' ', 1, 1).toDouble(), bound = lines[1].section(u' ', 3, 3).toDouble();
        QVERIFY2(lines[1].startsWith(QStringLiteral("Distance: ")), qPrintable(lines[1]));
        QVERIFY2(std::abs(told - distance(first, second)) <= 2.0 * bound, qPrintable(lines[1]));
        QVERIFY2(lines[2].startsWith(QStringLiteral("Δ (x, y, z): (")), qPrintable(lines[2]));
        const QString x = lines[2].section(u'(', 2).section(u',', 0, 0);
        QVERIFY2(std::abs(x.toDouble() - (second.x - first.x)) <= 2.0 * bound, qPrintable(x));
        QCOMPARE(lines[3], QStringLiteral("Depth: %1 → %2 (Δ 0.25)")
                               .arg(depthText(desk.document.picks().pick()->window.z - 0.25),
                                    depthText(desk.document.picks().pick()->window.z)));
        QCOMPARE(lines[4], QStringLiteral("Pixel: (100, 300) → (250, 300) (Δ 150, 0)"));
        QVERIFY2(lines[5].startsWith(QStringLiteral("Object: ")) && lines[5].contains(u'→'), qPrintable(lines[5]));
        QCOMPARE(lines[6], QStringLiteral("Setup: the same"));
        desk.select(0);
        QVERIFY(desk.view.difference().startsWith(QStringLiteral("Select two rows")));
    }

    void anotherSetupIsNamed_data()
    {
        addColumn<Verb>("verb");
        addColumn<QString>("expected");
        newRow("the camera") << Verb([](SceneDocument &d) {
            QVERIFY(editProjection(d, {d.scene().projection, true, false}, kLabel));
            setCamera(d, cameraAt(17.0));
        }) << "Setup: other camera";
        newRow("the depth range") << Verb([](SceneDocument &d) {
            QVERIFY(editViewport(d, d.scene().viewport, {0.1, 0.9}, kLabel));
        }) << "Setup: other depth range";
        newRow("the window") << Verb([](SceneDocument &d) {
            d.setSurface({400, 600, 1.0});
        }) << "Setup: other projection, viewport, window size";
        newRow("the object's place") << Verb([](SceneDocument &d) {
            const Translate step{{0.5, 0.0, 0.0}};
            QVERIFY(editTransform(d, 0, {step}, kLabel));
        }) << "The object was moved between the two clicks.";
    }

    void anotherSetupIsNamed()
    {
        QFETCH(Verb, verb);
        QFETCH(QString, expected);
        Desk desk;
        QVERIFY(editProjection(desk.document, {desk.document.scene().projection, true, false}, kLabel));
        click(desk.document, 100.0);
        verb(desk.document);
        click(desk.document, 200.0);
        desk.select(1, true);
        QVERIFY2(desk.view.difference().split(u'\n').contains(expected), qPrintable(desk.view.difference()));
    }

    void aClickEndsTheComparison()
    {
        Desk desk;
        click(desk.document, 100.0);
        click(desk.document, 200.0);
        desk.select(1, true);
        QVERIFY(renameObject(desk.document, 1, QStringLiteral("renamed")) == NameFault::None);
        QVERIFY(desk.view.difference().startsWith(QStringLiteral("From pick")));
        click(desk.document, 300.0);
        QCOMPARE(desk.view.table().selectionModel()->selectedRows().size(), 1);
        QVERIFY(!desk.view.difference().startsWith(QStringLiteral("From pick")));
    }

    void rowsHaveTheirObjectsNames()
    {
        Desk desk;
        click(desk.document, 100.0, 0);
        click(desk.document, 200.0, 1);
        QVERIFY(renameObject(desk.document, 0, QStringLiteral("short")) == NameFault::None);
        QCOMPARE(desk.cell(1, 0), QStringLiteral("short"));
        QVERIFY(removeObject(desk.document, 0));
        QCOMPARE(desk.view.table().rowCount(), 1);
        QCOMPARE(desk.cell(0, 2), QStringLiteral("(200, 300)"));
        desk.document.undoStack().undo();
        QCOMPARE(desk.cell(1, 0), QStringLiteral("short"));
    }

    void allRowsAreCopied()
    {
        Desk desk;
        QVERIFY(renameObject(desk.document, 0, QStringLiteral("left, \"upper\"")) == NameFault::None);
        click(desk.document, 412.0);
        const Pick pick = *desk.document.picks().pick();
        const WorldPoint world = *desk.document.picks().pickedPoint();
        click(desk.document, 3.0, std::nullopt);
        QCOMPARE(desk.copied(QStringLiteral("Copy as text")),
                 QStringLiteral("Pick\tObject\tWorld coordinate\tPixel\n2\tBackground\t\t(3, 300)\n"
                                "1\tleft, \"upper\"\t%1\t(412, 300)\n")
                     .arg(pointText(world, pick.uncertainty.world)));
        const QStringList lines = desk.copied(QStringLiteral("Copy as CSV")).split(u'\n');
        QCOMPARE(lines[0],
                 QStringLiteral("pick,object,x,y,z,uncertainty_x,uncertainty_y,uncertainty_z,pixel_i,pixel_j,depth"));
        QCOMPARE(lines[1], QStringLiteral("2,,,,,,,,3,300,1"));
        const QString name = QStringLiteral("1,\"left, \"\"upper\"\"\",");
        QVERIFY2(lines[2].startsWith(name), qPrintable(lines[2]));
        const QStringList cells = lines[2].mid(name.size()).split(u',');
        QCOMPARE(cells.size(), 9);
        for (int axis = 0; axis < 3; ++axis)
            QCOMPARE(cells[axis].toDouble(), world[axis]); // every digit
        QCOMPARE(cells[8].toDouble(), pick.window.z);
    }

    void theFoldIsThereWithTheRows()
    {
        SceneDocument document;
        openScene(document);
        ComparisonPanel panel(document);
        const QWidget *fold = panel.findChild<EarlierPicksView *>()->parentWidget();
        QVERIFY(fold->isHidden());
        click(document, 100.0);
        QVERIFY(!fold->isHidden());
        QVERIFY(panel.openFolds().isEmpty());
        panel.setOpenFolds({QStringLiteral("picks")});
        QCOMPARE(panel.openFolds(), QStringList{QStringLiteral("picks")});
        document.picks().clearPick();
        QVERIFY(!fold->isHidden()); // the list outlives the pick
        openScene(document);
        QVERIFY(fold->isHidden());
    }
};

UNPROJECTOR_TEST(TestEarlierPicks)
#include "test_earlier_picks.moc"
