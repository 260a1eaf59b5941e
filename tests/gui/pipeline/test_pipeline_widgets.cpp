// The pipeline panel as a widget: its copies, its fit, and its work while it is hidden.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/pipeline/pipeline_figures.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/pipeline/factor_drawing.h"
#include "gui/pipeline/factor_shares.h"
#include "gui/pipeline/factors_view.h"
#include "gui/pipeline/matrix_section.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/widgets/number_grid.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>
#include <QWheelEvent>

#include <glm/gtc/matrix_transform.hpp>

using namespace unprojector;
using namespace unprojector::gui;
using namespace pipelinetest;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;
using namespace unprojector::scene_file;

namespace {

QToolButton *opener(const PipelinePanel &panel, const QString &text)
{
    for (QToolButton *button : panel.findChild<PipelineChain *>()->findChildren<QToolButton *>()) {
        if (button->text() == text)
            return button;
    }
    return nullptr;
}

/// The titles of the matrices in sight.
QStringList titles(const PipelinePanel &panel)
{
    QStringList shown;
    for (const MatrixSection *section : panel.findChildren<MatrixSection *>()) {
        if (section->isVisible())
            shown << section->findChild<QLabel *>()->text();
    }
    return shown;
}

} // namespace

class TestPipelineWidgets : public QObject {
    Q_OBJECT

private slots:
    void aTooltipNamesTheEntry()
    {
        SceneDocument document;
        openFigures(document);
        setProjection(document, Frustum{-1, 3, -2, 1, 2, 10});
        PipelineModel model(document);
        const MatrixModel *projection = model.matrix(Stage::ProjectionMatrix);
        const auto tip = [&](int row, int column) {
            return projection->index(row, column).data(Qt::ToolTipRole).toString();
        };
        QCOMPARE(tip(0, 2), QStringLiteral("(r+l)/(r−l) = 0.5\nrow 1, column 3, m[8]"));
        QCOMPARE(tip(3, 2), QStringLiteral("−1, always\nrow 4, column 3, m[11]"));
        model.setView({MatrixLayout::Row, false, Digits::Double});
        QCOMPARE(tip(2, 0), QStringLiteral("(r+l)/(r−l) = 0.5\nrow 3, column 1, m[8]"));
        model.setView({MatrixLayout::Row, true, Digits::Double});
        QCOMPARE(tip(0, 1), QStringLiteral("(r+l)/(r−l) = 0.5\nrow 3, column 1, m[8]"));
        QCOMPARE(model.matrix(Stage::WholeMatrix)->index(7, 1).data(Qt::ToolTipRole).toString().section(u'\n', 1),
                 QStringLiteral("row 4, column 4, m[15]"));
    }

    void hiddenItStandsStillAndCatchesUpWhenShown()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        const MatrixModel *view = panel.model().matrix(Stage::ViewMatrix);
        QSignalSpy changed(view, &QAbstractItemModel::dataChanged);
        setCamera(document, {WorldPoint(0, 0, 7), WorldPoint(0, 0, 0), {0, 1, 0}});
        QCOMPARE(value(view, 2, 3), -5.0);
        QCOMPARE(changed.count(), 0);
        panel.show();
        QCOMPARE(value(view, 2, 3), -7.0);
        setCamera(document, {WorldPoint(0, 0, 8), WorldPoint(0, 0, 0), {0, 1, 0}});
        QCOMPARE(value(view, 2, 3), -8.0);
        panel.hide();
        setCamera(document, {WorldPoint(0, 0, 9), WorldPoint(0, 0, 0), {0, 1, 0}});
        QCOMPARE(value(view, 2, 3), -8.0);
    }

    void numbersThatAreTooLongLoseDigitsNotPlaces()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        setCamera(document, {WorldPoint(0, 0, 12345.678901), WorldPoint(0, 0, 0), {0, 1, 0}});
        model.update();
        MatrixModel *view = model.matrix(Stage::ViewMatrix);
        view->setCapacity(12);
        QCOMPARE(cell(view, 2, 3), QStringLiteral("-12345.6789"));
        view->setCapacity(7);
        QCOMPARE(cell(view, 2, 3), QStringLiteral("-12346"));
        QCOMPARE(view->fullText(2, 3), QStringLiteral("-12345.678901"));
        // The decimal points of a column are aligned.
        view->setCapacity(12);
        QCOMPARE(view->index(2, 3).data().toString().size(), view->index(0, 3).data().toString().size());
    }

    void aStageOpensItsMatrix()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        panel.resize(420, 1500);
        panel.show();
        QCOMPARE(titles(panel), QStringList{QStringLiteral("Projection: eye → clip")});
        const auto press = [&panel](const QString &name) { QTest::keyClick(opener(panel, name), Qt::Key_Space); };
        for (const auto &[name, title] :
             {std::pair("world", "Model: object → world"), std::pair("eye", "View: world → eye"),
              std::pair("clip", "Projection: eye → clip"), std::pair("window", "Viewport: NDC → window"),
              std::pair("Modelview", "Modelview: object → eye"),
              std::pair("All: object → window", "All: object → window")}) {
            press(QString::fromUtf8(name));
            QCOMPARE(titles(panel), QStringList{QString::fromUtf8(title)});
            QVERIFY(opener(panel, QString::fromUtf8(name))->isChecked());
            press(QString::fromUtf8(name)); // again: it stays
            QCOMPARE(titles(panel).size(), 1);
            QVERIFY(opener(panel, QString::fromUtf8(name))->isChecked());
        }
        press(QStringLiteral("NDC")); // the division
        QVERIFY(titles(panel).isEmpty());
        panel.setDirection(PipelineDirection::Backward);
        press(QStringLiteral("NDC"));
        QCOMPARE(titles(panel), QStringList{QStringLiteral("Viewport⁻¹: window → NDC")});
        press(QStringLiteral("Open all"));
        QCOMPARE(titles(panel).size(), 6);
        press(QStringLiteral("Open all"));
        QCOMPARE(titles(panel).size(), 1);
    }

    void chainAndAMatrixFitASmallPanel()
    {
        SceneDocument document;
        openFigures(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        PipelinePanel panel(document);
        const int line = panel.fontMetrics().lineSpacing();
        panel.resize(420, 26 * line);
        panel.show();
        for (const PipelineDirection direction : {PipelineDirection::Forward, PipelineDirection::Backward}) {
            panel.setDirection(direction);
            for (const Space space : {Space::World, Space::Eye, Space::Clip}) {
                panel.open(space);
                QCoreApplication::processEvents();
                int seen = 0;
                for (const NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
                    if (!grid->isVisible())
                        continue;
                    ++seen;
                    QVERIFY2(grid->visibleRegion().boundingRect() == grid->rect(), qPrintable(grid->accessibleName()));
                }
                QVERIFY(seen >= PointModel::kSpaces);
            }
        }
    }

    void theFormatMenuNamesItsGroups()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        panel.show();
        const auto *format = panel.findChild<QToolButton *>(QStringLiteral("format"));
        QVERIFY(format);
        QStringList titles;
        for (const QAction *action : format->menu()->actions()) {
            if (!action->isSeparator() && !action->isCheckable())
                titles << action->text();
        }
        QCOMPARE(titles, (QStringList{QStringLiteral("Vectors"), QStringLiteral("Arrangement"),
                                      QStringLiteral("Digits"), QStringLiteral("Conventions")}));
        for (const char *name : {"rows", "memory_order", "float_digits"})
            panel.findChild<QAction *>(QLatin1String(name))->trigger();
        QVERIFY(panel.matrixView() == (MatrixView{MatrixLayout::Row, true, Digits::Float}));
        for (const char *shown : {"Rows", "m[0..15]", "float", "OpenGL"})
            QVERIFY2(format->toolTip().contains(QLatin1String(shown)), qPrintable(format->toolTip()));
        // Other conventions are named without the menu open.
        panel.findChild<QAction *>(QStringLiteral("conventions_vulkan"))->trigger();
        QCOMPARE(format->text(), QStringLiteral("Format (Vulkan)"));
    }

    void allDigitsOfAllPointsScrollTogether()
    {
        SceneDocument document;
        openFigures(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        PipelinePanel panel(document);
        panel.resize(420, 900);
        panel.show();
        const auto *chain = panel.findChild<PipelineChain *>();
        const int height = chain->height();
        panel.setMatrixView({MatrixLayout::Column, false, Digits::Double, true});
        QCoreApplication::processEvents();
        QScrollBar *bar = nullptr;
        for (QScrollBar *one : chain->findChildren<QScrollBar *>()) {
            if (one->isVisible()) {
                QVERIFY(!bar); // one for all
                bar = one;
            }
        }
        QVERIFY(bar && bar->maximum() > 0);
        QVERIFY(chain->height() <= height + bar->height());
        const QList<NumberGrid *> grids = chain->findChildren<NumberGrid *>();
        bar->setValue(bar->maximum());
        for (const NumberGrid *grid : grids)
            QCOMPARE(grid->horizontalScrollBar()->value(), grid->horizontalScrollBar()->maximum());
        QCOMPARE(bar->value(), bar->maximum()); // the widget position is shorter
        // An arrow key scrolls them all as well.
        grids[1]->setCurrentIndex(grids[1]->model()->index(0, 0));
        QCOMPARE(bar->value(), 0);
        QCOMPARE(grids[0]->horizontalScrollBar()->value(), 0);
    }

    void anotherDirectionKeepsTheMatrix()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        panel.resize(420, 900);
        panel.show();
        for (const auto &[space, title] :
             {std::pair(Space::World, "Model⁻¹: world → object"), std::pair(Space::Eye, "View⁻¹: eye → world"),
              std::pair(Space::Clip, "Projection⁻¹: clip → eye"),
              std::pair(Space::Window, "Viewport⁻¹: window → NDC")}) {
            panel.setDirection(PipelineDirection::Forward);
            panel.open(space);
            panel.setDirection(PipelineDirection::Backward);
            QCOMPARE(titles(panel), QStringList{QString::fromUtf8(title)});
            panel.setDirection(PipelineDirection::Forward);
            QVERIFY(panel.opened() == ChainPart(space));
        }
    }

    void aMatrixIsTakenApartAndItsFactorsFollow()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        panel.resize(420, 2500);
        panel.show();
        const QList<QToolButton *> buttons = panel.findChildren<QToolButton *>(QStringLiteral("takeApart"));
        QCOMPARE(buttons.size(), 2);
        QCOMPARE(buttons.back()->accessibleName(), QStringLiteral("Decompose Projection"));
        const FactorsView *view = panel.findChildren<FactorsView *>().back();
        QVERIFY(!view->isVisible());
        panel.open(Space::Clip);
        QTest::keyClick(buttons.back(), Qt::Key_Space);
        QVERIFY(view->isVisible());
        const auto grids = [view] {
            QList<const MatrixModel *> shown;
            for (const NumberGrid *grid : view->findChildren<NumberGrid *>()) {
                if (grid->isVisible() && !view->findChild<FactorShares *>()->isAncestorOf(grid))
                    shown << qobject_cast<const MatrixModel *>(grid->model());
            }
            return shown;
        };
        const auto product = [view] { return view->findChild<QLabel *>()->text(); };
        QCOMPARE(grids().size(), 3);
        QCOMPARE(product(), QStringLiteral("= Z · S · T, to the last digit"));
        QCOMPARE(value(grids()[1], 0, 0), 0.1);
        QCOMPARE(value(grids()[2], 2, 2), -1.0);
        panel.setMatrixView({MatrixLayout::Row, false, Digits::Double});
        QVERIFY(product().startsWith(QStringLiteral("= T · S · Z, ")));
        setProjection(document, Ortho{0, 8, -10, 10, -10, 10});
        QCOMPARE(value(grids()[0], 3, 0), -4.0); // the box's middle, in the row that rows are moved by
        panel.setMatrixView({});
        setProjection(document, Frustum{-1, 3, -2, 2, 2, 10});
        QCOMPARE(grids().size(), 2);
        QVERIFY(product().startsWith(QStringLiteral("= B · N, ")));
        QCOMPARE(value(grids()[0], 2, 3), -5.0); // b
        setProjection(document, Oblique{{-10, 10, -10, 10, 2, 9}, 0.78, 0.78});
        QCOMPARE(grids().size(), 4);
        QVERIFY(product().startsWith(QStringLiteral("= Z · S · T · H, ")));
        QVERIFY(editConventions(document, Api::Direct3d, {QStringLiteral("Conventions")}));
        QCOMPARE(grids().size(), 6);
        panel.setMatrixView({}); // whose vectors are rows
        QVERIFY2(product().startsWith(QStringLiteral("= C · Z · S · T · H · C′, ")), qPrintable(product()));
        glm::dmat4 all(1.0);
        for (const MatrixModel *factor : grids())
            all = factor->matrix() * all;
        QVERIFY(std::abs(all[3][0] - panel.model().matrix(Stage::ProjectionMatrix)->matrix()[3][0]) < kRounding);
        QVERIFY(std::abs(all[2][2] - panel.model().matrix(Stage::ProjectionMatrix)->matrix()[2][2]) < kRounding);
        panel.setDirection(PipelineDirection::Backward);
        QCOMPARE(grids().size(), 0);
        QVERIFY(product().startsWith(QStringLiteral("Forward shows")));
        panel.setDirection(PipelineDirection::Forward);
        QVERIFY(editMatrices(document,
                             MatrixProjection{*clipFromEye(Projection(Frustum{-1, 3, -2, 2, 2, 10})), std::nullopt},
                             std::nullopt, {QStringLiteral("Matrix")}));
        QVERIFY2(product().contains(QStringLiteral("cannot be decomposed")), qPrintable(product()));
    }

    void partsOfTheFactorsActAsTheSlidersSay()
    {
        SceneDocument document;
        openFigures(document);
        setProjection(document, Ortho{-9, 9, -9, 9, 2, 9});
        PipelinePanel panel(document);
        panel.resize(420, 2500);
        panel.show();
        panel.takeApart(PipelineStage::ProjectionMatrix);
        const FactorShares *shares = panel.findChildren<FactorShares *>().back();
        QVERIFY(shares->isVisible());
        QVERIFY(!panel.findChildren<FactorShares *>().front()->isVisible()); // a view takes no volume to the cube
        const auto sliders = [shares] {
            QList<QSlider *> shown;
            for (QSlider *slider : shares->findChildren<QSlider *>()) {
                if (slider->isVisible())
                    shown << slider;
            }
            return shown;
        };
        const auto has = [shares](const QString &text) {
            const QList<QLabel *> labels = shares->findChildren<QLabel *>();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const QLabel *label) { return label->text().contains(text); });
        };
        const auto product = [shares] {
            return qobject_cast<const MatrixModel *>(shares->findChild<NumberGrid *>()->model())->matrix();
        };
        QCOMPARE(sliders().size(), 3);
        QVERIFY(has(QStringLiteral("This is the matrix of glOrtho, to ")));
        QVERIFY(std::abs(product()[3][2] + 11.0 / 7.0) < kRounding);
        QVERIFY(has(QStringLiteral("from −1 to 1 in x, from −1 to 1 in y, from −1 to 1 in z")));
        QCOMPARE(sliders()[0]->accessibleName(), QStringLiteral("Strength of T, percent"));
        const QPointF middle = QRectF(sliders()[0]->rect()).center();
        QWheelEvent past(middle, sliders()[0]->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                         Qt::NoScrollPhase, false);
        sliders()[0]->clearFocus();
        QCoreApplication::sendEvent(sliders()[0], &past);
        QCOMPARE(sliders()[0]->value(), 100);
        // The keys alone suffice.
        sliders()[2]->setFocus();
        QTest::keyClick(sliders()[2], Qt::Key_Home);
        QCOMPARE(product()[2][2], 2.0 / 7.0);
        QVERIFY(has(QStringLiteral("At 100 % of each it is the matrix of glOrtho.")));
        QPushButton *none = nullptr;
        for (QPushButton *button : shares->findChildren<QPushButton *>())
            none = button->text() == QStringLiteral("None") ? button : none;
        QVERIFY(none);
        QTest::keyClick(none, Qt::Key_Space);
        QVERIFY(product() == glm::dmat4(1.0));
        QVERIFY(has(QStringLiteral("from −9 to 9 in x, from −9 to 9 in y, from −9 to −2 in z")));
        QTest::keyClick(sliders()[0], Qt::Key_End);
        QVERIFY(has(QStringLiteral("from −3.5 to 3.5 in z")));
        // They stay while the projection has the same factors.
        setProjection(document, Ortho{-9, 9, -9, 9, 2, 4});
        QVERIFY(has(QStringLiteral("from −1 to 1 in z")));
        QCOMPARE(sliders()[1]->value(), 0);
        setProjection(document, Frustum{-1, 3, -2, 2, 2, 10});
        QCOMPARE(sliders().size(), 2);
        QVERIFY(has(QStringLiteral("This is the matrix of glFrustum, to ")));
        QVERIFY(editConventions(document, Api::Direct3d, {QStringLiteral("Conventions")}));
        QVERIFY(!shares->isVisible()); // whose cube is another
        const auto saysWhy = [&panel] {
            const QList<QLabel *> labels = panel.findChildren<QLabel *>();
            return std::count_if(labels.begin(), labels.end(), [](const QLabel *label) {
                return label->isVisible() && label->text().contains(QStringLiteral("choose OpenGL's conventions"));
            });
        };
        QCOMPARE(saysWhy(), 1);
        panel.setDirection(PipelineDirection::Backward); // where no factors exist
        QCOMPARE(saysWhy(), 0);
        panel.setDirection(PipelineDirection::Forward);
        QCOMPARE(saysWhy(), 1);
        QVERIFY(editConventions(document, Api::OpenGl, {QStringLiteral("Conventions")}));
        QVERIFY(shares->isVisible() && saysWhy() == 0);
    }

    void theVolumeIsDrawnAsItIsCarried()
    {
        FactorDrawing drawing;
        drawing.resize(300, 220);
        const Projection box(Ortho{-1, 1, -1, 1, 1, 3});
        const auto grabbed = [&](const glm::dmat4 &carried) {
            drawing.setVolume(box, carried);
            return drawing.grab().toImage();
        };
        const QImage start = grabbed(glm::dmat4(1.0)), end = grabbed(*clipFromEye(box));
        QVERIFY(start != end);
        QVERIFY(drawing.extent().least == glm::dvec3(-1) && drawing.extent().most == glm::dvec3(1));
        // Nothing is drawn at the edges: all of it, letters included, is inside.
        for (const QImage &image : {start, end, grabbed(glm::scale(glm::dmat4(1.0), glm::dvec3(1e6, 1, 1e-6)))}) {
            const QColor base = image.pixelColor(0, 0);
            for (int x = 0; x < image.width(); ++x)
                QVERIFY(image.pixelColor(x, 0) == base && image.pixelColor(x, image.height() - 1) == base);
            for (int y = 0; y < image.height(); ++y)
                QVERIFY(image.pixelColor(0, y) == base && image.pixelColor(image.width() - 1, y) == base);
        }
    }

    void itsLettersCoverNoSmallCube()
    {
        FactorDrawing drawing;
        drawing.resize(386, 13 * drawing.fontMetrics().height());
        for (const double size : {5.0, 9.0, 20.0, 200.0}) {
            for (const Projection &box : {Projection(Ortho{-size, size, -size, size, 2, size}),
                                          Projection(Ortho{-size, size, -size, size, -1, size}),
                                          Projection(Ortho{-size, 1.2 * size, -size, size, -size, size})}) {
                drawing.setVolume(box, glm::dmat4(1.0));
                const std::array<QRectF, 6> letters = drawing.letterBoxes();
                for (std::size_t i = 0; i < letters.size(); ++i) {
                    QVERIFY2(!letters[i].intersects(drawing.cubeBox()), qPrintable(QString::number(size)));
                    QVERIFY(QRectF(drawing.rect()).contains(letters[i]));
                    for (std::size_t j = 0; j < i; ++j)
                        QVERIFY(!letters[i].intersects(letters[j]));
                }
            }
        }
    }

    void copyingTakesAllDigits()
    {
        SceneDocument document;
        openFigures(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        setProjection(document, Ortho{-3, 3, -3, 3, -10, 10});
        PipelinePanel panel(document);
        panel.show();
        const MatrixModel *projection = panel.model().matrix(Stage::ProjectionMatrix);
        QVERIFY(projection->copyText(MatrixSyntax::CArray)
                    .startsWith(QStringLiteral("const double clipFromEye[16] = {\n    0.3333333333333333, 0.0,")));
        QVERIFY(projection->copyText(MatrixSyntax::NumPy).startsWith(QStringLiteral("clipFromEye = np.array(")));
        const QString text = panel.model().text();
        QVERIFY(text.contains(QStringLiteral("window\t(")));
        QVERIFY(text.contains(QStringLiteral("0.3333333333333333")));

        for (NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
            if (grid->model() != projection)
                continue;
            grid->setFocus();
            grid->setCurrentIndex(grid->model()->index(0, 0));
            QCOMPARE(grid->selectedText(), QStringLiteral("0.3333333333333333"));
            grid->selectAll();
            QCOMPARE(grid->selectedText().count(u'\n'), 3);
            QTest::keySequence(grid, QKeySequence::Copy);
            QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("0.3333333333333333\t0\t0\t0\n")));
        }
    }

    void theWheelOverAMatrixIsLeftToThePanel()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        panel.resize(420, 400);
        panel.show();
        QWidget *target = panel.findChildren<MatrixSection *>().front()->findChild<NumberGrid *>()->viewport();
        QWheelEvent wheel(QPointF(5, 5), target->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(target, &wheel);
        QVERIFY(!wheel.isAccepted()); // Qt then asks the parents, up to the scroll area
    }

    void everyControlHasAName()
    {
        SceneDocument document;
        PipelinePanel panel(document);
        for (const QToolButton *button : panel.findChildren<QToolButton *>()) {
            if (!button->objectName().startsWith(QStringLiteral("qt_"))) {
                QVERIFY(!button->accessibleName().isEmpty());
                QVERIFY(!button->toolTip().isEmpty());
            }
        }
        for (const NumberGrid *grid : panel.findChildren<NumberGrid *>())
            QVERIFY(!grid->accessibleName().isEmpty());
        QVERIFY(!panel.findChild<QComboBox *>()->accessibleName().isEmpty());
    }

    void itFitsADockOf420Pixels()
    {
        SceneDocument document;
        PipelinePanel panel(document);
        QVERIFY2(panel.minimumSizeHint().width() <= 420, qPrintable(QString::number(panel.minimumSizeHint().width())));
        panel.setDirection(PipelineDirection::Backward);
        panel.setMatrixView({MatrixLayout::Row, true, Digits::Float});
        QVERIFY(panel.minimumSizeHint().width() <= 420);
        QVERIFY(panel.minimumSizeHint().height() <= 600);
    }

    void theConventionsAreChosenUndoably()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        panel.show();
        const auto action = [&panel](Api api) {
            return panel.findChild<QAction *>(QStringLiteral("conventions_") + QLatin1String(conventionsOf(api).key));
        };
        const auto choose = [&action](Api api) { action(api)->trigger(); };
        choose(Api::OpenCascade);
        QVERIFY(document.scene().conventions == Api::OpenCascade);
        QVERIFY(action(Api::OpenCascade)->isChecked());
        QVERIFY(panel.matrixView().layout == MatrixLayout::Row);
        QVERIFY(document.isModified());
        document.undoStack().undo();
        QVERIFY(document.scene().conventions == Api::OpenGl);
        QVERIFY(action(Api::OpenGl)->isChecked());
        QVERIFY(panel.matrixView().layout == MatrixLayout::Column);
    }

    void theConventionsBringTheirLayoutOnce()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        panel.show();
        QVERIFY(editConventions(document, Api::Direct3d, {QStringLiteral("Conventions")}));
        QVERIFY(panel.matrixView().layout == MatrixLayout::Row);
        // A choice after they changed stays, also if the panel was hidden during the change.
        panel.hide();
        QVERIFY(editConventions(document, Api::OpenGl, {QStringLiteral("Conventions")}));
        panel.setMatrixView({MatrixLayout::Row, true});
        panel.show();
        QVERIFY(panel.findChild<QAction *>(QStringLiteral("conventions_opengl"))->isChecked());
        QVERIFY(panel.matrixView() == (MatrixView{MatrixLayout::Row, true}));
    }

    void aHiddenPanelTakesTheirLayoutToo()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        QVERIFY(editConventions(document, Api::Direct3d, {QStringLiteral("Conventions")}));
        QVERIFY(panel.matrixView().layout == MatrixLayout::Row);
        const PipelinePanel later(document); // of a document that has them already
        QVERIFY(later.matrixView().layout == MatrixLayout::Row);
        panel.setMatrixView({});
        QVERIFY(editGivenPoint(document, GivenPoint{ObjectPoint(1, 2, 3), {}}, {QStringLiteral("Point")}));
        panel.show();
        QVERIFY(panel.findChild<QAction *>(QStringLiteral("conventions_direct3d"))->isChecked());
        QVERIFY(panel.matrixView() == MatrixView());
    }
};

UNPROJECTOR_TEST(TestPipelineWidgets)
#include "test_pipeline_widgets.moc"
