// Every value of the panels has a menu that copies it with all its digits, as text and for code.

#include "tests/support/test.h"

#include "gui/click/comparison_model.h"
#include "gui/click/coordinates_table.h"
#include "gui/pipeline/matrix_section.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/pipeline/viewport_inspector.h"
#include "gui/text/number_text.h"
#include "gui/widgets/formula_view.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/steady_label.h"

#include "tests/gui/comparison_picks.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>

using namespace comparing;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;
using namespace unprojector::unproject;

namespace {

/// The texts that the menu's entries copy at a position.
QStringList copied(QWidget &widget, const QPoint &position)
{
    QContextMenuEvent event(QContextMenuEvent::Mouse, position, widget.mapToGlobal(position));
    QCoreApplication::sendEvent(&widget, &event);
    QStringList texts;
    auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
    if (!menu)
        return texts;
    for (QAction *action : menu->actions()) {
        if (action->isSeparator())
            continue;
        QApplication::clipboard()->clear();
        action->trigger();
        texts << QApplication::clipboard()->text();
    }
    menu->close();
    return texts;
}

SteadyLabel *steadyLabelNamed(const QWidget &panel, const char *name)
{
    for (SteadyLabel *label : panel.findChildren<SteadyLabel *>()) {
        if (label->accessibleName() == QLatin1String(name))
            return label;
    }
    return nullptr;
}

const Pick &somePick()
{
    static const Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
    return pick;
}

} // namespace

class TestCopyMenu : public QObject {
    Q_OBJECT

private slots:
    void aCellIsCopiedAloneAndAsItsPoint()
    {
        PanelOfPicks panel;
        panel.resize(460, 900);
        panel.setPick(somePick());
        panel.show();
        auto *table = panel.findChild<CoordinatesTable *>();
        const WorldPoint world = *somePick().point.world[Method::Formula];
        const QStringList texts =
            copied(*table->viewport(), table->visualRect(table->model()->index(1, ComparisonModel::Formula)).center());
        const QString x = shortestText(world.x), y = shortestText(world.y), z = shortestText(world.z);
        QCOMPARE(texts.size(), 7);
        QCOMPARE(texts[0], y);
        QCOMPARE(texts[1], QStringLiteral("%1 %2 %3\n").arg(x, y, z));
        QVERIFY2(texts[2].startsWith(QStringLiteral("const double world[3] = {%1, %2, ").arg(x, y)),
                 qPrintable(texts[2]));
        QVERIFY2(texts[3].startsWith(QStringLiteral("const glm::dvec3 world(%1, %2, ").arg(x, y)),
                 qPrintable(texts[3]));
        QVERIFY2(texts[4].startsWith(QStringLiteral("world = np.array([%1, %2, ").arg(x, y)), qPrintable(texts[4]));
        QVERIFY2(texts[5].startsWith(QStringLiteral("\\mathrm{world} = \\begin{bmatrix} %1 \\\\ %2").arg(x, y)),
                 qPrintable(texts[5]));
        QCOMPARE(texts[6], QStringLiteral("%1,%2,%3\n").arg(x, y, z));
    }

    void aLinkOfTheChainIsCopied()
    {
        PanelOfPicks panel;
        panel.resize(460, 900);
        panel.setPick(somePick());
        panel.setOpenFolds({QStringLiteral("pixel")});
        panel.show();
        SteadyLabel *window = steadyLabelNamed(panel, "Window position");
        const QStringList texts = copied(*window, window->rect().center());
        QCOMPARE(texts.size(), 7);
        QCOMPARE(texts[0], window->text());
        QCOMPARE(texts[3], QStringLiteral("const glm::dvec3 window(412.5, 300.5, 0.75);\n"));
        SteadyLabel *depth = steadyLabelNamed(panel, "Depth");
        QCOMPARE(copied(*depth, depth->rect().center()).value(2), QStringLiteral("const double depth = 0.75;\n"));
    }

    void aTermOfAFormulaIsCopied()
    {
        const HelpOpener opener([](const QString &) {}, [](const QString &) {}, nullptr);
        FormulaView view;
        view.resize(420, 900);
        view.setFormulas(formulasOf(somePick()));
        view.show();
        const QStringList texts =
            copied(*view.viewport(), view.placesOf(QStringLiteral("r")).front().center().toPoint());
        QCOMPARE(texts.size(), 8); // the last one leads to Help and copies nothing
        QCOMPARE(texts[0], formulasOf(somePick()).text() + u'\n');
        QCOMPARE(texts[1], QStringLiteral("0.8284271247461901\n")); // not the six digits that are set
        QCOMPARE(copied(*view.viewport(), QPoint(view.width() - 30, 2)).size(), 1);
    }

    void aPointOfThePipelineIsCopied()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        pickAt(document, WidgetPoint(400, 300), {0.75, 0, 24});
        PipelinePanel panel(document);
        panel.resize(460, 2000);
        panel.show();
        const PointModel *clip = panel.model().point(PointModel::Space::Clip);
        for (NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
            if (grid->model() != clip)
                continue;
            const QStringList texts = copied(*grid->viewport(), grid->visualRect(clip->indexOf(3)).center());
            QCOMPARE(texts.size(), 9); // the last two type and paste
            QCOMPARE(texts[0], shortestText(clip->coordinates()[3]));
            QVERIFY(texts[2].startsWith(QStringLiteral("const double clip[4] = {")));
        }
    }

    void aNumberOfAMatrixIsCopied()
    {
        SceneDocument document;
        PipelinePanel panel(document);
        panel.resize(460, 2000);
        panel.show();
        const MatrixModel *projection = panel.model().matrix(PipelineStage::ProjectionMatrix);
        for (NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
            if (grid->model() != projection)
                continue;
            const QStringList texts = copied(*grid->viewport(), grid->visualRect(projection->index(1, 1)).center());
            QCOMPARE(texts.size(), 7);
            QCOMPARE(texts[0], projection->fullText(1, 1));
            QCOMPARE(texts[1], projection->copyText(MatrixSyntax::Text));
            QCOMPARE(texts[6], projection->copyText(MatrixSyntax::Csv));
            QCOMPARE(texts[6].count(u','), 12);
            QCOMPARE(texts[6].count(u'\n'), 4);
        }
    }

    void aCornerIsCopied()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        ViewportInspector panel(document);
        panel.resize(1600, 300);
        panel.show();
        auto *table = panel.findChild<QTableView *>();
        const QStringList texts =
            copied(*table->viewport(), table->visualRect(table->model()->index(3, 2)).center()); // bottom right, window
        QCOMPARE(texts.size(), 6);
        QCOMPARE(texts[0], QStringLiteral("799.5 0.5\n"));
        SteadyLabel *viewport = steadyLabelNamed(panel, "Viewport");
        QCOMPARE(copied(*viewport, viewport->rect().center()).value(2),
                 QStringLiteral("const double viewport[4] = {0.0, 0.0, 800.0, 600.0};\n"));
    }

    void whereNothingIsThereIsNoMenu()
    {
        PanelOfPicks panel;
        panel.resize(460, 900);
        panel.show();
        auto *table = panel.findChild<CoordinatesTable *>();
        QVERIFY(
            copied(*table->viewport(), table->visualRect(table->model()->index(1, ComparisonModel::Formula)).center())
                .isEmpty());
    }
};

UNPROJECTOR_TEST(TestCopyMenu)
#include "test_copy_menu.moc"
#include "tests/gui/document_edits.h"
