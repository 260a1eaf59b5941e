// The panel's display of a pick: the numbers, their certain digits, and the copied texts. No window
// of OpenGL is needed.

#include "tests/support/test.h"

#include "gui/click/answer_view.h"
#include "gui/click/api_clicks_view.h"
#include "gui/click/comparison_model.h"
#include "gui/click/comparison_panel.h"
#include "gui/click/coordinates_table.h"
#include "gui/text/formula_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/figure_view.h"
#include "gui/widgets/formula_view.h"
#include "gui/widgets/whole_table.h"

#include "tests/gui/comparison_picks.h"
#include "tests/gui/depth_ranges.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QToolButton>

#include <cmath>

using namespace comparing;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

class TestComparisonPanel : public QObject {
    Q_OBJECT

private slots:
    void theClickStandsInTheTermsOfEveryApi()
    {
        ApiClicksView view;
        const auto cell = [&view](Api api, int column) {
            return view.table().item(static_cast<int>(api), column)->text();
        };
        QCOMPARE(cell(Api::Vulkan, 0), QStringLiteral("–"));
        QVERIFY(view.text().isEmpty());
        view.setPick(picked(frustumGeometry(), 500.0, 200.0, 0.5));
        QCOMPARE(cell(Api::OpenGl, 0), QStringLiteral("(500.5, 399.5)"));
        QCOMPARE(cell(Api::Vulkan, 0), QStringLiteral("(500.5, 200.5)"));
        QCOMPARE(cell(Api::OpenCv, 0), QStringLiteral("(500, 200)"));
        QCOMPARE(cell(Api::Unity, 1), QStringLiteral("0.5"));
        QVERIFY(cell(Api::OpenCv, 1).startsWith(QStringLiteral("3.33")));
        QCOMPARE(view.text().count(u'\n'), qsizetype(kApis.size()));
        for (const Api api : kApis)
            QVERIFY(!view.table().verticalHeaderItem(static_cast<int>(api))->toolTip().isEmpty());
        view.setPick(picked(frustumGeometry(), 500.0, 200.0, 0.5, false)); // background
        QCOMPARE(cell(Api::Vulkan, 3), QStringLiteral("–"));
    }

    void theTableHoldsThePicksDoubles()
    {
        ComparisonModel model;
        QCOMPARE(model.rowCount(), 0);
        const Pick pick = picked(frustumGeometry(), 612.0, 99.0, 0.9);
        model.setPick(kept(pick));
        const auto check = [&model](ComparisonModel::Space space, const auto &point) {
            model.setSpace(space);
            QCOMPARE(model.rowCount(), 3);
            for (int axis = 0; axis < 3; ++axis) {
                const int row = axis;
                const auto value = [&](int column) {
                    return cell(model, row, column, ComparisonModel::kValueRole).toDouble();
                };
                const double formula = point[Method::Formula]->coordinates()[axis],
                             matrix = point[Method::Matrix]->coordinates()[axis];
                const double inFloat = point[Method::MatrixInFloat]->coordinates()[axis];
                // QCOMPARE on doubles is fuzzy: these are to be the same.
                QVERIFY(value(ComparisonModel::Formula) == formula);
                QVERIFY(value(ComparisonModel::Matrix) == matrix);
                QVERIFY(value(ComparisonModel::MatrixInFloat) == inFloat);
                QVERIFY(value(ComparisonModel::Difference) == formula - matrix);
                QVERIFY(value(ComparisonModel::FloatDifference) == formula - inFloat);
                QCOMPARE(model.headerData(row, Qt::Vertical).toString(), QString(QChar(u'x' + axis)));
            }
        };
        check(ComparisonModel::Space::World, pick.point.world);
        check(ComparisonModel::Space::Eye, pick.point.eye);
    }

    void theTableHasThePointInTheObjectsSpace()
    {
        const Pick pick = picked(frustumGeometry(), 612.0, 99.0, 0.9);
        KeptPick moved = kept(pick);
        moved.placement = worldFromObject({Translate{{0.0, 0.0, 3.0}}, Scale{{2.0, 2.0, 4.0}}});
        ComparisonModel model;
        model.setSpace(ComparisonModel::Space::Object);
        model.setPick(moved);
        const auto value = [&](int row, int column) {
            return cell(model, row, column, ComparisonModel::kValueRole).toDouble();
        };
        const std::pair<Method, int> columns[] = {{Method::Formula, ComparisonModel::Formula},
                                                  {Method::Matrix, ComparisonModel::Matrix}};
        for (const auto &[method, column] : columns) {
            const WorldPoint world = pick.point.world[method].value();
            QCOMPARE(value(0, column), world.x / 2.0);
            QCOMPARE(value(1, column), world.y / 2.0);
            QCOMPARE(value(2, column), (world.z - 3.0) / 4.0);
        }
        for (int row = 0; row < 3; ++row)
            QVERIFY(value(row, ComparisonModel::Difference)
                    == value(row, ComparisonModel::Formula) - value(row, ComparisonModel::Matrix));
        QCOMPARE(model.pointNameAt(model.index(0, ComparisonModel::Formula)), QStringLiteral("object"));
    }

    void theTableOfABackgroundHoldsTheRay()
    {
        ComparisonModel model;
        const Pick pick = picked(frustumGeometry(), 0.0, 0.0, 1.0, false);
        model.setPick(kept(pick));
        QCOMPARE(model.rowCount(), 6);
        QCOMPARE(model.headerData(0, Qt::Vertical).toString(), QStringLiteral("Near x"));
        QCOMPARE(model.headerData(5, Qt::Vertical).toString(), QStringLiteral("Far z"));
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(cell(model, axis, ComparisonModel::Formula, ComparisonModel::kValueRole).toDouble()
                    == pick.rayNear.world[Method::Formula]->coordinates()[axis]);
            QVERIFY(cell(model, 3 + axis, ComparisonModel::Matrix, ComparisonModel::kValueRole).toDouble()
                    == pick.rayFar.world[Method::Matrix]->coordinates()[axis]);
        }
    }

    void differencesAreCountedInUlpsOfTheLargestComponent()
    {
        // The ulp of 4 is 2^-50. x differs by -2^-52, z by 2^-51: -0.25 and 0.5 of it.
        ComparisonModel model;
        model.setPick(kept(pickWith({1.0, 2.0, 4.0}, {1.0 + std::ldexp(1.0, -52), 2.0, 4.0 - std::ldexp(1.0, -51)},
                                    {1.0, 2.0, 4.5}, 0.01)));
        const auto value = [&](int row, int column) {
            return cell(model, row, column, ComparisonModel::kValueRole).toDouble();
        };
        QVERIFY(value(0, ComparisonModel::Difference) == -std::ldexp(1.0, -52));
        QVERIFY(value(0, ComparisonModel::Ulps) == -0.25);
        QVERIFY(value(1, ComparisonModel::Ulps) == 0.0);
        QVERIFY(value(2, ComparisonModel::Difference) == std::ldexp(1.0, -51));
        QVERIFY(value(2, ComparisonModel::Ulps) == 0.5);
        QCOMPARE(cell(model, 0, ComparisonModel::Difference).toString(), QStringLiteral("-2.2e-16"));
        QCOMPARE(cell(model, 0, ComparisonModel::Ulps).toString(), QStringLiteral("-0.3"));
        QCOMPARE(cell(model, 1, ComparisonModel::Difference).toString(), QStringLiteral("0"));
        QCOMPARE(cell(model, 1, ComparisonModel::Ulps).toString(), QStringLiteral("0"));
        QCOMPARE(cell(model, 2, ComparisonModel::Ulps).toString(), QStringLiteral("0.5"));
        QCOMPARE(cell(model, 2, ComparisonModel::FloatDifference).toString(), QStringLiteral("-0.5"));

        // 4096 = 2^12: its ulp is 2^-40. 37 and 3 000 000 of it.
        model.setPick(kept(pickWith({4096.0, 0.0, 1.0},
                                    {4096.0 - 37.0 * std::ldexp(1.0, -40), 0.0, 1.0 + 3e6 * std::ldexp(1.0, -40)},
                                    {0.0, 0.0, 0.0}, 0.01)));
        QCOMPARE(cell(model, 0, ComparisonModel::Ulps).toString(), QStringLiteral("37"));
        QCOMPARE(cell(model, 2, ComparisonModel::Ulps).toString(), QStringLiteral("-3000000"));
    }

    void aMethodWithoutAnswerSaysNone()
    {
        Pick pick = pickWith({1.0, 2.0, 4.0}, {1.0, 2.0, 4.0}, {1.0, 2.0, 4.0}, 0.01);
        pick.point.world = Answers<WorldSpace>::of([&](Method method) -> Result<WorldPoint> {
            if (method == Method::Matrix)
                return Error{ErrorCode::SingularMatrix};
            return WorldPoint(1.0, 2.0, 4.0);
        });
        ComparisonModel model;
        model.setPick(kept(pick));
        QCOMPARE(cell(model, 0, ComparisonModel::Matrix).toString(), QStringLiteral("none"));
        QCOMPARE(cell(model, 0, ComparisonModel::Difference).toString(), QStringLiteral("none"));
        QVERIFY(cell(model, 0, ComparisonModel::Formula, ComparisonModel::kValueRole).toDouble() == 1.0);
        QVERIFY(!cell(model, 0, ComparisonModel::Matrix, ComparisonModel::kValueRole).isValid());
    }

    void theCopiedTableReadsBackToTheSameDoubles()
    {
        for (const bool hit : {true, false}) {
            ComparisonModel model;
            model.setPick(kept(picked(frustumGeometry(), 613.0, 57.0, hit ? 0.987654321 : 1.0, hit)));
            QString text = model.text();
            QVERIFY(text.endsWith(u'\n'));
            text.chop(1);
            const QStringList lines = text.split(u'\n');
            QCOMPARE(lines.size(), 1 + model.rowCount());
            for (int row = 0; row < model.rowCount(); ++row) {
                const QStringList cells = lines[row + 1].split(u'\t');
                QCOMPARE(cells.size(), 1 + model.columnCount());
                QCOMPARE(cells[0], model.headerData(row, Qt::Vertical).toString());
                for (int column = 0; column < ComparisonModel::Ray; ++column) {
                    bool isNumber = false;
                    const double value = cells[column + 1].toDouble(&isNumber);
                    QVERIFY(isNumber);
                    QVERIFY(value == cell(model, row, column, ComparisonModel::kValueRole).toDouble());
                }
            }
        }
    }

    void columnsAreAddedOnRequest()
    {
        PanelOfPicks panel;
        panel.setPick(picked(frustumGeometry(), 412.0, 299.0, 0.75));
        auto *table = panel.findChild<CoordinatesTable *>();
        const auto shown = [table] {
            QList<int> columns;
            for (int column = 0; column < ComparisonModel::ColumnCount; ++column) {
                if (!table->isColumnHidden(column))
                    columns << column;
            }
            return columns;
        };
        const QList<int> methods{ComparisonModel::Formula, ComparisonModel::Matrix, ComparisonModel::Difference,
                                 ComparisonModel::Ulps};
        QCOMPARE(shown(), methods);
        panel.setShowsFloat(true);
        QCOMPARE(shown(), (methods + QList<int>{ComparisonModel::MatrixInFloat, ComparisonModel::FloatDifference}));
        panel.setShowsRay(true);
        QCOMPARE(shown().size(), int(ComparisonModel::ColumnCount));
        // The table fits without a scroll bar, in the width that the panel asks for.
        panel.resize(panel.sizeHint().width(), 700);
        static_cast<void>(panel.grab()); // laid out
        QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
        panel.setShowsFloat(false);
        panel.setShowsRay(false);
        QCOMPARE(shown(), methods);
    }

    /// Before a click there is one sentence and a figure, and no empty table.
    void nothingIsEmptyBeforeAClick()
    {
        PanelOfPicks panel;
        panel.resize(420, 700);
        panel.show();
        QVERIFY(!panel.findChild<CoordinatesTable *>()->isVisible());
        QVERIFY(panel.findChild<FigureView *>()->isVisible());
        panel.setPick(picked(frustumGeometry(), 412.0, 299.0, 0.75));
        QVERIFY(panel.findChild<CoordinatesTable *>()->isVisible());
        QVERIFY(!panel.findChild<FigureView *>()->isVisible());
        panel.setPick(std::nullopt);
        QVERIFY(panel.findChild<FigureView *>()->isVisible());
    }

    /// The formulas have their full height: there is nothing to scroll within them.
    void theFormulaIsWhole()
    {
        PanelOfPicks panel;
        panel.show();
        panel.setPick(picked(frustumGeometry(), 412.0, 299.0, 0.75));
        for (const int width : {panel.minimumWidth(), 500, 900}) {
            for (int pass = 0; pass < 2; ++pass) { // a layout that grows asks the one around it
                QCoreApplication::sendPostedEvents();
                panel.resize(width, panel.heightForWidth(width));
            }
            QCoreApplication::sendPostedEvents();
            const auto *formula = panel.findChild<FormulaView *>();
            QVERIFY(formula->viewport()->height() >= formula->contentSize().height());
        }
    }

    void foldsAreRemembered()
    {
        PanelOfPicks panel;
        QVERIFY(panel.openFolds().isEmpty());
        panel.setOpenFolds({QStringLiteral("ray"), QStringLiteral("apis"), QStringLiteral("gone")});
        QCOMPARE(panel.openFolds(), (QStringList{QStringLiteral("ray"), QStringLiteral("apis")}));
    }

    void theWholePanelIsCopied()
    {
        PanelOfPicks panel;
        QVERIFY(panel.text().isEmpty());
        const Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
        panel.setPick(pick);
        emit panel.findChild<AnswerView *>()->copyAllRequested();
        const QString text = QApplication::clipboard()->text();
        QCOMPARE(text, panel.text());
        QVERIFY(text.contains(panel.model().text()));
        QVERIFY(text.contains(QStringLiteral("Eye\n")) && text.contains(QStringLiteral("Object\n")));
        QVERIFY(text.contains(formulasOf(pick).text()));
        QVERIFY(text.contains(QStringLiteral("Window position\t(412.5, 300.5)")));
        QVERIFY(!hasPlaceholder(text));
    }

    /// "Copy" copies the coordinate with all its digits; its menu has the certain ones.
    void theCoordinateIsCopied()
    {
        PanelOfPicks panel;
        panel.setPick(pickWith({0.1 + 0.2, 2.0, -4.0}, {0.3, 2.0, -4.0}, {0.3, 2.0, -4.0}, 0.004));
        auto *copy = panel.findChild<AnswerView *>()->findChild<QToolButton *>();
        copy->click();
        QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("0.30000000000000004, 2, -4"));
        emit copy->menu()->aboutToShow();
        copy->menu()->actions().front()->trigger();
        QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("0.30, 2.00, -4.00"));
    }

    void selectedCellsAreCopiedWithAllDigits()
    {
        PanelOfPicks panel;
        const Pick pick = picked(frustumGeometry(), 612.0, 99.0, 0.9);
        panel.setPick(pick);
        auto *table = panel.findChild<CoordinatesTable *>();
        table->selectionModel()->select(QItemSelection(table->model()->index(0, ComparisonModel::Formula),
                                                       table->model()->index(1, ComparisonModel::Matrix)),
                                        QItemSelectionModel::Select);
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        const auto &world = pick.point.world;
        QCOMPARE(QApplication::clipboard()->text(),
                 QStringLiteral("%1\t%2\n%3\t%4")
                     .arg(shortestText(world[Method::Formula]->x), shortestText(world[Method::Matrix]->x),
                          shortestText(world[Method::Formula]->y), shortestText(world[Method::Matrix]->y)));
    }

    void theChainIsWrittenOut()
    {
        Setup setup = frustumGeometry();
        setup.surface = {800, 600, 1.5};
        PanelOfPicks panel;
        panel.setPick(picked(setup, 275.2, 200.0, 0.75)); // device 412.8, 300
        QCOMPARE(panel.findChild<AnswerView *>()->heading(), QStringLiteral("the surface"));
        QCOMPARE(labelNamed(panel, "Widget position")->text(), QStringLiteral("(275.2, 200) logical pixels"));
        QCOMPARE(labelNamed(panel, "Device pixel")->text(), QStringLiteral("(412, 300) of 800 × 600, ratio 1.5"));
        QCOMPARE(labelNamed(panel, "Window position")->text(), QStringLiteral("(412.5, 299.5), the pixel's centre"));
        QCOMPARE(labelNamed(panel, "Depth")->text(), QStringLiteral("0.75, as read"));
        panel.setPick(picked(setup, 275.2, 200.0, 1.0, false));
        QCOMPARE(panel.findChild<AnswerView *>()->heading(), QStringLiteral("Background: no surface here"));
        QVERIFY(panel.findChild<AnswerView *>()->text().isEmpty());
        QCOMPARE(labelNamed(panel, "Depth")->text(), QStringLiteral("1, the far plane: no surface"));
        panel.setPick(std::nullopt);
        QVERIFY(panel.findChild<FormulaView *>()->formulas().text().isEmpty());
    }

    void theShownDepthTellsThePoint_data()
    {
        addColumn<double>("distance");
        addColumn<DepthRange>("range");
        for (const double distance : {0.0015, 0.1, 2.966360, 150.0, 8000.0}) {
            addRow("%g", distance) << distance << DepthRange{0.0, 1.0};
            addRow("%g, reversed", distance) << distance << DepthRange{1.0, 0.0};
            addRow("%g, behind nines", distance) << distance << DepthRange{0.9, 1.0};
        }
    }

    /// Near is 0.001, far 100000: nearly all depths begin with many nines. The chain, the formula and
    /// the values for other programs show a depth that gives the point. The point has the table's
    /// certain digits and two more.
    void theShownDepthTellsThePoint()
    {
        QFETCH(double, distance);
        QFETCH(DepthRange, range);
        const double n = 0.001, f = 100000.0;
        Setup setup = frustumGeometry();
        setup.depthRange = range;
        setup.lens = Projection(Frustum{-n / 2.0, n / 2.0, -n * 0.375, n * 0.375, n, f});
        const double share = (1.0 / n - 1.0 / distance) / (1.0 / n - 1.0 / f);
        constexpr double kSteps = 16777215.0; // of 24 bits
        const double depth = std::round((range.atNear + share * (range.atFar - range.atNear)) * kSteps) / kSteps;
        const Pick pick = picked(setup, 700.0, 100.0, depth);
        PanelOfPicks panel;
        panel.setPick(pick);
        const Unprojector unprojector = Unprojector::of(setup).value();
        const auto tellsThePoint = [&](double shown) {
            const Result<WorldPoint> point =
                unprojector.worldAt(Method::Formula, WindowPoint(pick.window.x, pick.window.y, shown));
            if (!point)
                return false;
            constexpr double kShare = 0.01;
            for (int axis = 0; axis < 3; ++axis) {
                const double off = std::abs((*point)[axis] - (*pick.point.world[Method::Formula])[axis]);
                if (!(off <= kShare * pick.uncertainty.world[axis]))
                    return false;
            }
            return true;
        };
        const QString chain = labelNamed(panel, "Depth")->text().section(u',', 0, 0);
        QVERIFY2(tellsThePoint(chain.toDouble()), qPrintable(chain));
        // A copy has all its digits.
        const QString copied = panel.text().section(QStringLiteral("Depth\t"), 1).section(u',', 0, 0);
        QCOMPARE(copied.toDouble(), pick.window.z);
        const FormulaTerms terms = formulasOf(pick).terms;
        const double unit = terms.at(QStringLiteral("d")).value.front().toDouble();
        QVERIFY(tellsThePoint(range.atNear + unit * (range.atFar - range.atNear)));
        ApiClicksView view;
        view.setPick(pick);
        const QString asOpenGl = view.table().item(0, 1)->text();
        QCOMPARE(asOpenGl, chain);
    }

    void theDepthRangeChangesOnlyTheDepth_data() { depthranges::addRows(); }

    void theDepthRangeChangesOnlyTheDepth()
    {
        const DepthRange range = depthranges::ofThisRow();
        Setup setup = frustumGeometry();
        setup.depthRange = range;
        // Expected by hand: the middle depth is the distance 2 n f / (n + f) = 10/3. The pixel centre
        // is (412.5, 300.5) of 800 x 600.
        const double distance = 10.0 / 3.0;
        const glm::dvec3 eye((412.5 / 400.0 - 1.0) * 0.8284271247461901 / 2.0 * distance,
                             (300.5 / 300.0 - 1.0) * 0.6213203435596426 / 2.0 * distance, -distance);
        PanelOfPicks panel;
        panel.setPick(picked(setup, 412.0, 299.0, (range.atNear + range.atFar) / 2.0));
        QCOMPARE(labelNamed(panel, "Depth")->text(),
                 shortestText((range.atNear + range.atFar) / 2.0) + QStringLiteral(", as read"));
        ComparisonModel inEye;
        inEye.setSpace(ComparisonModel::Space::Eye);
        inEye.setPick(panel.document.picks().keptPick());
        for (int axis = 0; axis < 3; ++axis) {
            for (const int column : {int(ComparisonModel::Formula), int(ComparisonModel::Matrix)}) {
                const double value = cell(inEye, axis, column, ComparisonModel::kValueRole).toDouble();
                QVERIFY2(std::abs(value - eye[axis]) < 1e-14, qPrintable(QString::number(value, 'g', 17)));
            }
        }
        // The formulas begin with the depth in [0, 1].
        const QString formulas = panel.findChild<FormulaView *>()->formulas().text();
        QVERIFY2(formulas.contains(QStringLiteral("(1 − 0.5)")) && formulas.contains(QStringLiteral("3.33333")),
                 qPrintable(formulas));
        // The ray of the background goes from the near plane's depth to the far plane's.
        panel.setPick(picked(setup, 412.0, 299.0, range.atFar, false));
        QCOMPARE(labelNamed(panel, "Depth")->text(),
                 shortestText(range.atFar) + QStringLiteral(", the far plane: no surface"));
        const auto worldZ = [&](int row) {
            return cell(panel.model(), row, ComparisonModel::Formula, ComparisonModel::kValueRole).toDouble();
        };
        QCOMPARE(worldZ(2), 3.0);
        QCOMPARE(worldZ(5), -5.0);
    }

    void thePanelStandsStillFromClickToClick()
    {
        PanelOfPicks panel;
        panel.setShowsFloat(true);
        panel.setOpenFolds({QStringLiteral("pixel"), QStringLiteral("ray")});
        panel.resize(460, 900);
        panel.show();
        const auto places = [&panel] {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
            QStringList list;
            for (const QWidget *child : panel.findChildren<QWidget *>()) {
                if (!child->isVisible() || child->accessibleName().isEmpty())
                    continue;
                const QPoint at = child->mapTo(&panel, QPoint());
                list << QStringLiteral("%1: %2,%3 %4")
                            .arg(child->accessibleName())
                            .arg(at.x())
                            .arg(at.y())
                            .arg(child->height());
            }
            return list;
        };
        panel.setPick(picked(frustumGeometry(), 412.0, 299.0, 0.75));
        const QStringList before = places();
        QVERIFY(before.size() > 8);
        for (const double x : {3.0, 210.0, 588.0}) {
            panel.setPick(picked(frustumGeometry(), x, 2.0, 0.8));
            QCOMPARE(places(), before);
        }
    }
};

UNPROJECTOR_TEST(TestComparisonPanel)
#include "test_comparison_panel.moc"
