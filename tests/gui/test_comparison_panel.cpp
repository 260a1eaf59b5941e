// What the panel says of a pick: the numbers, which of their digits are certain, the formulas with numbers put in, and
// the wording of every error. No window of OpenGL is needed.

#include "core/pick.h"
#include "gui/error_text.h"
#include "gui/formula_text.h"
#include "gui/number_text.h"
#include "gui/panels/comparison_model.h"
#include "gui/panels/comparison_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include <cmath>
#include <limits>
#include <set>

using namespace unprojector;

namespace {

constexpr double kQuarterTurnHalf = 0.7853981633974483; // 45 degrees

/// 800 x 600, window +-0.828427 x +-0.62132 at n = 2, f = 10, from (0, 0, 5) towards the origin.
ViewGeometry frustumGeometry()
{
    return {{800, 600, 1.0},
            {0.0, 0.0, 800.0, 600.0},
            {},
            Frustum{-0.8284271247461901, 0.8284271247461901, -0.6213203435596426, 0.6213203435596426, 2.0, 10.0},
            {WorldPoint(0.0, 0.0, 5.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}}};
}

ViewGeometry boxGeometry(const Projection &projection)
{
    return {{600, 400, 1.0},
            {0.0, 0.0, 600.0, 400.0},
            {},
            projection,
            {WorldPoint(10.0, 20.0, 30.0), WorldPoint(10.0, 20.0, 20.0), {0.0, 1.0, 0.0}}};
}

Pick picked(const ViewGeometry &geometry, double x, double y, double depth, bool hit = true)
{
    const Result<Pick> pick = pickAt(geometry, WidgetPoint(x, y), {depth, hit, 24});
    if (!pick)
        qFatal("no pick");
    return *pick;
}

/// A pick whose world point is what each method is told to have found.
Pick pickWith(const glm::dvec3 &formula, const glm::dvec3 &matrix, const glm::dvec3 &matrixInFloat, double radius)
{
    Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
    pick.point.world = {WorldPoint(formula), WorldPoint(matrix), WorldPoint(matrixInFloat)};
    pick.certainty = {radius, radius, radius / 2.0};
    return pick;
}

QVariant cell(const ComparisonModel &model, int row, int column, int role = Qt::DisplayRole)
{
    return model.index(row, column).data(role);
}

QLabel *labelNamed(const QWidget &panel, const char *name)
{
    for (QLabel *label : panel.findChildren<QLabel *>()) {
        if (label->accessibleName() == QLatin1String(name))
            return label;
    }
    return nullptr;
}

/// With spaces that may break for those that may not: which is which is a matter of looks.
QString withPlainSpaces(QString text)
{
    return text.replace(QChar::Nbsp, u' ');
}

bool hasPlaceholder(const QString &text)
{
    return text.contains(QRegularExpression(QStringLiteral("%[0-9n]")));
}

} // namespace

class TestComparisonPanel : public QObject {
    Q_OBJECT

private slots:
    void theTableHoldsThePicksDoubles();
    void theTableOfABackgroundHoldsTheRay();
    void differencesAreCountedInUlpsOfTheLargestComponent();
    void certainDigitsEndAtTheRadius_data();
    void certainDigitsEndAtTheRadius();
    void numbersAreWritten_data();
    void numbersAreWritten();
    void aMethodWithoutAnswerSaysNone();
    void theCopiedTableReadsBackToTheSameDoubles();
    void theFloatColumnsAreShownOnRequest();
    void theWholePanelIsCopied();
    void selectedCellsAreCopiedWithAllDigits();
    void theChainIsWrittenOut();
    void theFormulaIsWrittenWithItsNumbers_data();
    void theFormulaIsWrittenWithItsNumbers();
    void theRayOfABackgroundIsWritten();
    void theCauseOfADifferenceIsNamed();
    void theCertaintyIsNamed();
    void thePanelStandsStillFromClickToClick_data();
    void thePanelStandsStillFromClickToClick();
    void everyErrorHasItsSentence_data();
    void everyErrorHasItsSentence();
    void everyImportErrorHasItsSentence_data();
    void everyImportErrorHasItsSentence();
};

void TestComparisonPanel::theTableHoldsThePicksDoubles()
{
    ComparisonModel model;
    QCOMPARE(model.rowCount(), 6);
    for (int row = 0; row < 6; ++row)
        QVERIFY(!cell(model, row, ComparisonModel::Formula, ComparisonModel::ValueRole).isValid());

    const Pick pick = picked(frustumGeometry(), 612.0, 99.0, 0.9);
    model.setPick(pick);
    QCOMPARE(model.rowCount(), 6);
    const auto check = [&model](int firstRow, const char *space, const auto &point) {
        for (int axis = 0; axis < 3; ++axis) {
            const int row = firstRow + axis;
            const auto value = [&](int column) {
                return cell(model, row, column, ComparisonModel::ValueRole).toDouble();
            };
            const double formula = point.formula->coordinates()[axis], matrix = point.matrix->coordinates()[axis];
            const double inFloat = point.matrixInFloat->coordinates()[axis];
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
        QVERIFY(cell(model, axis, ComparisonModel::Formula, ComparisonModel::ValueRole).toDouble()
                == pick.rayNear.world.formula->coordinates()[axis]);
        QVERIFY(cell(model, 3 + axis, ComparisonModel::Matrix, ComparisonModel::ValueRole).toDouble()
                == pick.rayFar.world.matrix->coordinates()[axis]);
    }
}

void TestComparisonPanel::differencesAreCountedInUlpsOfTheLargestComponent()
{
    // The ulp of 4 is 2^-50. x differs by -2^-52, z by 2^-51: -0.25 and 0.5 of it.
    ComparisonModel model;
    model.setPick(pickWith({1.0, 2.0, 4.0}, {1.0 + std::ldexp(1.0, -52), 2.0, 4.0 - std::ldexp(1.0, -51)},
                           {1.0, 2.0, 4.5}, 0.01));
    const auto value = [&](int row, int column) {
        return cell(model, row, column, ComparisonModel::ValueRole).toDouble();
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
}

void TestComparisonPanel::certainDigitsEndAtTheRadius_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("radius");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("certain");
    QTest::newRow("to a hundredth") << 1.25 << 0.004 << "1.250000000000000"
                                    << "1.25";
    QTest::newRow("to a tenth") << 1.25 << 0.05 << "1.250000000000000"
                                << "1.2";
    QTest::newRow("exactly a hundredth") << 1.25 << 0.01 << "1.250000000000000"
                                         << "1.25";
    QTest::newRow("not to one") << 1.25 << 1.5 << "1.250000000000000"
                                << "1";
    QTest::newRow("negative") << -3.5 << 0.004 << "-3.500000000000000"
                              << "-3.50";
    QTest::newRow("no uncertainty") << 1.25 << 0.0 << "1.250000000000000"
                                    << "1.250000000000000";
    QTest::newRow("finer than a double") << 1.25 << 1e-20 << "1.250000000000000"
                                         << "1.250000000000000";
    QTest::newRow("thousands") << 1234.5 << 0.04 << "1234.500000000000"
                               << "1234.5";
    QTest::newRow("small") << 0.00125 << 0.00004 << "0.001250000000000000"
                           << "0.0012";
}

void TestComparisonPanel::certainDigitsEndAtTheRadius()
{
    QFETCH(double, x);
    QFETCH(double, radius);
    QFETCH(QString, text);
    QFETCH(QString, certain);
    ComparisonModel model;
    model.setPick(pickWith({x, 0.0, 0.0}, {x, 0.0, 0.0}, {x, 0.0, 0.0}, radius));
    QCOMPARE(cell(model, 0, ComparisonModel::Formula).toString(), text);
    const int length = cell(model, 0, ComparisonModel::Formula, ComparisonModel::CertainLengthRole).toInt();
    QCOMPARE(text.left(length), certain);
    QCOMPARE(cell(model, 0, ComparisonModel::Matrix, ComparisonModel::CertainLengthRole).toInt(), length);
    // A number that is a difference has no certain part.
    QVERIFY(!cell(model, 0, ComparisonModel::Difference, ComparisonModel::CertainLengthRole).isValid());
    const QString inFloat = cell(model, 0, ComparisonModel::MatrixInFloat).toString();
    QVERIFY(inFloat.size() < text.size() && text.startsWith(inFloat));
    QVERIFY(cell(model, 0, ComparisonModel::MatrixInFloat, ComparisonModel::CertainLengthRole).toInt()
            <= inFloat.size());
}

void TestComparisonPanel::numbersAreWritten_data()
{
    QTest::addColumn<QString>("is");
    QTest::addColumn<QString>("expected");
    QTest::newRow("shortest") << shortestText(0.1) << "0.1";
    QTest::newRow("shortest, all digits") << shortestText(0.1 + 0.2) << "0.30000000000000004";
    QTest::newRow("shortest, tiny") << shortestText(1e-17) << "1e-17";
    QTest::newRow("significant") << significantText(0.82842712, 4) << "0.8284";
    QTest::newRow("significant, negative zero") << significantText(-0.0, 4) << "0";
    QTest::newRow("fixed") << fixedText(-1.5, 3) << "-1.500";
    QTest::newRow("fixed, rounds to zero") << fixedText(-0.0001, 3) << "0.000";
    QTest::newRow("point") << pointText({1.0, -2.0, 0.25}, 2) << "(1.00, -2.00, 0.25)";
    QTest::newRow("decimals for 123") << QString::number(decimalsFor({1.0, -123.0, 4.0}, 16)) << "13";
    QTest::newRow("decimals for nothing") << QString::number(decimalsFor({0.0, 0.0, 0.0}, 16)) << "15";
    QTest::newRow("certain decimals") << QString::number(certainDecimals(0.002)) << "2";
    QTest::newRow("certain decimals of infinity")
        << QString::number(certainDecimals(std::numeric_limits<double>::infinity())) << "15";
}

void TestComparisonPanel::numbersAreWritten()
{
    QFETCH(QString, is);
    QFETCH(QString, expected);
    QCOMPARE(is, expected);
}

void TestComparisonPanel::aMethodWithoutAnswerSaysNone()
{
    Pick pick = pickWith({1.0, 2.0, 4.0}, {1.0, 2.0, 4.0}, {1.0, 2.0, 4.0}, 0.01);
    pick.point.world.matrix = Error{ErrorCode::SingularMatrix};
    ComparisonModel model;
    model.setPick(pick);
    QCOMPARE(cell(model, 0, ComparisonModel::Matrix).toString(), QStringLiteral("none"));
    QCOMPARE(cell(model, 0, ComparisonModel::Difference).toString(), QStringLiteral("none"));
    QVERIFY(cell(model, 0, ComparisonModel::Formula, ComparisonModel::ValueRole).toDouble() == 1.0);
    QVERIFY(!cell(model, 0, ComparisonModel::Matrix, ComparisonModel::ValueRole).isValid());
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
                QVERIFY(value == cell(model, row, column, ComparisonModel::ValueRole).toDouble());
            }
        }
    }
}

void TestComparisonPanel::theFloatColumnsAreShownOnRequest()
{
    ComparisonPanel panel;
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
    panel.setShowsFloat(false);
    QVERIFY(areHidden());
    QCOMPARE(changes.count(), 2);
    for (int column = 0; column < ComparisonModel::MatrixInFloat; ++column)
        QVERIFY(!table->isColumnHidden(column));
}

void TestComparisonPanel::theWholePanelIsCopied()
{
    ComparisonPanel panel;
    auto *copy = panel.findChild<QPushButton *>();
    QVERIFY(!copy->isEnabled());
    const Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
    panel.setPick(pick);
    QVERIFY(copy->isEnabled());
    copy->click();
    const QString text = QApplication::clipboard()->text();
    QCOMPARE(text, panel.text());
    QVERIFY(text.contains(panel.model().text()));
    QVERIFY(text.contains(formulaText(pick)));
    QVERIFY(text.contains(QStringLiteral("Window position\t(412.5, 300.5)")));
    QVERIFY(!hasPlaceholder(text));
    panel.setPick(std::nullopt);
    QVERIFY(!copy->isEnabled());
}

void TestComparisonPanel::selectedCellsAreCopiedWithAllDigits()
{
    ComparisonPanel panel;
    const Pick pick = picked(frustumGeometry(), 612.0, 99.0, 0.9);
    panel.setPick(pick);
    auto *table = panel.findChild<QTableView *>();
    table->selectionModel()->select(QItemSelection(table->model()->index(0, 0), table->model()->index(1, 1)),
                                    QItemSelectionModel::Select);
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    const auto &world = pick.point.world;
    QCOMPARE(QApplication::clipboard()->text(),
             QStringLiteral("%1\t%2\n%3\t%4")
                 .arg(shortestText(world.formula->x), shortestText(world.matrix->x), shortestText(world.formula->y),
                      shortestText(world.matrix->y)));
}

void TestComparisonPanel::theChainIsWrittenOut()
{
    ViewGeometry geometry = frustumGeometry();
    geometry.surface = {800, 600, 1.5};
    ComparisonPanel panel;
    panel.setPick(picked(geometry, 275.2, 200.0, 0.75)); // device 412.8, 300
    QCOMPARE(labelNamed(panel, "What was clicked")->text(), QStringLiteral("A point on the surface"));
    QCOMPARE(labelNamed(panel, "Widget position")->text(), QStringLiteral("(275.2, 200) logical pixels"));
    QCOMPARE(labelNamed(panel, "Device pixel")->text(), QStringLiteral("(412, 300) of 800 × 600, ratio 1.5"));
    QCOMPARE(labelNamed(panel, "Window position")->text(), QStringLiteral("(412.5, 299.5), the pixel's centre"));
    QCOMPARE(labelNamed(panel, "Depth")->text(), QStringLiteral("0.75"));
    panel.setPick(picked(geometry, 275.2, 200.0, 1.0, false));
    QCOMPARE(labelNamed(panel, "What was clicked")->text(), QStringLiteral("Background: no surface here"));
    QCOMPARE(labelNamed(panel, "Depth")->text(), QStringLiteral("1, the background's"));
    panel.setPick(std::nullopt);
    QCOMPARE(labelNamed(panel, "Window position")->text(), QStringLiteral("–"));
    QVERIFY(panel.findChild<QPlainTextEdit *>()->toPlainText().isEmpty());
}

void TestComparisonPanel::theFormulaIsWrittenWithItsNumbers_data()
{
    QTest::addColumn<Pick>("pick");
    QTest::addColumn<QString>("expected");

    // z = 20 / (2.5 + 1.5) = 5. x = 0.828427 x (2 x 412.5 / 800 - 1) x 5 / 2 = 0.0647209; y the same with 300.5 / 600.
    QTest::newRow("frustum")
        << picked(frustumGeometry(), 412.0, 299.0, 0.75)
        << QStringLiteral(
               "z = n f / (f (1 − d) + n d)\n"
               "  = 2 × 10 / (10 × (1 − 0.75) + 2 × 0.75) = 5\n\n"
               "(9) x = (412.5 − 0) × (0.828427 − (−0.828427)) × 5 / (800 × 2) + (−0.828427) × 5 / 2 = 0.0647209\n\n"
               "(10) y = (600 − 299.5 − 0) × (0.62132 − (−0.62132)) × 5 / (600 × 2) + (−0.62132) × 5 / 2 = "
               "0.00258883\n\n"
               "world = eye + x s + y u + z f\n"
               "  = (0, 0, 5) + 0.0647209 × (1, 0, 0) + 0.00258883 × (0, 1, 0) + 5 × (0, 0, −1)\n"
               "  = (0.0647209, 0.00258883, 0)");

    // A viewport of 400 x 300 from (100, 50); window 0.5 .. 1.5 and -0.5 .. 1 at n = 1, f = 4: z = 4 / (2 + 0.5) = 1.6;
    // x = (200.5 x 1 / 400 + 0.5) x 1.6 = 1.602, y = (100.5 x 1.5 / 300 - 0.5) x 1.6 = 0.004
    ViewGeometry offset = frustumGeometry();
    offset.viewport = {100.0, 50.0, 400.0, 300.0};
    offset.projection = Frustum{0.5, 1.5, -0.5, 1.0, 1.0, 4.0};
    QTest::newRow("off-centre frustum in an offset viewport")
        << picked(offset, 300.0, 449.0, 0.5)
        << QStringLiteral("z = n f / (f (1 − d) + n d)\n"
                          "  = 1 × 4 / (4 × (1 − 0.5) + 1 × 0.5) = 1.6\n\n"
                          "(9) x = (300.5 − 100) × (1.5 − 0.5) × 1.6 / (400 × 1) + 0.5 × 1.6 / 1 = 1.602\n\n"
                          "(10) y = (600 − 449.5 − 50) × (1 − (−0.5)) × 1.6 / (300 × 1) + (−0.5) × 1.6 / 1 = 0.004\n\n"
                          "world = eye + x s + y u + z f\n"
                          "  = (0, 0, 5) + 1.602 × (1, 0, 0) + 0.004 × (0, 1, 0) + 1.6 × (0, 0, −1)\n"
                          "  = (1.602, 0.004, 3.4)");

    // z = 0.75 + 2.25 = 3; x = 350.5 x 6 / 600 - 3 = 0.505; y = 279.5 x 4 / 400 - 2 = 0.795
    const Ortho box{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0};
    QTest::newRow("ortho") << picked(boxGeometry(box), 350.0, 120.0, 0.25)
                           << QStringLiteral(
                                  "z = n (1 − d) + f d\n"
                                  "  = 1 × (1 − 0.25) + 9 × 0.25 = 3\n\n"
                                  "(11) x = (350.5 − 0) × (3 − (−3)) / 600 + (−3) = 0.505\n\n"
                                  "(12) y = (400 − 120.5 − 0) × (2 − (−2)) / 400 + (−2) = 0.795\n\n"
                                  "world = eye + x s + y u + z f\n"
                                  "  = (10, 20, 30) + 0.505 × (1, 0, 0) + 0.795 × (0, 1, 0) + 3 × (0, 0, −1)\n"
                                  "  = (10.505, 20.795, 27)");

    // The near plane of a box may lie behind the eye: z = -0.75 + 2.25 = 1.5 with n = -1.
    QTest::newRow("ortho, negative near")
        << picked(boxGeometry(Ortho{-3.0, 3.0, -2.0, 2.0, -1.0, 9.0}), 50.0, 120.0, 0.25)
        << QStringLiteral("z = n (1 − d) + f d\n"
                          "  = (−1) × (1 − 0.25) + 9 × 0.25 = 1.5\n\n"
                          "(11) x = (50.5 − 0) × (3 − (−3)) / 600 + (−3) = −2.495\n\n"
                          "(12) y = (400 − 120.5 − 0) × (2 − (−2)) / 400 + (−2) = 0.795\n\n"
                          "world = eye + x s + y u + z f\n"
                          "  = (10, 20, 30) + (−2.495) × (1, 0, 0) + 0.795 × (0, 1, 0) + 1.5 × (0, 0, −1)\n"
                          "  = (7.505, 20.795, 28.5)");

    QTest::newRow("oblique") << picked(boxGeometry(Oblique{box, kQuarterTurnHalf, 2.0 * kQuarterTurnHalf}), 350.0,
                                       120.0, 0.25)
                             << QStringLiteral(
                                    "z = n (1 − d) + f d\n"
                                    "  = 1 × (1 − 0.25) + 9 × 0.25 = 3\n\n"
                                    "(11) x = (350.5 − 0) × (3 − (−3)) / 600 + (−3) = 0.505\n\n"
                                    "(12) y = (400 − 120.5 − 0) × (2 − (−2)) / 400 + (−2) = 0.795\n\n"
                                    "x += cot 45° × 3: 0.505 → 3.505\n\n"
                                    "y += cot 90° × 3: 0.795 → 0.795\n\n"
                                    "world = eye + x s + y u + z f\n"
                                    "  = (10, 20, 30) + 3.505 × (1, 0, 0) + 0.795 × (0, 1, 0) + 3 × (0, 0, −1)\n"
                                    "  = (13.505, 20.795, 27)");
}

void TestComparisonPanel::theFormulaIsWrittenWithItsNumbers()
{
    QFETCH(Pick, pick);
    QFETCH(QString, expected);
    QCOMPARE(withPlainSpaces(formulaText(pick)), expected);
    ComparisonPanel panel;
    panel.setPick(pick);
    // The panel may break its lines where it is narrow.
    QCOMPARE(panel.findChild<QPlainTextEdit *>()->toPlainText().simplified(), expected.simplified());
}

void TestComparisonPanel::theRayOfABackgroundIsWritten()
{
    // The pixel (350, 120) of the box above: x = 0.505, y = 0.795 at both ends, z = 1 and 9.
    const Pick pick = picked(boxGeometry(Ortho{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0}), 350.0, 120.0, 1.0, false);
    QCOMPARE(rayText(pick),
             QStringLiteral(
                 "p(t) = near + t (far − near), 0 ≤ t ≤ 1\nnear = (10.505, 20.795, 29)\nfar = (10.505, 20.795, 21)"));
}

void TestComparisonPanel::theCauseOfADifferenceIsNamed()
{
    QVERIFY(differenceCauseText(pickWith({1.0, 2.0, 4.0}, {1.0, 2.0, 4.0}, {1.0, 2.0, 4.0}, 0.01))
                .contains(QStringLiteral("agree")));
    const QString cause =
        withPlainSpaces(differenceCauseText(pickWith({1.0, 2.0, 4.0}, {1.0, 2.0, 4.0 + 1e-12}, {1.0, 2.0, 4.0}, 0.01)));
    // z = 4 between 2 and 10 gives 1.6; the largest coordinate is 4.
    QVERIFY2(cause.contains(QStringLiteral("magnified")) && cause.contains(QStringLiteral("perspective")),
             qPrintable(cause));
    QVERIFY(!hasPlaceholder(cause));
}

void TestComparisonPanel::theCertaintyIsNamed()
{
    Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
    pick.certainty = {1.26e-6, 0.008, 0.0124};
    const QString text = withPlainSpaces(certaintyText(pick));
    QVERIFY2(text.contains(QStringLiteral("± 1.3e-06 along the view")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("± 0.004 × 0.0062 across it")), qPrintable(text));
}

void TestComparisonPanel::thePanelStandsStillFromClickToClick_data()
{
    QTest::addColumn<bool>("showsFloat");
    QTest::newRow("doubles only") << false;
    QTest::newRow("with float") << true;
}

void TestComparisonPanel::thePanelStandsStillFromClickToClick()
{
    QFETCH(bool, showsFloat);
    ComparisonPanel panel;
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
    const QStringList before = places();
    panel.setPick(picked(frustumGeometry(), 412.0, 299.0, 0.75));
    QCOMPARE(places(), before);
    panel.setPick(picked(frustumGeometry(), 3.0, 2.0, 1.0, false));
    QCOMPARE(places(), before);
    panel.setPick(picked(boxGeometry(Ortho{-3000.0, 3000.0, -2000.0, 2000.0, 1.0, 9000.0}), 50.0, 120.0, 0.123456789));
    QCOMPARE(places(), before);
    // The longest cause.
    ViewGeometry extreme = frustumGeometry();
    extreme.projection = Frustum{-0.0012345, 0.0012345, -0.00054321, 0.00054321, 0.0012345, 987654.0};
    Pick longest = picked(extreme, 50.0, 120.0, 0.99999);
    const glm::dvec3 point(-123.456789, 234.567891, -345.678912);
    longest.point.world = {WorldPoint(point), WorldPoint(point - 1e-10), WorldPoint(point)};
    panel.setPick(longest);
    QCOMPARE(places(), before);
    panel.setPick(std::nullopt);
    QCOMPARE(places(), before);
}

void TestComparisonPanel::everyErrorHasItsSentence_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<QStringList>("named");
    std::set<int> codes;
    const auto row = [&codes](const char *name, ErrorCode code, const QStringList &named = {}) {
        codes.insert(static_cast<int>(code));
        QTest::newRow(name) << static_cast<int>(code) << named;
    };
    // 0.25 and 7.5 are the values; 0.25 radians are 14.3239 degrees.
    const QString value = QStringLiteral("0.25"), other = QStringLiteral("7.5"), angle = QStringLiteral("14.3239°");
    row("not finite", ErrorCode::NotFinite, {value});
    row("near not positive", ErrorCode::NearNotPositive, {value, other});
    row("near not before far", ErrorCode::NearNotBeforeFar, {value, other});
    row("left equals right", ErrorCode::LeftEqualsRight, {value});
    row("bottom equals top", ErrorCode::BottomEqualsTop, {value});
    row("field of view", ErrorCode::FieldOfViewOutOfRange, {angle});
    row("aspect", ErrorCode::AspectNotPositive, {value});
    row("shear angle", ErrorCode::ShearAngleOutOfRange, {angle});
    row("eye equals center", ErrorCode::EyeEqualsCenter);
    row("up is zero", ErrorCode::UpIsZero);
    row("up parallel to view", ErrorCode::UpParallelToView);
    row("empty viewport", ErrorCode::EmptyViewport, {value, other});
    row("empty framebuffer", ErrorCode::EmptyFramebuffer, {value, other});
    row("pixel ratio", ErrorCode::PixelRatioNotPositive, {value});
    row("empty depth range", ErrorCode::EmptyDepthRange, {value});
    row("depth outside range", ErrorCode::DepthOutsideRange, {value});
    row("outside the framebuffer", ErrorCode::OutsideFramebuffer, {value, other});
    row("singular matrix", ErrorCode::SingularMatrix);
    row("point at infinity", ErrorCode::PointAtInfinity);
    row("scale is zero", ErrorCode::ScaleIsZero);
    row("rotation axis is zero", ErrorCode::RotationAxisIsZero);
    QCOMPARE(codes.size(), std::size_t(ErrorCode::RotationAxisIsZero) + 1); // none is left out
}

void TestComparisonPanel::everyErrorHasItsSentence()
{
    QFETCH(int, code);
    QFETCH(QStringList, named);
    const QString text = errorText(Error{static_cast<ErrorCode>(code), 0.25, 7.5});
    QVERIFY(text.size() > 15 && text.endsWith(u'.'));
    QVERIFY2(!hasPlaceholder(text), qPrintable(text));
    for (const QString &value : named)
        QVERIFY2(text.contains(value), qPrintable(text));
    const QString nan = errorText(Error{static_cast<ErrorCode>(code)});
    QVERIFY2(!hasPlaceholder(nan), qPrintable(nan));
}

void TestComparisonPanel::everyImportErrorHasItsSentence_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("named");
    std::set<int> codes;
    const auto row = [&codes](const char *name, ImportErrorCode code, const char *named) {
        codes.insert(static_cast<int>(code));
        QTest::newRow(name) << static_cast<int>(code) << QString::fromLatin1(named);
    };
    row("not found", ImportErrorCode::NotFound, "does not exist");
    row("folder", ImportErrorCode::IsDirectory, "folder");
    row("not readable", ImportErrorCode::NotReadable, "line 42");
    row("empty", ImportErrorCode::EmptyFile, "0 bytes");
    row("unknown format", ImportErrorCode::UnknownFormat, "OBJ, STL, PLY, OFF, glTF or GLB");
    row("malformed", ImportErrorCode::Malformed, "line 42");
    row("no triangles", ImportErrorCode::NoTriangles, "no triangles");
    row("not finite", ImportErrorCode::NotFinite, "vertex 17");
    row("cancelled", ImportErrorCode::Cancelled, "cancelled");
    row("out of memory", ImportErrorCode::OutOfMemory, "memory");
    QCOMPARE(codes.size(), std::size_t(ImportErrorCode::OutOfMemory) + 1);
}

void TestComparisonPanel::everyImportErrorHasItsSentence()
{
    QFETCH(int, code);
    QFETCH(QString, named);
    for (const char *detail : {"line 42", ""}) {
        const QString text =
            errorText(ImportError{static_cast<ImportErrorCode>(code), "some folder/model.obj", detail, 17});
        QVERIFY2(text.contains(QStringLiteral("model.obj")), qPrintable(text));
        QVERIFY2(!hasPlaceholder(text), qPrintable(text));
        if (*detail || named != QStringLiteral("line 42"))
            QVERIFY2(text.contains(named), qPrintable(text));
    }
    // A name that looks like a placeholder is a name.
    const QString text = errorText(ImportError{static_cast<ImportErrorCode>(code), "100%1%2.obj", "line 42", 17});
    QVERIFY2(text.contains(QStringLiteral("100%1%2.obj")), qPrintable(text));
}

QTEST_MAIN(TestComparisonPanel)
#include "test_comparison_panel.moc"
