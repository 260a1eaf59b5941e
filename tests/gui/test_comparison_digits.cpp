// Which digits of a coordinate the comparison shows as certain, which are grey, and how many there are.

#include "gui/click/comparison_model.h"
#include "gui/click/comparison_panel.h"
#include "gui/widgets/contrast.h"

#include "comparison_picks.h"

#include <QCheckBox>
#include <QTableView>
#include <QTest>

#include <cmath>

using namespace comparing;
using namespace unprojector::gui;

class TestComparisonDigits : public QObject {
    Q_OBJECT

private slots:
    void certainDigitsAreRoundedThenGrey_data();
    void certainDigitsAreRoundedThenGrey();
    void whatIsBlackAgreesWithWhatIsCertain();
    void allThatIsCertainIsShownWhereThereIsRoom_data();
    void allThatIsCertainIsShownWhereThereIsRoom();
    void whatIsCopiedHasAllDigits();
    void eachAxisHasItsOwnUncertainty();
    void coordinatesOfASurveyCanBeReadAtAnyWidth();
    void signsFitWhereDigitsAreNoWholeNumberOfPixels();
    void theFirstDigitsGiveWay_data();
    void theFirstDigitsGiveWay();
    void greyDigitsCanBeRead_data();
    void greyDigitsCanBeRead();
};

void TestComparisonDigits::certainDigitsAreRoundedThenGrey_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("uncertainty");
    QTest::addColumn<QString>("rounded");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("black");
    const auto row = [](const char *name, double x, double uncertainty, const char *rounded, const char *text,
                        const char *black) {
        QTest::newRow(name) << x << uncertainty << QString::fromLatin1(rounded) << QString::fromLatin1(text)
                            << QString::fromLatin1(black);
    };
    row("to a hundredth", 1.25, 0.004, "1.25", "1.250000000000000", "1.25");
    row("exactly a hundredth", 1.25, 0.01, "1.25", "1.250000000000000", "1.25");
    row("to a tenth", 1.23, 0.05, "1.2", "1.230000000000000", "1.2");
    // Black down to the certain place, whether or not what follows rounds its digit up.
    row("nearly -3", -2.9999994, 0.05, "-3.0", "-2.999999400000000", "-2.9");
    row("rounded up", 1.27, 0.05, "1.3", "1.270000000000000", "1.2");
    row("rounded up in the next place too", 1.97, 0.05, "2.0", "1.970000000000000", "1.9");
    row("rounded up to the place before its digits", 7.25, 5.0, "10", "7.250000000000000", "7");
    row("the same of a negative", -7.25, 5.0, "-10", "-7.250000000000000", "-7");
    row("less than its uncertainty", 1.25, 1.5, "0", "1.250000000000000", "");
    row("nothing but the uncertainty", 0.004, 0.05, "0.0", "0.004000000000000", "0.0");
    row("negative", -3.5, 0.004, "-3.50", "-3.500000000000000", "-3.50");
    row("no uncertainty", 1.25, 0.0, "1.25", "1.250000000000000", "1.250000000000000");
    row("finer than a double", 1.25, 1e-25, "1.25", "1.250000000000000", "1.250000000000000");
    row("thousands", 1234.5, 0.04, "1234.5", "1234.500000000000", "1234.5");
    row("hundreds that may be off", 1234.5, 30.0, "1200", "1234.500000000000", "12");
    row("hundreds, rounded up", 1274.5, 30.0, "1300", "1274.500000000000", "12");
    row("small", 0.00121, 0.00004, "0.0012", "0.001210000000000", "0.0012");
    row("tiny", 1.234e-12, 3e-15, "1.23e-12", "1.23400000000e-12", "1.23");
    row("tiny, rounded up", -1.237e-12, 3e-15, "-1.24e-12", "-1.23700000000e-12", "-1.23");
    row("huge", 1.25e20, 1e12, "1.25e+20", "1.25000000000e+20", "1.25000000");
}

void TestComparisonDigits::certainDigitsAreRoundedThenGrey()
{
    QFETCH(double, x);
    QFETCH(double, uncertainty);
    QFETCH(QString, rounded);
    QFETCH(QString, text);
    QFETCH(QString, black);
    ComparisonModel model;
    model.setPick(pickWith({x, 0.0, 0.0}, {x, 0.0, 0.0}, {x, 0.0, 0.0}, uncertainty));
    QCOMPARE(cell(model, 0, ComparisonModel::Certain).toString(), rounded);
    QCOMPARE(cell(model, 0, ComparisonModel::Formula).toString(), text);
    const int length = cell(model, 0, ComparisonModel::Formula, ComparisonModel::kCertainLengthRole).toInt();
    QCOMPARE(text.left(length), black);
    QCOMPARE(cell(model, 0, ComparisonModel::Matrix, ComparisonModel::kCertainLengthRole).toInt(), length);
    // A number that is a difference has no certain part.
    QVERIFY(!cell(model, 0, ComparisonModel::Difference, ComparisonModel::kCertainLengthRole).isValid());
    const QString inFloat = cell(model, 0, ComparisonModel::MatrixInFloat).toString();
    QVERIFY(inFloat.size() <= text.size());
    QVERIFY(cell(model, 0, ComparisonModel::MatrixInFloat, ComparisonModel::kCertainLengthRole).toInt()
            <= inFloat.size());
}

void TestComparisonDigits::whatIsBlackAgreesWithWhatIsCertain()
{
    // In every room that a column may have: black ends at the place that the certain number is rounded to.
    ComparisonModel model;
    for (const double x :
         {-2.9999994, 0.034999, 1.0 / 3.0, 99.96, 1999.9, 12345.678, -0.00099996, 4.5e-9, 4000000.1234}) {
        for (const double uncertainty : {std::abs(x) * 1e-6, std::abs(x) * 2e-3, std::abs(x) * 0.04}) {
            for (const int capacity : {8, 9, 12, 19}) {
                model.setPick(pickWith({x, 0.0, 0.0}, {x, 0.0, 0.0}, {x, 0.0, 0.0}, uncertainty));
                model.setCapacity(capacity);
                const QString text = cell(model, 0, ComparisonModel::Formula).toString();
                QVERIFY2(text.size() <= capacity, qPrintable(text));
                const int length =
                    cell(model, 0, ComparisonModel::Formula, ComparisonModel::kCertainLengthRole).toInt();
                QString certain = cell(model, 0, ComparisonModel::Certain).toString();
                const bool isCut = certain.endsWith(u'…');
                certain.remove(u'…');
                QVERIFY2(length > 0, qPrintable(certain)); // all of these round to something
                const QString power = text.contains(u'e') ? text.mid(text.indexOf(u'e')) : QString();
                const qsizetype mantissa = text.size() - power.size();
                qsizetype last = length - 1;
                while (!text[last].isDigit())
                    --last;
                QString unit = text.left(mantissa);
                for (qsizetype i = 0; i < unit.size(); ++i) {
                    if (unit[i].isDigit())
                        unit[i] = i == last ? u'1' : u'0';
                }
                const double place = std::abs((unit + power).toDouble());
                const QString context = QStringLiteral("%1 of %2, certain %3").arg(text.left(length), text, certain);
                // Where all that stands beside is black, more may be certain than there is room for beside, or less than
                // there is room for in its own column.
                const bool isAllBlack = length >= mantissa;
                const double off = std::abs(certain.toDouble() - (isAllBlack ? x : std::round(x / place) * place));
                const double lastShown = std::pow(10.0, double(certain.indexOf(u'.') + 1 - certain.size()));
                const double most = isAllBlack ? std::max(0.5 * place, isCut ? lastShown : 0.0)
                                    : isCut    ? lastShown
                                    : certain.size() < ComparisonModel::kCertainRoom ? 1e-6 * place
                                                                                     : 1e-7 * std::abs(x);
                QVERIFY2(off <= most * (1.0 + 1e-9), qPrintable(context));
            }
        }
    }
}

void TestComparisonDigits::allThatIsCertainIsShownWhereThereIsRoom_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("uncertainty");
    QTest::addColumn<QString>("certain");
    const auto row = [](const char *name, double x, double uncertainty, const char *certain) {
        QTest::newRow(name) << x << uncertainty << QString::fromUtf8(certain);
    };
    // The columns of the methods have room for six decimals of these.
    row("of a small scan", 0.00903634, 1.4e-8, "0.0090363");
    row("negative", -0.00903634, 1.4e-8, "-0.0090363");
    row("its last ones are zeros", 0.0090000004, 1.4e-9, "0.00900000");
    row("as many as there is room for", 0.123456789, 1e-9, "0.123456789");
    row("more than there is room for", -0.123456789, 1e-9, "-0.1234567…");
    row("more, the last one a zero", -0.123456701, 1e-9, "-0.1234567…");
    row("more, before the point", -123456.78904, 1e-6, "-123456.78…");
    row("tiny", 1.23456789e-12, 1e-20, "1.23457e-12");
    row("nothing is uncertain", 1.0 / 3.0, 0.0, "0.33333333…");
    row("on a map", 5412349.529786, 1e-6, "5412349.52…");
}

void TestComparisonDigits::allThatIsCertainIsShownWhereThereIsRoom()
{
    QFETCH(double, x);
    QFETCH(double, uncertainty);
    QFETCH(QString, certain);
    ComparisonModel model;
    model.setPick(pickWith({x, 0.0, 0.0}, {x, 0.0, 0.0}, {x, 0.0, 0.0}, uncertainty));
    for (const int capacity : {8, 12, 19}) {
        model.setCapacity(capacity);
        QCOMPARE(cell(model, 0, ComparisonModel::Certain).toString(), certain);
    }
}

/// Zeros that are certain are digits too.
void TestComparisonDigits::whatIsCopiedHasAllDigits()
{
    ComparisonModel model;
    model.setPick(pickWith({-0.5, 5412349.529786, 1.0 / 3.0}, {-0.5, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-6));
    QCOMPARE(model.copied(model.index(0, ComparisonModel::Certain)), QStringLiteral("-0.500000"));
    QCOMPARE(model.copied(model.index(1, ComparisonModel::Certain)), QStringLiteral("5412349.529786"));
    QCOMPARE(model.copied(model.index(2, ComparisonModel::Formula)), QStringLiteral("0.3333333333333333"));
    QVERIFY(model.text().contains(QStringLiteral("\t-0.500000\t-0.5\t-0.5\t")));
}

void TestComparisonDigits::eachAxisHasItsOwnUncertainty()
{
    Pick pick = pickWith({1.23456789, 1.23456789, 1.23456789}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 0.0);
    pick.uncertainty.world = {0.04, 0.0004, 0.000004};
    ComparisonModel model;
    model.setPick(pick);
    QCOMPARE(cell(model, 0, ComparisonModel::Certain).toString(), QStringLiteral("1.2"));
    QCOMPARE(cell(model, 1, ComparisonModel::Certain).toString(), QStringLiteral("1.235"));
    QCOMPARE(cell(model, 2, ComparisonModel::Certain).toString(), QStringLiteral("1.23457"));
    QVERIFY(cell(model, 1, ComparisonModel::Certain, Qt::ToolTipRole)
                .toString()
                .startsWith(QStringLiteral("1.235 ± 0.0004")));
}

void TestComparisonDigits::coordinatesOfASurveyCanBeReadAtAnyWidth()
{
    const glm::dvec3 world(4000000.1234567, 500000.456789, 300.789);
    Pick pick = pickWith(world, world, world, 0.0005);
    pick.uncertainty.world.z = 0.02;
    const Pick nearZero = pickWith({1.5, 2.5, 3.5}, {1.5, 2.5, 3.5}, {1.5, 2.5, 3.5}, 0.0005);
    PanelOfPicks panel;
    panel.show();
    auto *table = panel.findChild<QTableView *>();
    for (const int width : {panel.minimumSizeHint().width(), 460, 1200}) {
        for (const bool showsFloat : {false, true}) {
            panel.findChild<QCheckBox *>()->setChecked(showsFloat);
            panel.setPick(nearZero);
            panel.resize(width, 760);
            static_cast<void>(panel.grab()); // laid out
            panel.setPick(pick);
            const auto text = [table](int row, int column) {
                return table->model()->index(row, column).data().toString();
            };
            for (const int column : {ComparisonModel::Formula, ComparisonModel::Matrix}) {
                // Down to the thousandths; what there is no room for is left out in front of them.
                const QString first = text(0, column), second = text(1, column);
                QVERIFY2(first.startsWith(QStringLiteral("4000000.123"))
                             || first
                                    == QStringLiteral("…%1").arg(QStringLiteral("4000000.123").right(first.size() - 1)),
                         qPrintable(first));
                QVERIFY2(second.startsWith(QStringLiteral("500000.45"))
                             || second
                                    == QStringLiteral("…%1").arg(QStringLiteral("500000.457").right(second.size() - 1)),
                         qPrintable(second));
                QVERIFY2(first.endsWith(QStringLiteral(".123")) || first.size() > 11, qPrintable(first));
                QVERIFY2(text(2, column).startsWith(QStringLiteral("300.789")), qPrintable(text(2, column)));
                for (int row = 0; row < 3; ++row)
                    QVERIFY(table->fontMetrics().horizontalAdvance(text(row, column)) <= table->columnWidth(column));
            }
            QCOMPARE(text(0, ComparisonModel::Certain), QStringLiteral("4000000.123"));
            QCOMPARE(text(1, ComparisonModel::Certain), QStringLiteral("500000.457"));
            QCOMPARE(text(2, ComparisonModel::Certain), QStringLiteral("300.8"));
            QVERIFY(!text(0, ComparisonModel::MatrixInFloat).contains(u'e'));
        }
    }
}

/// As those of Chinese fonts: fourteen digits are then wider than fourteen times the whole pixels of one.
void TestComparisonDigits::signsFitWhereDigitsAreNoWholeNumberOfPixels()
{
    const glm::dvec3 at(-3.93308627226, -0.56609392602, -15.5710586906);
    const Pick pick = pickWith(at, at, at, 5e-9);
    PanelOfPicks panel;
    panel.show();
    auto *table = panel.findChild<QTableView *>();
    QFont font = table->font();
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.9);
    table->setFont(font);
    const QFontMetricsF metrics(table->font());
    const int margin = table->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, table) + 1;
    for (const int width : {440, 460, 480, 500}) {
        panel.resize(width, 760);
        static_cast<void>(panel.grab()); // laid out
        panel.setPick(pick);
        for (const int column : {ComparisonModel::Certain, ComparisonModel::Formula, ComparisonModel::Matrix}) {
            for (int row = 0; row < 3; ++row) {
                const QString text = table->model()->index(row, column).data().toString();
                QVERIFY2(text.startsWith(u'-'), qPrintable(text));
                QVERIFY2(metrics.horizontalAdvance(text) + 2 * margin <= table->columnWidth(column),
                         qPrintable(QStringLiteral("%1 at %2").arg(text).arg(width)));
            }
        }
    }
}

void TestComparisonDigits::theFirstDigitsGiveWay_data()
{
    QTest::addColumn<double>("formula");
    QTest::addColumn<double>("matrix");
    QTest::addColumn<double>("uncertainty");
    QTest::addColumn<QString>("byFormula");
    QTest::addColumn<QString>("byMatrix");
    const auto row = [](const char *name, double formula, double matrix, double off, const char *a, const char *b) {
        QTest::newRow(name) << formula << matrix << off << QString::fromUtf8(a) << QString::fromUtf8(b);
    };
    row("millimetres of a survey", 4000000.5331, 4000000.5342, 0.0005, "…000.533", "…000.534");
    row("negative", -4000000.5331, -4000000.5342, 0.0005, "-…00.533", "-…00.534");
    row("centimetres are certain", 4000000.5331, 4000000.5342, 0.006, "…0000.53", "…0000.53");
    row("nothing is uncertain", 4000000.5331, 4000000.5331, 0.0, "…000.533", "…000.533");
    row("metres are certain", 4000000.5331, 4000000.5342, 0.6, "4000001", "4000001");
    row("there is room", 400.5331, 400.5342, 0.0005, "400.533", "400.534");
    // What the first digits differ in is not left out; what only carries into them is.
    row("far apart", 4000000.5331, 4002000.5331, 0.0005, "…000.533", "4002001");
    row("a carry", 4000999.9999, 4001000.0004, 0.0005, "…000.000", "…000.000");
    row("a carry of thousandths", 4000999.999, 4001000.001, 0.0005, "…999.999", "4001000");
}

void TestComparisonDigits::theFirstDigitsGiveWay()
{
    QFETCH(double, formula);
    QFETCH(double, matrix);
    QFETCH(double, uncertainty);
    QFETCH(QString, byFormula);
    QFETCH(QString, byMatrix);
    ComparisonModel model;
    model.setCapacity(8);
    model.setPick(pickWith({formula, 0.0, 0.0}, {matrix, 0.0, 0.0}, {matrix, 0.0, 0.0}, uncertainty));
    QCOMPARE(cell(model, 0, ComparisonModel::Formula).toString(), byFormula);
    QCOMPARE(cell(model, 0, ComparisonModel::Matrix).toString(), byMatrix);
    if (!byFormula.contains(u'…'))
        return;
    // All of it is certain, and the whole number is said where the pointer rests.
    QCOMPARE(cell(model, 0, ComparisonModel::Formula, ComparisonModel::kCertainLengthRole).toInt(),
             int(byFormula.size()));
    QVERIFY(cell(model, 0, ComparisonModel::Formula, Qt::ToolTipRole)
                .toString()
                .startsWith(QString::number(formula, 'f', QLocale::FloatingPointShortest)));
}

void TestComparisonDigits::greyDigitsCanBeRead_data()
{
    QTest::addColumn<QColor>("ink");
    QTest::addColumn<QColor>("base");
    QTest::newRow("light") << QColor(Qt::black) << QColor(Qt::white);
    QTest::newRow("dark") << QColor(Qt::white) << QColor(0x1e, 0x1e, 0x1e);
    QTest::newRow("Breeze") << QColor(0x23, 0x26, 0x29) << QColor(0xfc, 0xfc, 0xfc);
    QTest::newRow("Breeze Dark") << QColor(0xfc, 0xfc, 0xfc) << QColor(0x1b, 0x1e, 0x20);
    QTest::newRow("selected") << QColor(Qt::white) << QColor(0x30, 0x8c, 0xc6);
}

void TestComparisonDigits::greyDigitsCanBeRead()
{
    QFETCH(QColor, ink);
    QFETCH(QColor, base);
    const QColor grey = quietInk(ink, base);
    // Of ink that is itself hard to read nothing can be taken away.
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
    panel.setPick(pickWith({-2.9999994, 1.27, 1.23456}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 8.0)); // nothing is certain
    static_cast<void>(panel.grab());                                                             // laid out
    auto *table = panel.findChild<QTableView *>();
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

QTEST_MAIN(TestComparisonDigits)
#include "test_comparison_digits.moc"
