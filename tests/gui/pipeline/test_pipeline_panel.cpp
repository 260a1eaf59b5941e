// The pipeline panel: its numbers are read from its models, and compared with the originals' or
// with hand-made ones.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/pipeline/pipeline_figures.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/text/error_text.h"
#include "gui/widgets/number_grid.h"
#include "tests/gui/depth_ranges.h"

#include <QLabel>
#include <QScrollBar>

using namespace unprojector;
using namespace unprojector::gui;
using namespace pipelinetest;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;
using namespace unprojector::scene_file;

class TestPipelinePanel : public QObject {
    Q_OBJECT

private slots:
    void beforeAPickThereAreMatricesAndDashes()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        QVERIFY(isBlank(model));
        QVERIFY(model.status().contains(QStringLiteral("Click the model")));
        QCOMPARE(value(model.matrix(Stage::ProjectionMatrix), 0, 0), 0.1);
        QCOMPARE(value(model.matrix(Stage::ProjectionMatrix), 2, 2), -0.1);
        QCOMPARE(value(model.matrix(Stage::ViewportMatrix), 0, 3), 25.0);
    }

    void theMemoryOrderIsTheTutorialsWatchWindow()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        model.setView({MatrixLayout::Column, true, Digits::Float});
        const MatrixModel *modelview = model.matrix(Stage::ModelviewMatrix);
        QCOMPARE(modelview->rowCount(), 8);
        QCOMPARE(modelview->columnCount(), 2);
        QCOMPARE(modelview->index(6, 1).data(NumberGridModel::kLabelRole).toString(), QStringLiteral("m[14]"));
        QCOMPARE(value(modelview, 6, 1), -8.0);
        QCOMPARE(cell(modelview, 6, 1), QStringLiteral("-8"));

        // fig. 2.12
        setProjection(document, Perspective{std::acos(-1.0) / 4.0, 1, 1, 100});
        model.update();
        const MatrixModel *projection = model.matrix(Stage::ProjectionMatrix);
        QCOMPARE(cell(projection, 0, 0), QStringLiteral("2.4142137"));         // m[0]
        QCOMPARE(cell(projection, 5, 0), QStringLiteral("2.4142137"));         // m[5]
        QCOMPARE(cell(projection, 2, 1), QStringLiteral("-1.020202"));         // m[10]
        QCOMPARE(cell(projection, 3, 1), QStringLiteral("-1"));                // m[11]
        QCOMPARE(cell(projection, 6, 1).left(9), QStringLiteral("-2.020202")); // m[14]
    }

    void aPickIsFollowedThroughEverySpace()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        // Pixel (30, 35) has its centre at window (30.5, 14.5); depth 0.85 is z_eye = -7.
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        model.update();
        QVERIFY(isPoint(model.point(Space::Object), {2.2, -4.2, 1}));
        QVERIFY(isPoint(model.point(Space::World), {2.2, -4.2, -2}));
        QVERIFY(isPoint(model.point(Space::Eye), {2.2, -4.2, -7}));
        QVERIFY(isPoint(model.point(Space::Clip), {0.22, -0.42, 0.7, 1}));
        QVERIFY(isPoint(model.point(Space::Ndc), {0.22, -0.42, 0.7}));
        QVERIFY(isPoint(model.point(Space::Window), {30.5, 14.5, 0.85}));
        QVERIFY(isPoint(model.point(Space::Widget), {30.5, 35.5}));
        QCOMPARE(model.point(Space::Widget)->columnCount(), 2);
        QCOMPARE(cell(model.point(Space::Ndc), 0, 2), QStringLiteral("0.7"));
    }

    void theDepthRangeChangesOnlyTheWindow_data() { depthranges::addRows(); }

    void theDepthRangeChangesOnlyTheWindow()
    {
        SceneDocument document;
        openFigures(document);
        QVERIFY(
            editViewport(document, document.scene().viewport, depthranges::ofThisRow(), {QStringLiteral("Depths")}));
        const auto &[atNear, atFar] = document.setup().depthRange; // OpenGL's, in single precision
        PipelineModel model(document);
        const double depth = atNear + 0.85 * (atFar - atNear);
        pickAt(document, WidgetPoint(30, 35), {depth, 0, 24});
        model.update();
        QVERIFY(std::abs(value(model.matrix(Stage::ViewportMatrix), 2, 3) - (atFar + atNear) / 2.0) < kRounding);
        for (const PipelineDirection direction : {PipelineDirection::Forward, PipelineDirection::Backward}) {
            model.setDirection(direction);
            QVERIFY(isPoint(model.point(Space::World), {2.2, -4.2, -2}));
            QVERIFY(isPoint(model.point(Space::Ndc), {0.22, -0.42, 0.7}));
            QVERIFY(isPoint(model.point(Space::Window), {30.5, 14.5, depth}));
        }
    }

    void backwardStartsFromTheClickedPixelsCentre()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        model.setDirection(PipelineDirection::Backward);
        QCOMPARE(coordinate(model.point(Space::Window), 0), 30.5);
        QCOMPARE(coordinate(model.point(Space::Window), 2), 0.85);
        QVERIFY(isPoint(model.point(Space::World), {2.2, -4.2, -2}));
        QVERIFY(isPoint(model.point(Space::Object), {2.2, -4.2, 1}));
        QCOMPARE(model.matrix(Stage::ViewMatrix)->variableName(), QStringLiteral("worldFromEye"));
        QCOMPARE(value(model.matrix(Stage::ViewMatrix), 2, 3), 5.0);
        QCOMPARE(value(model.matrix(Stage::ModelMatrix), 2, 3), 3.0);
        QVERIFY(model.status().contains(QStringLiteral("clicked pixel")));
    }

    void otherApisHaveTheSamePointInTheirOwnTerms()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        for (const PipelineDirection direction : {PipelineDirection::Forward, PipelineDirection::Backward}) {
            model.setDirection(direction);
            model.setApi(Api::Direct3d);
            model.update();
            QVERIFY(isPoint(model.point(Space::World), {2.2, -4.2, -2}));
            QVERIFY(isPoint(model.point(Space::Eye), {2.2, -4.2, 7}));
            QVERIFY(isPoint(model.point(Space::Ndc), {0.22, -0.42, 0.85}));
            QVERIFY(isPoint(model.point(Space::Window), {30.5, 35.5, 0.85}));
            QVERIFY(isPoint(model.point(Space::Widget), {30.5, 35.5}));
            model.setApi(Api::Unity);
            model.update();
            QVERIFY(isPoint(model.point(Space::World), {2.2, -4.2, 2}));
            QVERIFY(isPoint(model.point(Space::Eye), {2.2, -4.2, -7}));
            QVERIFY(isPoint(model.point(Space::Window), {30.5, 14.5, 0.15}));
            model.setApi(Api::OpenCv);
            model.update();
            QVERIFY(isPoint(model.point(Space::Eye), {2.2, 4.2, 7}));
            QVERIFY(isPoint(model.point(Space::Window), {30, 35, 0.85}));
            QVERIFY(model.apiNote().contains(QStringLiteral("there is no camera matrix K"))); // a box
        }
        model.setDirection(PipelineDirection::Forward);
        model.setApi(Api::Direct3d);
        model.update();
        QCOMPARE(value(model.matrix(Stage::ViewMatrix), 2, 3), 5.0); // the world's origin lies in front
        QVERIFY(std::abs(value(model.matrix(Stage::ProjectionMatrix), 2, 2) - 0.05) < kRounding);
        setProjection(document, Perspective{std::acos(-1.0) / 2.0, 1, 1, 100});
        model.setApi(Api::OpenCv);
        model.update();
        QVERIFY2(model.apiNote().contains(QStringLiteral("K = [25 0 24.5; 0 25 24.5; 0 0 1]")),
                 qPrintable(model.apiNote()));
    }

    void whatIsTypedCountsInTheConventionsShown()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        model.setApi(Api::OpenCv);
        model.update();
        emit model.point(Space::Eye)->typed(0, QStringLiteral("2.2 4.2 7"));
        QVERIFY(document.scene().givenPoint);
        model.update();
        QVERIFY(isPoint(model.point(Space::World), {2.2, -4.2, -2}));
        QVERIFY(isPoint(model.point(Space::Eye), {2.2, 4.2, 7}));
        QVERIFY(std::get<EyePoint>(document.scene().givenPoint->point).z == -7.0);
    }

    void backwardStartsFromThePointOnceTheViewChanged()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        model.setDirection(PipelineDirection::Backward);
        setCamera(document, {WorldPoint(1, 0, 5), WorldPoint(1, 0, 0), {0, 1, 0}});
        model.update();
        // One unit to the side is 2.5 pixels.
        QVERIFY(isPoint(model.point(Space::Window), {28, 14.5, 0.85}));
        QVERIFY(isPoint(model.point(Space::World), {2.2, -4.2, -2}));
        QVERIFY(model.status().contains(QStringLiteral("changed")));

        model.setDirection(PipelineDirection::Forward);
        setCamera(document, {WorldPoint(50, 0, 5), WorldPoint(50, 0, 0), {0, 1, 0}});
        model.update();
        QVERIFY(model.status().contains(QStringLiteral("outside")));
        QVERIFY(isPoint(model.point(Space::Eye), {-47.8, -4.2, -7}));
    }

    void theBackgroundHasNoPoint()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        model.update();
        QVERIFY(!isBlank(model));
        pickAt(document, WidgetPoint(30, 35), {1.0, {}, 24});
        model.update();
        QVERIFY(isBlank(model));
        QVERIFY(model.status().contains(QStringLiteral("Background")));
        QCOMPARE(value(model.matrix(Stage::ViewMatrix), 2, 3), -5.0);
    }

    void pointsAreLinesWithAWInEverySpace()
    {
        SceneDocument document;
        openFigures(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        PipelineModel model(document);
        for (const MatrixLayout layout : {MatrixLayout::Column, MatrixLayout::Row}) {
            model.setView({layout, false, Digits::Double});
            for (int i = 0; i < PointModel::kSpaces; ++i) {
                const PointModel *point = model.point(static_cast<Space>(i));
                const int count = point->space() == Space::Widget ? 2 : 4;
                QCOMPARE(point->rowCount(), 1);
                QCOMPARE(point->columnCount(), count);
                for (int which = 0; which < count; ++which)
                    QCOMPARE(point->indexOf(which).data(NumberGridModel::kLabelRole).toString(),
                             QString(QStringLiteral("xyzw")[which]));
                if (count == 4)
                    QCOMPARE(coordinate(point, 3), 1.0);
            }
        }
        QCOMPARE(model.point(Space::World)->coordinates().size(), std::size_t(3)); // its w is not an independent number
        QCOMPARE(model.point(Space::Clip)->coordinates().size(), std::size_t(4));
        model.setDirection(PipelineDirection::Forward);
        document.picks().clearPick();
        model.update();
        QVERIFY(std::isnan(coordinate(model.point(Space::World), 3)));
    }

    void theWayBackDividesByItsOwnW_data()
    {
        addColumn<Projection>("projection");
        addColumn<double>("depth");
        addColumn<double>("w"); // w' is 1 / z of a perspective, 1 of a box
        // n = 1, f = 10, d = 0.9: z = 10 / (10 x 0.1 + 0.9) = 100 / 19
        newRow("frustum") << Projection(Frustum{-1, 1, -1, 1, 1, 10}) << 0.9 << 0.19;
        newRow("box") << Projection(Ortho{-10, 10, -10, 10, 1, 10}) << 0.5 << 1.0;
    }

    void theWayBackDividesByItsOwnW()
    {
        QFETCH(Projection, projection);
        QFETCH(double, depth);
        QFETCH(double, w);
        SceneDocument document;
        openFigures(document);
        setProjection(document, projection);
        pickAt(document, WidgetPoint(30, 35), {depth, 0, 24});
        PipelinePanel panel(document);
        panel.setDirection(PipelineDirection::Backward);
        panel.show();
        const PointModel *undivided = panel.model().point(Space::Clip), *eye = panel.model().point(Space::Eye);
        QCOMPARE(undivided->name(), QStringLiteral("eye · w′"));
        QCOMPARE(undivided->indexOf(3).data(NumberGridModel::kLabelRole).toString(), QStringLiteral("w′"));
        QVERIFY(std::abs(coordinate(undivided, 3) - w) < kRounding);
        // The inverse of the projection takes the NDC point to this, row by row.
        const MatrixModel *inverse = panel.model().matrix(Stage::ProjectionMatrix);
        const PointModel *ndc = panel.model().point(Space::Ndc);
        for (int row = 0; row < 4; ++row) {
            double sum = 0.0;
            for (int column = 0; column < 4; ++column)
                sum += value(inverse, row, column) * coordinate(ndc, column);
            QVERIFY(std::abs(coordinate(undivided, row) - sum) < kRounding);
            QVERIFY(std::abs(coordinate(eye, row) - sum / coordinate(undivided, 3)) < kRounding);
        }
        // The label below the chain explains it.
        const QLabel *division = nullptr;
        for (const QLabel *label : panel.findChildren<QLabel *>()) {
            if (label->text().contains(QStringLiteral("divide by its own w′")))
                division = label;
        }
        QVERIFY(division);
        const auto top = [&panel](const PointModel *point) {
            for (const NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
                if (grid->model() == point)
                    return grid->mapTo(&panel, QPoint(0, 0)).y();
            }
            return -1;
        };
        QVERIFY(top(ndc) < top(undivided) && top(undivided) < top(eye));
        QVERIFY(!division->isVisible());
        panel.open(Space::Eye);
        QVERIFY(division->isVisible());
    }

    void doublesShowAllTheirDigitsOnDemand()
    {
        SceneDocument document;
        openFigures(document);
        setProjection(document, Ortho{-3, 3, -3, 3, -10, 10});
        PipelinePanel panel(document);
        panel.resize(420, 900);
        panel.show();
        const MatrixModel *projection = panel.model().matrix(Stage::ProjectionMatrix);
        const auto digitsOf = [&](Digits digits, bool isWhole) {
            panel.setMatrixView({MatrixLayout::Column, false, digits, isWhole});
            return cell(projection, 0, 0);
        };
        QCOMPARE(digitsOf(Digits::Double, true), QStringLiteral("0.3333333333333333"));
        QCOMPARE(panel.matrixView().isWhole, true);
        const QString inDouble = digitsOf(Digits::Double, false), inFloat = digitsOf(Digits::Float, false);
        QVERIFY2(inDouble.size() >= inFloat.size(), qPrintable(inDouble + QStringLiteral(" and ") + inFloat));
        QCOMPARE(inDouble.left(9), QStringLiteral("0.3333333"));
        // A narrow panel shows all digits by scrolling.
        panel.setMatrixView({MatrixLayout::Column, false, Digits::Double, true});
        for (NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
            if (grid->model() != projection)
                continue;
            QVERIFY(grid->columnWidth(0) >= 18 * grid->fontMetrics().horizontalAdvance(u'0'));
            QVERIFY(grid->horizontalScrollBar()->maximum() > 0);
        }
    }

    void aFilesMatrixIsShownAsGivenBesideItsConversion()
    {
        // Reversed, z from 0 to 1, near 1 and far 9: z_clip = 0.125 z_eye + 1.125.
        SceneFile file;
        file.windowWidth = 400;
        file.windowHeight = 300;
        MatrixProjection given{glm::dmat4(0.0), NdcDepth::ZeroToOne};
        given.clipFromEye[0][0] = 1.1;
        given.clipFromEye[1][1] = 1.3;
        given.clipFromEye[2] = {0.0, 0.0, 0.125, -1.0};
        given.clipFromEye[3][2] = 1.125;
        file.projection = given;
        file.view = LookAt{};
        const auto scene = sceneFromFile(file, {}, {});
        QVERIFY(scene);
        SceneDocument document;
        document.setSurface(surfaceFromWidget(400, 300, 1.0));
        QVERIFY(document.open(*scene));
        PipelinePanel panel(document);
        panel.resize(460, 2000);
        panel.show();
        const MatrixModel *asGiven = panel.model().given();
        const auto isShown = [&] {
            for (const NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
                if (grid->model() == asGiven)
                    return grid->isVisible();
            }
            return false;
        };
        QVERIFY(isShown());
        QCOMPARE(value(asGiven, 0, 0), 1.1);
        QCOMPARE(value(asGiven, 2, 2), 0.125);
        QCOMPARE(value(asGiven, 2, 3), 1.125);
        QVERIFY(panel.model().givenNote().contains(QStringLiteral("from 0 to 1"))
                && panel.model().givenNote().contains(QStringLiteral("reversed")));
        QVERIFY(asGiven->copyText(MatrixSyntax::NumPy).startsWith(QStringLiteral("clipFromEyeAsGiven = ")));
        // Next to it is OpenGL's: -(f+n)/(f-n) and -2fn/(f-n).
        const MatrixModel *converted = panel.model().matrix(Stage::ProjectionMatrix);
        QVERIFY(std::abs(value(converted, 2, 2) + 1.25) < kRounding
                && std::abs(value(converted, 2, 3) + 2.25) < kRounding);
        // Another projection is not the file's.
        setProjection(document, Ortho{-3, 3, -3, 3, -10, 10});
        QVERIFY(!isShown());
        QVERIFY(panel.model().givenNote().isEmpty());
        document.undoStack().undo();
        QVERIFY(isShown());
    }

    void rowsAreColumnsTransposed()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        const MatrixModel *view = model.matrix(Stage::ViewMatrix);
        QCOMPARE(value(view, 2, 3), -5.0);
        model.setView({MatrixLayout::Row, false, Digits::Double});
        QCOMPARE(value(view, 3, 2), -5.0);
        QCOMPARE(value(view, 2, 3), 0.0);
        QVERIFY(view->copyText(MatrixSyntax::Text).endsWith(QStringLiteral("0  0  -5  1\n")));

        PipelinePanel panel(document);
        const auto showsProduct = [&](const QString &text) {
            for (const QLabel *label : panel.findChildren<QLabel *>()) {
                if (label->text() == text)
                    return true;
            }
            return false;
        };
        QVERIFY(showsProduct(QStringLiteral("= Viewport · Projection · View · Model")));
        panel.setMatrixView({MatrixLayout::Row, false, Digits::Double});
        QVERIFY(showsProduct(QStringLiteral("= Model · View · Projection · Viewport")));
        panel.setDirection(PipelineDirection::Backward);
        QVERIFY(showsProduct(QStringLiteral("= Viewport⁻¹ · Projection⁻¹ · View⁻¹ · Model⁻¹")));
    }

    void theObjectIsThePickedOneUntilAnotherIsChosen()
    {
        SceneDocument document;
        openFigures(document);
        PipelineModel model(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        model.update();
        QCOMPARE(*model.shownObject(), std::size_t(0));
        pickAt(document, WidgetPoint(30, 35), {0.85, 1, 24});
        model.update();
        QCOMPARE(*model.shownObject(), std::size_t(1));
        // Window (45.5, 25.5, 0.85) is the world's (8.2, 0.2, -2).
        pickAt(document, WidgetPoint(45, 24), {0.85, 1, 24});
        model.update();
        QCOMPARE(*model.shownObject(), std::size_t(1));
        QVERIFY(isPoint(model.point(Space::Object), {4.1, 0.1, -1}));
        model.setObject(0);
        QVERIFY(isPoint(model.point(Space::Object), {8.2, 0.2, 1}));
        model.setObject(PipelineModel::kNoObject);
        QVERIFY(isPoint(model.point(Space::Object), {8.2, 0.2, -2}));
        QCOMPARE(value(model.matrix(Stage::ModelMatrix), 0, 0), 1.0);

        // The chosen one stays chosen while others come and go, are renamed and change places.
        model.setObject(1);
        QVERIFY(moveObject(document, 1, 0));
        QCOMPARE(renameObject(document, 0, QStringLiteral("another name")), NameFault::None);
        model.update();
        QCOMPARE(model.object(), 0);
        QVERIFY(isPoint(model.point(Space::Object), {4.1, 0.1, -1}));
        QVERIFY(removeObject(document, 0));
        QCOMPARE(model.object(), PipelineModel::kAutomaticObject);
        model.setObject(PipelineModel::kNoObject);

        // A scene without objects has only the world.
        openObjects(document, {});
        model.update();
        QVERIFY(!model.shownObject());
        QCOMPARE(model.object(), PipelineModel::kAutomaticObject);
        QCOMPARE(value(model.matrix(Stage::ModelMatrix), 2, 3), 0.0);
    }

    void undoAndRedoTakeTheNumbersAlong()
    {
        SceneDocument document;
        openFigures(document);
        pickAt(document, WidgetPoint(30, 35), {0.85, 0, 24});
        PipelinePanel panel(document);
        panel.show();
        const PipelineModel &model = panel.model();
        QVERIFY(editTransform(document, 0, {Translate{{0, 0, -6}}}, {QStringLiteral("Move")}));
        QCOMPARE(value(model.matrix(Stage::ModelMatrix), 2, 3), -6.0);
        QVERIFY(isPoint(model.point(Space::Object), {2.2, -4.2, 4}));
        document.undoStack().undo();
        QCOMPARE(value(model.matrix(Stage::ModelMatrix), 2, 3), -3.0);
        QVERIFY(isPoint(model.point(Space::Object), {2.2, -4.2, 1}));
        document.undoStack().redo();
        QVERIFY(isPoint(model.point(Space::Object), {2.2, -4.2, 4}));
    }

    void aRefusedChangeLeavesTheNumbers()
    {
        SceneDocument document;
        openFigures(document);
        PipelinePanel panel(document);
        panel.show();
        QVERIFY(!editProjection(document, {Ortho{1, 1, -10, 10, -10, 10}, false, false}, {QStringLiteral("Left")}));
        QCOMPARE(value(panel.model().matrix(Stage::ProjectionMatrix), 0, 0), 0.1);

        // Each step is valid, but the product is too small for its inverse to be a number.
        const Check refused = editTransform(document, 0, {Scale{glm::dvec3(1e-200)}}, {QStringLiteral("Scale")});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::ObjectTooSmall);
        QVERIFY2(errorText(refused.error()).contains(QStringLiteral("less than can be computed")),
                 qPrintable(errorText(refused.error())));
        QCOMPARE(value(panel.model().matrix(Stage::ProjectionMatrix), 0, 0), 0.1);
        QVERIFY(!panel.model().status().contains(QStringLiteral("no inverse")));
    }

    void aPointInThePlaneOfTheEyeHasNoWindowPosition()
    {
        SceneDocument document;
        openFigures(document);
        pickAt(document, WidgetPoint(30, 35), {0.75, 0, 24}); // on z = 0
        setView(document, {WorldPoint(1, 2, 0), WorldPoint(1, 2, -5), {0, 1, 0}}, Frustum{-1, 1, -1, 1, 1, 10});
        PipelineModel model(document);
        QCOMPARE(coordinate(model.point(Space::Clip), 3), 0.0);
        QCOMPARE(model.point(Space::Ndc)->fullText(), QStringLiteral("–"));
        QCOMPARE(model.point(Space::Widget)->fullText(), QStringLiteral("–"));
        QVERIFY(model.status().contains(QStringLiteral("infinity")));
    }
};

UNPROJECTOR_TEST(TestPipelinePanel)
#include "test_pipeline_panel.moc"
