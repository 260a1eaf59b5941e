// The digits of a coordinate in the comparison: the number of digits, the certain ones, and the
// grey ones.

#include "tests/support/test.h"

#include "gui/click/answer_view.h"
#include "gui/click/comparison_model.h"
#include "gui/click/comparison_panel.h"
#include "gui/click/coordinates_table.h"
#include "gui/widgets/contrast.h"

#include "tests/gui/comparison_picks.h"

#include <QLabel>
#include <QRegularExpression>

#include <cmath>

using namespace comparing;
using namespace unprojector::gui;
using namespace unprojector::unproject;

class TestComparisonDigits : public QObject {
    Q_OBJECT

private slots:
    void certainDigitsAreBlackAndTwoMoreGrey_data()
    {
        addColumn<double>("x");
        addColumn<double>("uncertainty");
        addColumn<QString>("text");
        addColumn<QString>("black");
        const auto row = [](const char *name, double x, double uncertainty, const char *text, const char *black) {
            newRow(name) << x << uncertainty << QString::fromLatin1(text) << QString::fromLatin1(black);
        };
        row("to a hundredth", 1.25, 0.004, "1.2500", "1.25");
        row("exactly a hundredth", 1.25, 0.01, "1.2500", "1.25");
        row("to a tenth", 1.23, 0.05, "1.230", "1.2");
        row("nearly -3", -2.9999994, 0.05, "-3.000", "-3.0");
        // Black down to the certain place, whether or not the next digit rounds it up.
        row("rounded up", 1.27, 0.05, "1.270", "1.2");
        row("rounded up to the place before its digits", 7.26, 5.0, "7.3", "7");
        row("less than its uncertainty", 1.26, 1.5, "1.3", "");
        row("nothing but the uncertainty", 0.004, 0.05, "0.004", "0.0");
        row("negative", -3.5, 0.004, "-3.5000", "-3.50");
        row("no uncertainty", 1.25, 0.0, "1.250000000", "1.250000000");
        row("finer than a double", 1.25, 1e-25, "1.250000000000000", "1.250000000000000");
        row("to the last place of a double", 1.25, 1e-16, "1.250000000000000", "1.250000000000000");
        row("thousands", 1234.5, 0.04, "1234.500", "1234.5");
        row("hundreds that may be off", 1234.6, 30.0, "1235", "12");
        row("small", 0.00121, 0.00004, "0.001210", "0.0012");
        row("of a small scan", 0.00903634, 1.4e-8, "0.009036340", "0.0090363");
        row("on a map", 5412349.529786, 1e-6, "5412349.52978600", "5412349.529786");
        row("tiny", 1.234e-12, 3e-15, "1.2340e-12", "1.23");
        row("tiny, far below its size", 1.0802858072384839e-13, 9.18e-21, "1.080285807e-13", "1.0802858");
        row("tiny, no uncertainty", 1.234e-12, 0.0, "1.234000000e-12", "1.234000000");
        row("huge", 1.25e20, 1e12, "1.2500000000e+20", "1.25000000");
    }

    void certainDigitsAreBlackAndTwoMoreGrey()
    {
        QFETCH(double, x);
        QFETCH(double, uncertainty);
        QFETCH(QString, text);
        QFETCH(QString, black);
        ComparisonModel model;
        model.setPick(kept(pickWith({x, 0.0, 0.0}, {x, 0.0, 0.0}, {x, 0.0, 0.0}, uncertainty)));
        const int length = cell(model, 0, ComparisonModel::Formula, ComparisonModel::kCertainLengthRole).toInt();
        QCOMPARE(cell(model, 0, ComparisonModel::Formula).toString(), text);
        QCOMPARE(text.left(length), black);
        for (const int column : {int(ComparisonModel::Matrix), int(ComparisonModel::MatrixInFloat)}) {
            QCOMPARE(cell(model, 0, column).toString(), text);
            QCOMPARE(cell(model, 0, column, ComparisonModel::kCertainLengthRole).toInt(), length);
        }
        // A difference has no certain part.
        QVERIFY(!cell(model, 0, ComparisonModel::Difference, ComparisonModel::kCertainLengthRole).isValid());
    }

    /// The digits of single precision are grey as far as they are off. That holds on the background
    /// too, where the methods' answers are exact.
    void digitsThatAreOffAreNotBlack()
    {
        ComparisonModel model;
        model.setPick(kept(pickWith({1.25, 0.0, 0.0}, {1.25, 0.0, 0.0}, {1.31, 0.0, 0.0}, 0.0004)));
        const auto black = [&model](int row, int column) {
            return cell(model, row, column)
                .toString()
                .left(cell(model, row, column, ComparisonModel::kCertainLengthRole).toInt());
        };
        QCOMPARE(black(0, ComparisonModel::Formula), QStringLiteral("1.250"));
        QCOMPARE(black(0, ComparisonModel::Matrix), QStringLiteral("1.250"));
        QCOMPARE(cell(model, 0, ComparisonModel::MatrixInFloat).toString(), QStringLiteral("1.31000"));
        QCOMPARE(black(0, ComparisonModel::MatrixInFloat), QStringLiteral("1.3"));
        QVERIFY(cell(model, 0, ComparisonModel::MatrixInFloat, Qt::ToolTipRole)
                    .toString()
                    .startsWith(QStringLiteral("1.31 ± 0.0")));

        model.setPick(kept(picked(frustumGeometry(), 3.0, 2.0, 1.0, false)));
        const QString whole = cell(model, 0, ComparisonModel::MatrixInFloat).toString();
        QVERIFY(black(0, ComparisonModel::Formula) == cell(model, 0, ComparisonModel::Formula).toString());
        QVERIFY2(black(0, ComparisonModel::MatrixInFloat).size() < whole.size(), qPrintable(whole));
    }

    void theAnswerHasTheDigitsOfTheTable()
    {
        Pick pick = pickWith({-1.23456789, 300.789, 0.0045}, {-1.0, 300.0, 0.0}, {-1.0, 300.0, 0.0}, 0.0);
        pick.uncertainty.world = {0.0004, 0.02, 0.00003};
        PanelOfPicks panel;
        panel.setPick(pick);
        auto *answer = panel.findChild<AnswerView *>();
        QCOMPARE(answer->text().replace(QChar::Nbsp, u' '), QStringLiteral("(-1.23457, 300.789, 0.004500) ± 0.02"));
        const auto digits = [&panel](int row) { return cell(panel.model(), row, ComparisonModel::Formula).toString(); };
        QVERIFY(answer->text().startsWith(QStringLiteral("(%1, %2, %3)").arg(digits(0), digits(1), digits(2))));
        // The two digits after the certain ones are grey, in both texts.
        const QString markup = labelNamed(panel, "World coordinate")->text();
        for (const char *grey : {">57<", ">89<", ">00<"})
            QVERIFY2(markup.contains(QLatin1String(grey)), qPrintable(markup));
        QCOMPARE(cell(panel.model(), 0, ComparisonModel::Formula, ComparisonModel::kCertainLengthRole).toInt(), 6);

        // A power of ten is written once, also where all digits before it are certain.
        panel.setPick(pickWith({1.25e-13, -2.5e-13, 3e-14}, {1.25e-13, -2.5e-13, 3e-14}, {0.0, 0.0, 0.0}, 0.0));
        QString shown = labelNamed(panel, "World coordinate")->text();
        shown.remove(QRegularExpression(QStringLiteral("<[^>]*>"))).remove(QStringLiteral("&nbsp;"));
        QVERIFY2(shown.contains(QStringLiteral("e-13,")) && shown.count(u'e') == 3, qPrintable(shown));
    }

    void whatIsCopiedHasAllDigits()
    {
        ComparisonModel model;
        model.setPick(kept(pickWith({-0.5, 5412349.529786, 1.0 / 3.0}, {-0.5, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-6)));
        QCOMPARE(model.copied(model.index(1, ComparisonModel::Formula)), QStringLiteral("5412349.529786"));
        QCOMPARE(model.copied(model.index(2, ComparisonModel::Formula)), QStringLiteral("0.3333333333333333"));
        QVERIFY(model.text().contains(QStringLiteral("x\t-0.5\t-0.5\t0\t")));
    }

    void eachAxisHasItsOwnUncertainty()
    {
        Pick pick = pickWith({1.23456789, 1.23456789, 1.23456789}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 0.0);
        pick.uncertainty.world = {0.04, 0.0004, 0.000004};
        ComparisonModel model;
        model.setPick(kept(pick));
        QCOMPARE(cell(model, 0, ComparisonModel::Formula).toString(), QStringLiteral("1.235"));
        QCOMPARE(cell(model, 1, ComparisonModel::Formula).toString(), QStringLiteral("1.23457"));
        QCOMPARE(cell(model, 2, ComparisonModel::Formula).toString(), QStringLiteral("1.2345679"));
        QVERIFY(cell(model, 1, ComparisonModel::Formula, Qt::ToolTipRole)
                    .toString()
                    .startsWith(QStringLiteral("1.23456789 ± 0.0004")));
    }

    void digitsDoNotDependOnTheWidth()
    {
        const glm::dvec3 world(4000000.1234567, 500000.456789, 300.789);
        Pick pick = pickWith(world, world, world, 0.0005);
        pick.uncertainty.world.z = 0.02;
        PanelOfPicks panel;
        panel.show();
        panel.setPick(pick);
        const auto text = [&panel](int row, int column) { return cell(panel.model(), row, column).toString(); };
        for (const int width : {panel.minimumSizeHint().width(), 460, 1200}) {
            for (const bool showsMore : {false, true}) {
                panel.setShowsFloat(showsMore);
                panel.setShowsRay(showsMore);
                panel.resize(width, 760);
                static_cast<void>(panel.grab()); // laid out
                for (const int column : {ComparisonModel::Formula, ComparisonModel::Matrix}) {
                    QCOMPARE(text(0, column), QStringLiteral("4000000.12346"));
                    QCOMPARE(text(1, column), QStringLiteral("500000.45679"));
                    QCOMPARE(text(2, column), QStringLiteral("300.789"));
                }
            }
        }
    }

    /// The columns fit too where fourteen digits are wider than fourteen times the whole pixels of one,
    /// as in Chinese fonts.
    void numbersFitTheirColumns()
    {
        const glm::dvec3 at(-3.93308627226, -0.56609392602, -15.5710586906);
        PanelOfPicks panel;
        panel.show();
        auto *table = panel.findChild<CoordinatesTable *>();
        QFont font = table->font();
        font.setLetterSpacing(QFont::AbsoluteSpacing, 0.9);
        table->setFont(font);
        panel.setPick(pickWith(at, at, at, 5e-9));
        const QFontMetricsF metrics(table->font());
        const int margin = table->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, table) + 1;
        for (const int width : {300, 460, 900}) {
            panel.resize(width, 760);
            static_cast<void>(panel.grab()); // laid out
            for (int column = 0; column < ComparisonModel::MatrixInFloat; ++column) {
                for (int row = 0; row < 3; ++row) {
                    const QString text = table->model()->index(row, column).data().toString();
                    QVERIFY2(metrics.horizontalAdvance(text) + 2 * margin <= table->columnWidth(column),
                             qPrintable(QStringLiteral("%1 at %2").arg(text).arg(width)));
                }
            }
        }
    }

    void columnsDoNotShrink()
    {
        PanelOfPicks panel;
        panel.resize(300, 760);
        panel.show();
        auto *table = panel.findChild<CoordinatesTable *>();
        const auto columnWidths = [table] {
            QList<int> widths;
            for (int column = 0; column < ComparisonModel::MatrixInFloat; ++column)
                widths << table->columnWidth(column);
            return widths;
        };
        const glm::dvec3 survey(-4000000.1234567, 500000.456789, 300.789);
        panel.setPick(pickWith({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, 0.1));
        const QList<int> narrow = columnWidths();
        panel.setPick(pickWith(survey, survey, survey, 0.0005));
        const QList<int> wide = columnWidths();
        QVERIFY(wide[0] > narrow[0]);
        panel.setPick(pickWith({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, 0.1));
        QCOMPARE(columnWidths(), wide);
    }

    void greyDigitsCanBeRead_data()
    {
        addColumn<QColor>("ink");
        addColumn<QColor>("base");
        newRow("light") << QColor(Qt::black) << QColor(Qt::white);
        newRow("dark") << QColor(Qt::white) << QColor(0x1e, 0x1e, 0x1e);
        newRow("Breeze") << QColor(0x23, 0x26, 0x29) << QColor(0xfc, 0xfc, 0xfc);
        newRow("Breeze Dark") << QColor(0xfc, 0xfc, 0xfc) << QColor(0x1b, 0x1e, 0x20);
        newRow("selected") << QColor(Qt::white) << QColor(0x30, 0x8c, 0xc6);
    }

    void greyDigitsCanBeRead()
    {
        QFETCH(QColor, ink);
        QFETCH(QColor, base);
        const QColor grey = quietInk(ink, base);
        // An ink that is itself hard to read cannot be made fainter.
        QVERIFY2(contrast(grey, base) >= std::min(kReadableContrast, contrast(ink, base)), qPrintable(grey.name()));
        QVERIFY(contrast(ink, base) <= kReadableContrast || contrast(grey, base) < contrast(ink, base));
        QVERIFY(contrast(grey, base) < kReadableContrast + 0.5 || grey == ink);
        QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21.0) < 1e-9);
        // The delegate draws with it: no text on the base is fainter than that.
        PanelOfPicks panel;
        QPalette colors = panel.palette();
        for (const QPalette::ColorRole role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
            colors.setColor(role, ink);
        for (const QPalette::ColorRole role : {QPalette::Base, QPalette::Window, QPalette::Button})
            colors.setColor(role, base);
        panel.setPalette(colors);
        panel.resize(460, 760);
        panel.setPick(
            pickWith({-2.9999994, 1.27, 1.23456}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 8.0)); // nothing is certain
        static_cast<void>(panel.grab());                                                   // laid out
        auto *table = panel.findChild<CoordinatesTable *>();
        const QRect rect = table->visualRect(table->model()->index(0, ComparisonModel::Formula));
        const QImage cellPicture = table->viewport()->grab(rect.adjusted(2, 2, -3, -3)).toImage();
        double most = 1.0;
        for (int y = 0; y < cellPicture.height(); ++y) {
            for (int x = 0; x < cellPicture.width(); ++x)
                most = std::max(most, contrast(cellPicture.pixelColor(x, y), base));
        }
        // Antialiasing keeps a stem from its full colour; without it the grey is exact.
        QVERIFY2(most >= std::min(kReadableContrast, contrast(ink, base)) * 0.8, qPrintable(QString::number(most)));
        QVERIFY2(most < contrast(ink, base) || contrast(ink, base) <= kReadableContrast, "the cell is all grey");
    }
};

UNPROJECTOR_TEST(TestComparisonDigits)
#include "test_comparison_digits.moc"
