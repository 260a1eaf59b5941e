// What the panel shows of a pick: the numbers, which of their digits are certain, and what is copied. No window of OpenGL
// is needed.

#include "gui/click/api_clicks_view.h"
#include "gui/click/comparison_model.h"
#include "gui/click/comparison_panel.h"
#include "gui/text/formula_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/formula_view.h"

#include "comparison_picks.h"
#include "depth_ranges.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTest>

#include <cmath>

using namespace comparing;
using namespace unprojector::gui;

namespace {

QLabel *labelNamed(const QWidget &panel, const char *name)
{
    for (QLabel *label : panel.findChildren<QLabel *>()) {
        if (label->accessibleName() == QLatin1String(name))
            return label;
    }
    return nullptr;
}

QPushButton *buttonNamed(const QWidget &panel, const char *text)
{
    for (QPushButton *button : panel.findChildren<QPushButton *>()) {
        if (button->text() == QLatin1String(text))
            return button;
    }
    return nullptr;
}

} // namespace

class TestComparisonPanel : public QObject {
    Q_OBJECT

private slots:
    void theClickStandsInTheTermsOfEveryApi();
    void theTableHoldsThePicksDoubles();
    void theTableOfABackgroundHoldsTheRay();
    void differencesAreCountedInUlpsOfTheLargestComponent();
    void aMethodWithoutAnswerSaysNone();
    void theCopiedTableReadsBackToTheSameDoubles();
    void theFloatColumnsAreShownOnRequest();
    void theWholePanelIsCopied();
    void selectedCellsAreCopiedWithAllDigits();
    void theChainIsWrittenOut();
    void theShownDepthTellsThePoint_data();
    void theShownDepthTellsThePoint();
    void theDepthRangeChangesOnlyTheDepth_data() { depthranges::addRows(); }
    void theDepthRangeChangesOnlyTheDepth();
    void thePanelStandsStillOnceItHasGrown_data();
    void thePanelStandsStillOnceItHasGrown();
};

void TestComparisonPanel::theClickStandsInTheTermsOfEveryApi()
{
    ApiClicksView view;
    view.setOpen(true);
    const auto cell = [&view](Api api, int column) { return view.table().item(static_cast<int>(api), column)->text(); };
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

void TestComparisonPanel::theTableHoldsThePicksDoubles()
{
    ComparisonModel model;
    QCOMPARE(model.rowCount(), 6);
    for (int row = 0; row < 6; ++row)
        QVERIFY(!cell(model, row, ComparisonModel::Formula, ComparisonModel::kValueRole).isValid());

    const Pick pick = picked(frustumGeometry(), 612.0, 99.0, 0.9);
    model.setPick(pick);
    QCOMPARE(model.rowCount(), 6);
    const auto check = [&model](int firstRow, const char *space, const auto &point) {
        for (int axis = 0; axis < 3; ++axis) {
            const int row = firstRow + axis;
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
            QCOMPARE(model.headerData(row, Qt::Vertical).toString(),
                     QStringLiteral("%1 %2").arg(QLatin1String(space)).arg(QChar(u'x' + axis)));
        }
    };
    check(0, "World", pick.point.world);
    check(3, "Eye", pick.point.eye);
}

void TestComparisonPanel::theTableOfABackgroundHoldsTheRay()
{
    ComparisonModel model;
    const Pick pick = picked(frustumGeometry(), 0.0, 0.0, 1.0, false);
    model.setPick(pick);
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

void TestComparisonPanel::differencesAreCountedInUlpsOfTheLargestComponent()
{
    // The ulp of 4 is 2^-50. x differs by -2^-52, z by 2^-51: -0.25 and 0.5 of it.
    ComparisonModel model;
    model.setPick(pickWith({1.0, 2.0, 4.0}, {1.0 + std::ldexp(1.0, -52), 2.0, 4.0 - std::ldexp(1.0, -51)},
                           {1.0, 2.0, 4.5}, 0.01));
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
    model.setPick(pickWith({4096.0, 0.0, 1.0},
                           {4096.0 - 37.0 * std::ldexp(1.0, -40), 0.0, 1.0 + 3e6 * std::ldexp(1.0, -40)},
                           {0.0, 0.0, 0.0}, 0.01));
    QCOMPARE(cell(model, 0, ComparisonModel::Ulps).toString(), QStringLiteral("37"));
    QCOMPARE(cell(model, 2, ComparisonModel::Ulps).toString(), QStringLiteral("-3e+06"));

    // Whatever they are, the column has room for them and their sign.
    for (const double ulps : {99999.0, 99999.6, 123456.0, 60774999.0, 9.4e15}) {
        model.setPick(
            pickWith({4096.0, 0.0, 1.0}, {4096.0 + ulps * std::ldexp(1.0, -40), 0.0, 1.0}, {0.0, 0.0, 0.0}, 0.01));
        const QString text = cell(model, 0, ComparisonModel::Ulps).toString();
        QVERIFY2(text.startsWith(u'-') && text.size() <= 6, qPrintable(text));
        QVERIFY2(std::abs(text.toDouble() + ulps) <= 0.5 * ulps, qPrintable(text));
    }
}

void TestComparisonPanel::aMethodWithoutAnswerSaysNone()
{
    Pick pick = pickWith({1.0, 2.0, 4.0}, {1.0, 2.0, 4.0}, {1.0, 2.0, 4.0}, 0.01);
    pick.point.world = Answers<WorldSpace>::of([&](Method method) -> Result<WorldPoint> {
        if (method == Method::Matrix)
            return Error{ErrorCode::SingularMatrix};
        return WorldPoint(1.0, 2.0, 4.0);
    });
    ComparisonModel model;
    model.setPick(pick);
    QCOMPARE(cell(model, 0, ComparisonModel::Matrix).toString(), QStringLiteral("none"));
    QCOMPARE(cell(model, 0, ComparisonModel::Difference).toString(), QStringLiteral("none"));
    QVERIFY(cell(model, 0, ComparisonModel::Formula, ComparisonModel::kValueRole).toDouble() == 1.0);
    QVERIFY(!cell(model, 0, ComparisonModel::Matrix, ComparisonModel::kValueRole).isValid());
}

void TestComparisonPanel::theCopiedTableReadsBackToTheSameDoubles()
{
    for (const bool hit : {true, false}) {
        ComparisonModel model;
        model.setPick(picked(frustumGeometry(), 613.0, 57.0, hit ? 0.987654321 : 1.0, hit));
        QString text = model.text();
        QVERIFY(text.endsWith(u'\n'));
        text.chop(1);
        const QStringList lines = text.split(u'\n');
        QCOMPARE(lines.size(), 1 + model.rowCount());
        for (int row = 0; row < model.rowCount(); ++row) {
            const QStringList cells = lines[row + 1].split(u'\t');
            QCOMPARE(cells.size(), 1 + model.columnCount());
            QCOMPARE(cells[0], model.headerData(row, Qt::Vertical).toString());
            for (int column = 0; column < model.columnCount(); ++column) {
                bool isNumber = false;
                const double value = cells[column + 1].toDouble(&isNumber);
                QVERIFY(isNumber);
                QVERIFY(value == cell(model, row, column, ComparisonModel::kValueRole).toDouble());
            }
        }
    }
}

void TestComparisonPanel::theFloatColumnsAreShownOnRequest()
{
    PanelOfPicks panel;
    auto *table = panel.findChild<QTableView *>();
    QSignalSpy changes(&panel, &ComparisonPanel::showsFloatChanged);
    const auto areHidden = [&] {
        return table->isColumnHidden(ComparisonModel::MatrixInFloat)
               && table->isColumnHidden(ComparisonModel::FloatDifference);
    };
    QVERIFY(areHidden());
    panel.findChild<QCheckBox *>()->click();
    QVERIFY(panel.showsFloat());
    QVERIFY(!table->isColumnHidden(ComparisonModel::MatrixInFloat)
            && !table->isColumnHidden(ComparisonModel::FloatDifference));
    panel.setPick(picked(frustumGeometry(), 412.0, 299.0, 0.75)); // and stay shown
    QVERIFY(!table->isColumnHidden(ComparisonModel::MatrixInFloat));
    // All of it in the width that the panel asks for, without a scroll bar.
    panel.resize(panel.sizeHint().width(), 700);
    static_cast<void>(panel.grab()); // laid out
    QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
    panel.setShowsFloat(false);
    QVERIFY(areHidden());
    QCOMPARE(changes.count(), 2);
    for (int column = 0; column < ComparisonModel::MatrixInFloat; ++column)
        QVERIFY(!table->isColumnHidden(column));
}

void TestComparisonPanel::theWholePanelIsCopied()
{
    PanelOfPicks panel;
    auto *copy = buttonNamed(panel, "&Copy all");
    QVERIFY(!copy->isEnabled());
    const Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
    panel.setPick(pick);
    QVERIFY(copy->isEnabled());
    copy->click();
    const QString text = QApplication::clipboard()->text();
    QCOMPARE(text, panel.text());
    QVERIFY(text.contains(panel.model().text()));
    QVERIFY(text.contains(formulasOf(pick).text()));
    QVERIFY(text.contains(QStringLiteral("Window position\t(412.5, 300.5)")));
    QVERIFY(!hasPlaceholder(text));
    panel.setPick(std::nullopt);
    QVERIFY(!copy->isEnabled());
}

void TestComparisonPanel::selectedCellsAreCopiedWithAllDigits()
{
    PanelOfPicks panel;
    const Pick pick = picked(frustumGeometry(), 612.0, 99.0, 0.9);
    panel.setPick(pick);
    auto *table = panel.findChild<QTableView *>();
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

void TestComparisonPanel::theChainIsWrittenOut()
{
    Picture geometry = frustumGeometry();
    geometry.surface = {800, 600, 1.5};
    PanelOfPicks panel;
    panel.setPick(picked(geometry, 275.2, 200.0, 0.75)); // device 412.8, 300
    QCOMPARE(labelNamed(panel, "What was clicked")->text(), QStringLiteral("A point on the surface"));
    QCOMPARE(labelNamed(panel, "Widget position")->text(), QStringLiteral("(275.2, 200) logical pixels"));
    QCOMPARE(labelNamed(panel, "Device pixel")->text(), QStringLiteral("(412, 300) of 800 × 600, ratio 1.5"));
    QCOMPARE(labelNamed(panel, "Window position")->text(), QStringLiteral("(412.5, 299.5), the pixel's centre"));
    QCOMPARE(labelNamed(panel, "Depth")->text(), QStringLiteral("0.75, as read"));
    panel.setPick(picked(geometry, 275.2, 200.0, 1.0, false));
    QCOMPARE(labelNamed(panel, "What was clicked")->text(), QStringLiteral("Background: no surface here"));
    QCOMPARE(labelNamed(panel, "Depth")->text(), QStringLiteral("1, the far plane's: nothing to read"));
    panel.setPick(std::nullopt);
    QCOMPARE(labelNamed(panel, "Window position")->text(), QStringLiteral("–"));
    QVERIFY(panel.findChild<FormulaView *>()->formulas().text().isEmpty());
}

void TestComparisonPanel::theShownDepthTellsThePoint_data()
{
    QTest::addColumn<double>("distance");
    QTest::addColumn<DepthRange>("range");
    for (const double distance : {0.0015, 0.1, 2.966360, 150.0, 8000.0}) {
        QTest::addRow("%g", distance) << distance << DepthRange{0.0, 1.0};
        QTest::addRow("%g, reversed", distance) << distance << DepthRange{1.0, 0.0};
        QTest::addRow("%g, behind nines", distance) << distance << DepthRange{0.9, 1.0};
    }
}

/// Near 0.001, far 100000: nearly all depths begin with many nines. What is shown, in the chain, in the formula and as other
/// programs have it, tells a point whose digits are those of the table as far as they are certain, and two more.
void TestComparisonPanel::theShownDepthTellsThePoint()
{
    QFETCH(double, distance);
    QFETCH(DepthRange, range);
    const double n = 0.001, f = 100000.0;
    Picture geometry = frustumGeometry();
    geometry.depthRange = range;
    geometry.lens = Projection(Frustum{-n / 2.0, n / 2.0, -n * 0.375, n * 0.375, n, f});
    const double share = (1.0 / n - 1.0 / distance) / (1.0 / n - 1.0 / f);
    constexpr double kSteps = 16777215.0; // of 24 bits
    const double depth = std::round((range.atNear + share * (range.atFar - range.atNear)) * kSteps) / kSteps;
    const Pick pick = picked(geometry, 700.0, 100.0, depth);
    PanelOfPicks panel;
    panel.setPick(pick);
    const Unprojector unprojector = Unprojector::of(geometry).value();
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
    // Copied, it has all its digits.
    const QString copied = panel.text().section(QStringLiteral("Depth\t"), 1).section(u',', 0, 0);
    QCOMPARE(copied.toDouble(), pick.window.z);
    const FormulaTerms terms = formulasOf(pick).terms;
    const double unit = terms.at(QStringLiteral("d")).value.front().toDouble();
    QVERIFY(tellsThePoint(range.atNear + unit * (range.atFar - range.atNear)));
    ApiClicksView view;
    view.setOpen(true);
    view.setPick(pick);
    const auto *table = view.findChild<QTableWidget *>();
    const QString asOpenGl = table->item(0, 1)->text();
    QCOMPARE(asOpenGl, chain);
}

void TestComparisonPanel::theDepthRangeChangesOnlyTheDepth()
{
    const DepthRange range = depthranges::ofThisRow();
    Picture geometry = frustumGeometry();
    geometry.depthRange = range;
    // By hand: half of the depths is the distance 2 n f / (n + f) = 10/3, the eye point (412.5, 300.5) of 800 x 600 there.
    const double distance = 10.0 / 3.0;
    const glm::dvec3 eye((412.5 / 400.0 - 1.0) * 0.8284271247461901 / 2.0 * distance,
                         (300.5 / 300.0 - 1.0) * 0.6213203435596426 / 2.0 * distance, -distance);
    PanelOfPicks panel;
    panel.setPick(picked(geometry, 412.0, 299.0, (range.atNear + range.atFar) / 2.0));
    QCOMPARE(labelNamed(panel, "Depth")->text(),
             shortestText((range.atNear + range.atFar) / 2.0) + QStringLiteral(", as read"));
    for (int axis = 0; axis < 3; ++axis) {
        for (const int column : {int(ComparisonModel::Formula), int(ComparisonModel::Matrix)}) {
            const double value = cell(panel.model(), 3 + axis, column, ComparisonModel::kValueRole).toDouble();
            QVERIFY2(std::abs(value - eye[axis]) < 1e-14, qPrintable(QString::number(value, 'g', 17)));
        }
    }
    // The formulas begin with the depth in [0, 1].
    const QString formulas = panel.findChild<FormulaView *>()->formulas().text();
    QVERIFY2(formulas.contains(QStringLiteral("(1 − 0.5)")) && formulas.contains(QStringLiteral("3.33333")),
             qPrintable(formulas));
    // The ray of the background goes from the near plane's depth to the far plane's.
    panel.setPick(picked(geometry, 412.0, 299.0, range.atFar, false));
    QCOMPARE(labelNamed(panel, "Depth")->text(),
             shortestText(range.atFar) + QStringLiteral(", the far plane's: nothing to read"));
    const auto worldZ = [&](int row) {
        return cell(panel.model(), row, ComparisonModel::Formula, ComparisonModel::kValueRole).toDouble();
    };
    QCOMPARE(worldZ(2), 3.0);
    QCOMPARE(worldZ(5), -5.0);
}

void TestComparisonPanel::thePanelStandsStillOnceItHasGrown_data()
{
    QTest::addColumn<bool>("showsFloat");
    QTest::newRow("doubles only") << false;
    QTest::newRow("with float") << true;
}

void TestComparisonPanel::thePanelStandsStillOnceItHasGrown()
{
    QFETCH(bool, showsFloat);
    PanelOfPicks panel;
    panel.setShowsFloat(showsFloat);
    panel.resize(460, 760);
    panel.show();
    const auto places = [&panel] {
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        QStringList list;
        for (const QWidget *child : panel.findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
            const QRect r = child->geometry();
            // How wide a text is drawn is its own affair; where it stands and what is below it is not.
            list << QStringLiteral("%1 (%2): %3,%4 %5")
                        .arg(QLatin1String(child->metaObject()->className()), child->accessibleName())
                        .arg(r.x())
                        .arg(r.y())
                        .arg(r.height());
        }
        const QSize least = panel.minimumSizeHint().expandedTo(panel.minimumSize());
        list << QStringLiteral("at least %1 x %2").arg(least.width()).arg(least.height());
        return list;
    };
    // The longest cause.
    Picture extreme = frustumGeometry();
    extreme.projection() = Frustum{-0.0012345, 0.0012345, -0.00054321, 0.00054321, 0.0012345, 987654.0};
    Pick longest = picked(extreme, 50.0, 120.0, 0.99999);
    const glm::dvec3 point(-123.456789, 234.567891, -345.678912);
    longest.point.world = Answers<WorldSpace>::of(
        [&](Method method) { return WorldPoint(method == Method::Matrix ? point - 1e-10 : point); });
    const std::optional<Pick> picks[] = {
        longest,
        picked(frustumGeometry(), 412.0, 299.0, 0.75),
        picked(frustumGeometry(), 3.0, 2.0, 1.0, false),
        picked(boxGeometry(Ortho{-3000.0, 3000.0, -2000.0, 2000.0, 1.0, 9000.0}), 50.0, 120.0, 0.123456789),
        std::nullopt,
    };
    const auto show = [&](const std::optional<Pick> &pick) {
        panel.setPick(pick);
        return places();
    };
    for (const std::optional<Pick> &pick : picks)
        show(pick);
    const QStringList before = places();
    for (const std::optional<Pick> &pick : picks)
        QCOMPARE(show(pick), before);
}

QTEST_MAIN(TestComparisonPanel)
#include "test_comparison_panel.moc"
