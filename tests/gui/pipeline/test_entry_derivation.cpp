// The derivation of a coordinate in the pipeline panel, written out with its numbers.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/pipeline/pipeline_figures.h"

#include "core/base/expression.h"
#include "gui/document/camera_looks.h"
#include "gui/pipeline/entry_derivation.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/steady_label.h"
#include "tests/support/patience.h"

#include <QRegularExpression>

using namespace unprojector;
using namespace unprojector::gui;
using namespace pipelinetest;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;

namespace {

QString derivation(const SceneDocument &document, const PipelineModel &model, Space space, int coordinate)
{
    return entryDerivation(model, document.setup(), space, coordinate).text;
}

/// The value of "0.1 · (-4.2) + 1"; not a number where it is none.
double valueOf(QString terms)
{
    terms.replace(u'·', u'*');
    const auto value = base::evaluate(terms.toStdString());
    return value ? *value : std::nan("");
}

} // namespace

namespace {

/// A panel with a picked point, in sight.
struct ShownPanel {
    SceneDocument document;
    std::unique_ptr<PipelinePanel> panel;

    ShownPanel()
    {
        openFigures(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        panel = std::make_unique<PipelinePanel>(document);
        panel->resize(460, 900);
        panel->show();
    }
    /// Waits for the window to be active: then clicks bring the focus.
    bool becomesActive() const
    {
        panel->activateWindow();
        return QTest::qWaitForWindowActive(panel.get(), kPatienceMilliseconds);
    }
    NumberGrid *gridOf(const QAbstractItemModel *model) const
    {
        for (NumberGrid *grid : panel->findChildren<NumberGrid *>()) {
            if (grid->model() == model)
                return grid;
        }
        return nullptr;
    }
    NumberGrid *gridOf(Space space) const { return gridOf(panel->model().point(space)); }
    NumberGrid *gridOf(Stage stage) const { return gridOf(panel->model().matrix(stage)); }
    const SteadyLabel *label() const { return panel->findChild<SteadyLabel *>(QStringLiteral("derivation")); }
    int topOf(const QWidget *widget) const { return widget->mapTo(panel.get(), QPoint()).y(); }
};

void click(NumberGrid *grid, const QModelIndex &cell)
{
    QTest::mouseClick(grid->viewport(), Qt::LeftButton, {}, grid->visualRect(cell).center());
}

} // namespace

class TestEntryDerivation : public QObject {
    Q_OBJECT

private slots:
    void aRowTimesTheVectorIsWrittenOut()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        QVERIFY(derivation(document, model, Space::Clip, 1).contains(QStringLiteral("no number yet")));
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        model.update();
        const auto shown = [&](Space space, int coordinate) { return derivation(document, model, space, coordinate); };
        QCOMPARE(shown(Space::Clip, 1), QStringLiteral("clip y = row 2 of Projection · eye\n"
                                                       "= 0 · 2.2 + 0.1 · (-4.2) + 0 · (-7) + 0 · 1 = -0.42"));
        QCOMPARE(shown(Space::Ndc, 0), QStringLiteral("NDC x = clip x / clip w\n= 0.22 / 1 = 0.22"));
        QCOMPARE(shown(Space::Window, 0), QStringLiteral("window x = row 1 of Viewport · NDC\n"
                                                         "= 25 · 0.22 + 0 · (-0.42) + 0 · 0.7 + 25 · 1 = 30.5\n"
                                                         "= (NDC x + 1) · w/2 + vx = (0.22 + 1) · 25 + 0"));
        QCOMPARE(shown(Space::Widget, 1), QStringLiteral("widget y = 50 - window y\n= 50 - 14.5 = 35.5"));
        QVERIFY(shown(Space::Object, 0).contains(QStringLiteral("start of the forward path")));
        model.setView({MatrixLayout::Row, true, Digits::Double});
        QCOMPARE(shown(Space::Clip, 1), QStringLiteral("clip y = eye · column 2 of Projection\n"
                                                       "= 2.2 · 0 - 4.2 · 0.1 - 7 · 0 + 1 · 0 = -0.42"));
        model.setDirection(PipelineDirection::Backward);
        QVERIFY(shown(Space::Clip, 3).startsWith(QStringLiteral("w′ = NDC · column 4 of Projection⁻¹\n")));
        QCOMPARE(shown(Space::Eye, 2), QStringLiteral("eye z = z′ / w′\n= -7 / 1 = -7"));
        QVERIFY(shown(Space::Window, 2).contains(QStringLiteral("read at the click")));
    }

    void everyNumberIsWhatItsTermsMake_data()
    {
        addColumn<Api>("api");
        addColumn<MatrixLayout>("layout");
        newRow("OpenGL, columns") << Api::OpenGl << MatrixLayout::Column;
        newRow("OpenGL, rows") << Api::OpenGl << MatrixLayout::Row;
        newRow("Direct3D") << Api::Direct3d << MatrixLayout::Row;
        newRow("three.js") << Api::ThreeJs << MatrixLayout::Column;
        newRow("OpenCV") << Api::OpenCv << MatrixLayout::Column;
    }

    void everyNumberIsWhatItsTermsMake()
    {
        QFETCH(Api, api);
        QFETCH(MatrixLayout, layout);
        SceneDocument document;
        openFigures(document);
        document.setSurface(surfaceFromWidget(50, 40, 1.5));
        setView(document, {WorldPoint(1, 2, 9), WorldPoint(0.3, -0.2, 0), {0.1, 1, 0}},
                Frustum{-1, 2, -1, 1.5, 1.5, 40});
        PipelineModel model(document);
        model.setView({layout, false, Digits::Double, true});
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        model.setApi(api);
        for (const PipelineDirection direction : {PipelineDirection::Forward, PipelineDirection::Backward}) {
            model.setDirection(direction);
            model.update();
            int checked = 0;
            for (int i = 0; i < PointModel::kSpaces; ++i) {
                const PointModel *point = model.point(static_cast<Space>(i));
                for (int which = 0; which < point->rowCount() * point->columnCount(); ++which) {
                    const QString text = derivation(document, model, point->space(), which);
                    const double expected = coordinate(point, which);
                    for (const QString &line : text.split(u'\n').mid(1)) {
                        for (const QString &part : line.mid(2).split(QStringLiteral(" = "))) {
                            if (part.contains(QRegularExpression(QStringLiteral("[v(]x|[hw]/2|df"))))
                                continue; // in symbols, or as words
                            QVERIFY2(std::abs(valueOf(part) - expected) < kRounding * 100, qPrintable(text));
                            ++checked;
                        }
                    }
                }
            }
            QVERIFY(checked >= 40);
        }
    }

    void whatRoundingLeavesIsSaidToBeZero()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        // 3 · 0.1 - 0.3 is 5.55e-17 in double.
        QVERIFY(editTransform(document, 0, {Translate{{-0.3, 0, 0}}, Scale{glm::dvec3(3)}}, {QStringLiteral("Move")}));
        QVERIFY(editGivenPoint(document, GivenPoint{ObjectPoint(0.1, 1, 1), document.objects()[0].name}, {{}}));
        model.update();
        const double x = coordinate(model.point(Space::World), 0);
        QVERIFY2(x != 0.0 && std::abs(x) < 1e-15, qPrintable(QString::number(x)));
        const QString text = derivation(document, model, Space::World, 0);
        QVERIFY2(text.contains(QStringLiteral("= 0: the 5.6e-17 shown is only rounding error")), qPrintable(text));
    }

    void aGivenPointThatTheWayDoesNotMakeIsSaidToDiffer()
    {
        SceneDocument document;
        openFigures(document);
        setProjection(document, Frustum{-1, 1, -1, 1, 1, 10});
        PipelineModel model(document);
        // A clip point and its double have one eye point, which gives only one of them back.
        QVERIFY(editGivenPoint(document, GivenPoint{ClipPoint(1, 1, 1, 4), {}}, {{}}));
        model.update();
        const QString text = derivation(document, model, Space::Clip, 3);
        QVERIFY2(text.contains(QStringLiteral("the number shown, 4, is the input")), qPrintable(text));
    }

    void aClickOrAKeyShowsItAndMarksItsSource()
    {
        SceneDocument document;
        openFigures(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        PipelinePanel panel(document);
        panel.resize(460, 1600);
        panel.show();
        auto *label = panel.findChild<SteadyLabel *>(QStringLiteral("derivation"));
        QVERIFY(label);
        QCOMPARE(label->text(), entryHint());
        const auto shown = [label] { return label->text().replace(QChar::Nbsp, u' '); };
        const auto gridOf = [&panel](const QAbstractItemModel *model) {
            NumberGrid *found = nullptr;
            for (NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
                if (grid->model() == model)
                    found = grid;
            }
            return found;
        };
        const PointModel *clip = panel.model().point(Space::Clip), *eye = panel.model().point(Space::Eye);
        NumberGrid *grid = gridOf(clip);
        QVERIFY(grid);
        QTest::mouseClick(grid->viewport(), Qt::LeftButton, {}, grid->visualRect(clip->indexOf(1)).center());
        QVERIFY2(shown().startsWith(QStringLiteral("clip y = row 2")), qPrintable(shown()));
        const MatrixModel *matrix = panel.model().matrix(Stage::ProjectionMatrix);
        const auto isMarked = [](const QModelIndex &index) {
            return index.data(NumberGridModel::kMarkedRole).toBool();
        };
        for (int i = 0; i < 4; ++i) {
            QVERIFY(isMarked(matrix->indexOf(1, i)));
            QVERIFY(!isMarked(matrix->indexOf(2, i)));
            QVERIFY(isMarked(eye->indexOf(i)));
        }
        QVERIFY(isMarked(clip->indexOf(1)) && !isMarked(clip->indexOf(0)));
        const int height = label->height();
        QTest::keyClick(grid, Qt::Key_Right);
        QVERIFY(shown().startsWith(QStringLiteral("clip z = row 3")));
        QCOMPARE(label->height(), height);
        QVERIFY(isMarked(matrix->indexOf(2, 0)) && !isMarked(matrix->indexOf(1, 0)));
        // It follows the camera and the switches.
        panel.setMatrixView({MatrixLayout::Row, false, Digits::Double});
        QVERIFY(shown().startsWith(QStringLiteral("clip z = eye · column 3")));
        QVERIFY(isMarked(matrix->index(0, 2)) && isMarked(matrix->index(3, 2)));
        setCamera(document, {WorldPoint(0, 0, 8), WorldPoint(0, 0, 0), {0, 1, 0}});
        QVERIFY2(shown().contains(QStringLiteral("(-0.1)")) && shown().contains(QStringLiteral("- 10 ")),
                 qPrintable(shown()));
    }

    void itStandsBelowTheMatrixOfItsStep()
    {
        const ShownPanel shown;
        QVERIFY(shown.becomesActive());
        const PipelineModel &model = shown.panel->model();
        for (const bool areAllOpen : {false, true}) {
            shown.panel->setAllOpen(areAllOpen);
            for (const auto &[space, stage] :
                 {std::pair(Space::World, Stage::ModelMatrix), std::pair(Space::Eye, Stage::ViewMatrix),
                  std::pair(Space::Clip, Stage::ProjectionMatrix), std::pair(Space::Window, Stage::ViewportMatrix)}) {
                click(shown.gridOf(space), model.point(space)->indexOf(0));
                const NumberGrid *matrix = shown.gridOf(stage);
                QVERIFY(matrix->isVisible() && shown.label()->isVisible());
                const auto below = [&shown, matrix] {
                    return shown.topOf(shown.label()) - shown.topOf(matrix) - matrix->height();
                };
                QTRY_VERIFY_WITH_TIMEOUT(below() >= 0 && below() < shown.label()->fontMetrics().height(),
                                         kPatienceMilliseconds);
            }
            for (const Space space : {Space::Ndc, Space::Widget, Space::Object}) { // which no matrix leads to
                click(shown.gridOf(space), model.point(space)->indexOf(0));
                QVERIFY(shown.label()->isVisible());
                QCOMPARE(shown.gridOf(Stage::ProjectionMatrix)->isVisible(), areAllOpen);
            }
            if (areAllOpen) // where the path starts
                QTRY_VERIFY_WITH_TIMEOUT(shown.topOf(shown.label()) < shown.topOf(shown.gridOf(Stage::ModelMatrix)),
                                         kPatienceMilliseconds);
        }
    }

    void aNumberOfAMatrixExplainsItsRow()
    {
        const ShownPanel shown;
        const MatrixModel *matrix = shown.panel->model().matrix(Stage::ProjectionMatrix);
        for (const MatrixView &view :
             {MatrixView{}, MatrixView{MatrixLayout::Row}, MatrixView{MatrixLayout::Column, true}}) {
            shown.panel->setMatrixView(view);
            click(shown.gridOf(Stage::ProjectionMatrix), matrix->indexOf(2, 1));
            QVERIFY2(shown.label()->text().startsWith(QStringLiteral("clip z")), qPrintable(shown.label()->text()));
            QVERIFY(matrix->indexOf(2, 3).data(NumberGridModel::kMarkedRole).toBool());
            click(shown.gridOf(Stage::ProjectionMatrix), matrix->indexOf(0, 0));
            QVERIFY(shown.label()->text().startsWith(QStringLiteral("clip x")));
        }
    }

    void theTabKeyOpensNothing()
    {
        const ShownPanel shown;
        QVERIFY(shown.becomesActive());
        NumberGrid *window = shown.gridOf(Space::Window);
        shown.gridOf(Space::Eye)->setFocus(Qt::TabFocusReason);
        QVERIFY(shown.label()->text().startsWith(QStringLiteral("Click a number")));
        window->setFocus(Qt::TabFocusReason);
        QVERIFY(shown.gridOf(Stage::ProjectionMatrix)->isVisible()
                && !shown.gridOf(Stage::ViewportMatrix)->isVisible());
        // A coordinate whose matrix is open is explained; and an arrow key opens it.
        shown.gridOf(Space::Clip)->setFocus(Qt::TabFocusReason);
        QVERIFY(shown.label()->text().startsWith(QStringLiteral("clip x")));
        window->setFocus(Qt::TabFocusReason);
        QTest::keyClick(window, Qt::Key_Right);
        QVERIFY(shown.gridOf(Stage::ViewportMatrix)->isVisible());
        QVERIFY(shown.label()->text().startsWith(QStringLiteral("window y")));
    }

    void nothingOfItIsCutOff_data()
    {
        addColumn<int>("points");
        addColumn<bool>("isWhole");
        for (const int points : {9, 13}) {
            for (const bool isWhole : {false, true})
                addRow("%d pt, %s", points, isWhole ? "all digits" : "nine digits") << points << isWhole;
        }
    }

    void nothingOfItIsCutOff()
    {
        QFETCH(int, points);
        QFETCH(bool, isWhole);
        SceneDocument document;
        openFigures(document);
        document.setSurface(surfaceFromWidget(1237, 811, 1.0));
        setView(document, {WorldPoint(1, 2, 9), WorldPoint(0.3, -0.2, 0), {0.1, 1, 0}},
                Frustum{-1, 2, -1, 1.5, 1.5, 40});
        pickAt(document, WidgetPoint(40, 600), {0.85, 0, 24});
        PipelinePanel panel(document);
        QFont font = panel.font();
        font.setPointSize(points);
        panel.setFont(font);
        panel.resize(420, 900);
        panel.show();
        panel.setMatrixView({MatrixLayout::Column, false, Digits::Double, isWhole});
        const auto *label = panel.findChild<SteadyLabel *>(QStringLiteral("derivation"));
        for (const PipelineDirection direction : {PipelineDirection::Forward, PipelineDirection::Backward}) {
            panel.setDirection(direction);
            for (NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
                const auto *point = qobject_cast<const PointModel *>(grid->model());
                for (int which = 0; point && which < point->columnCount(); ++which) {
                    grid->setCurrentIndex(point->indexOf(which));
                    const QRect room(0, 0, label->width(), 1 << 16);
                    const int needed = label->fontMetrics()
                                           .boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, label->text())
                                           .height();
                    QVERIFY2(needed <= label->height(), qPrintable(label->text()));
                }
            }
        }
    }
};

UNPROJECTOR_TEST(TestEntryDerivation)
#include "test_entry_derivation.moc"
