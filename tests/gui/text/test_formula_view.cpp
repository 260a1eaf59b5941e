// The layout of the formulas: fractions on bars, symbols above numbers, terms that are found under
// the pointer.

#include "tests/support/test.h"

#include "gui/text/formula_text.h"
#include "gui/widgets/formula_view.h"

#include "tests/gui/comparison_picks.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QToolTip>

#include <algorithm>

using namespace comparing;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

FormulaLayout laidOut(const char *markup, double width = 1000.0)
{
    FormulaLayout layout(QString::fromUtf8(markup), formulaFont(10.0));
    layout.setWidth(width);
    return layout;
}

QRectF place(const FormulaLayout &layout, const char *term)
{
    const std::vector<QRectF> places = layout.placesOf(QString::fromLatin1(term));
    return places.empty() ? QRectF() : places.front();
}

void moveTo(QWidget &view, const QPointF &position)
{
    QMouseEvent event(QEvent::MouseMove, position, view.mapToGlobal(position), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &event);
}

Pick hugePick()
{
    Setup setup = frustumGeometry();
    setup.projection() = Frustum{-1234567.0, 1234567.0, -987654.0, 987654.0, 123456.0, 98765432.0};
    return picked(setup, 411.0, 299.0, 0.123456789);
}

} // namespace

class TestFormulaView : public QObject {
    Q_OBJECT

private slots:
    void aFractionStandsOnItsBar()
    {
        const FormulaLayout layout = laidOut("<t x>x</t> = {<t a>abc</t> | <t b>d</t>} + <t c>e</t>");
        const QRectF above = place(layout, "a"), below = place(layout, "b"), x = place(layout, "x"),
                     c = place(layout, "c");
        QVERIFY(above.bottom() <= below.top() + 0.5);
        QVERIFY(std::abs(above.center().x() - below.center().x()) < 1.0);
        QVERIFY(x.right() < above.left() && above.right() < c.left());
        // The bar is at the height of the signs.
        QVERIFY(above.bottom() <= x.center().y() + 4.0 && below.top() >= x.center().y() - 4.0);
        QVERIFY(layout.size().height() > 1.6 * x.height());
    }

    void aColumnStandsInOneColumn()
    {
        const FormulaLayout layout = laidOut("{<t x>1</t>; <t y>22</t>; <t z>−3</t>}");
        const QRectF x = place(layout, "x"), y = place(layout, "y"), z = place(layout, "z");
        QVERIFY(x.bottom() <= y.top() + 0.5 && y.bottom() <= z.top() + 0.5);
        QVERIFY(std::abs(x.center().x() - y.center().x()) < 1.0 && std::abs(z.center().x() - y.center().x()) < 1.0);
    }

    void anIndexIsLowered()
    {
        const FormulaLayout layout = laidOut("<t v>v</t><t i><sub>x</sub></t>");
        const QRectF v = place(layout, "v"), i = place(layout, "i");
        QVERIFY(i.height() < v.height() && i.bottom() > v.bottom() - 1.0);
    }

    void aNarrowFormulaIsBrokenBeforeItsSigns()
    {
        const char *markup = "<t x>x</t> = <t a>aaaaaaaaaa</t> + <t b>bbbbbbbbbb</t> × (<t c>cc</t> + <t d>dd</t>)";
        const FormulaLayout wide = laidOut(markup);
        QVERIFY(std::abs(place(wide, "x").center().y() - place(wide, "b").center().y()) < 1.0);
        const FormulaLayout narrow = laidOut(markup, wide.size().width() * 0.7);
        QVERIFY(narrow.size().width() <= wide.size().width() * 0.7);
        QVERIFY(place(narrow, "b").top() >= place(narrow, "a").bottom());
        // The line does not break inside parentheses.
        QCOMPARE(place(narrow, "c").top(), place(narrow, "d").top());
    }

    void whatCannotBeBrokenGetsSmaller()
    {
        const char *markup = "{<t a>1234567890 + 1234567890</t> | 2}";
        const FormulaLayout wide = laidOut(markup);
        const FormulaLayout narrow = laidOut(markup, wide.size().width() * 0.8);
        QVERIFY(narrow.size().width() <= wide.size().width() * 0.8);
        QVERIFY(place(narrow, "a").height() < place(wide, "a").height());
    }

    void everyNumberStandsBelowItsSymbol_data()
    {
        addColumn<Pick>("pick");
        const Ortho box{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0};
        newRow("frustum") << picked(frustumGeometry(), 412.0, 299.0, 0.75);
        newRow("ortho") << picked(boxGeometry(box), 350.0, 120.0, 0.25);
        newRow("oblique") << picked(boxGeometry(Oblique{box, 0.7, 0.9}), 350.0, 120.0, 0.25);
        newRow("background") << picked(frustumGeometry(), 412.0, 299.0, 1.0, false);
    }

    void everyNumberStandsBelowItsSymbol()
    {
        QFETCH(Pick, pick);
        const PickFormulas formulas = formulasOf(pick);
        QVERIFY(!formulas.formulas.empty());
        for (const FormulaWithNumbers &formula : formulas.formulas) {
            const FormulaLayout symbols(formula.symbols(), formulaFont(10.0)),
                numbers(formula.numbers(), formulaFont(10.0));
            int named = 0;
            for (const auto &[id, term] : formulas.terms) {
                QVERIFY2(!term.symbol.isEmpty() && !term.name.isEmpty(), qPrintable(id));
                // Each term occurs in the numbers as often as in the symbols: the result is left in the
                // one and right in the other.
                if (!term.value.isEmpty())
                    QCOMPARE(numbers.placesOf(id).size(), symbols.placesOf(id).size());
                named += symbols.placesOf(id).empty() ? 0 : 1;
            }
            QVERIFY(named >= 3);
            for (const QString &text : {formula.symbols(), formula.numbers(), formula.text()})
                QVERIFY2(!text.contains(u'[') && !text.contains(u'*') && !hasPlaceholder(text), qPrintable(text));
        }
    }

    void theTermUnderThePointerIsMarkedEverywhere()
    {
        FormulaView view;
        view.resize(420, 600);
        view.setFormulas(formulasOf(picked(frustumGeometry(), 412.0, 299.0, 0.75)));
        view.show();
        QVERIFY(view.markedTerm().isEmpty());
        const QImage before = view.grab().toImage();
        const std::vector<QRectF> places = view.placesOf(QStringLiteral("n"));
        // n f / (f (1 - d) + n d), width n, l z / n, height n, b z / n, and their numbers.
        QCOMPARE(places.size(), std::size_t(12));
        for (const QRectF &one : places) {
            moveTo(*view.viewport(), one.center());
            QCOMPARE(view.markedTerm(), QStringLiteral("n"));
        }
        const QImage marked = view.grab().toImage();
        for (const QRectF &one : places) {
            const QRect place(view.viewport()->mapTo(&view, one.topLeft().toPoint()), one.size().toSize());
            if (one.bottom() < view.viewport()->height())
                QVERIFY(marked.copy(place) != before.copy(place));
        }
        // A tooltip with its value and its name.
        QHelpEvent help(QEvent::ToolTip, places.front().center().toPoint(),
                        view.viewport()->mapToGlobal(places.front().center().toPoint()));
        QCoreApplication::sendEvent(view.viewport(), &help);
        QVERIFY2(QToolTip::text().contains(QStringLiteral("n = 2"))
                     && QToolTip::text().contains(QStringLiteral("near plane")),
                 qPrintable(QToolTip::text()));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(view.viewport(), &leave);
        QVERIFY(view.markedTerm().isEmpty());
    }

    void formulasFitTheWidth_data()
    {
        addColumn<int>("width");
        addColumn<double>("points");
        for (const double points : {9.0, 10.0, 11.0, 13.0}) {
            for (const int ems : {45, 55, 70}) {
                QFont font;
                font.setPointSizeF(points);
                addRow("%g pt, %d digits", points, ems)
                    << ems * QFontMetrics(font).horizontalAdvance(u'0') - 12 << points;
            }
        }
    }

    void formulasFitTheWidth()
    {
        QFETCH(int, width);
        QFETCH(double, points);
        FormulaView view;
        QFont font = view.font();
        font.setPointSizeF(points);
        view.setFont(font);
        view.resize(width, 500);
        view.show();
        const Ortho box{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0};
        for (const Pick &pick : {picked(frustumGeometry(), 412.0, 299.0, 0.123456789), hugePick(),
                                 picked(boxGeometry(box), 350.0, 120.0, 0.987654321),
                                 picked(boxGeometry(Oblique{box, 0.7, 0.9}), 350.0, 120.0, 0.25),
                                 picked(frustumGeometry(), 412.0, 299.0, 1.0, false)}) {
            view.setFormulas(formulasOf(pick));
            QCoreApplication::processEvents();
            QVERIFY2(
                view.contentSize().width() <= view.viewport()->width(),
                qPrintable(QStringLiteral("%1 in %2").arg(view.contentSize().width()).arg(view.viewport()->width())));
        }
    }

    void theViewIsAsHighAsItsFormulas()
    {
        FormulaView view;
        view.setFormulas(formulasOf(picked(frustumGeometry(), 412.0, 299.0, 0.75)));
        QVERIFY(view.heightForWidth(260) > view.heightForWidth(420));
        view.resize(420, view.heightForWidth(420));
        view.show();
        QCoreApplication::processEvents();
        QVERIFY(!view.verticalScrollBar()->isVisible());
        double lowest = 0.0;
        for (const QRectF &one : view.placesOf(QStringLiteral("world")))
            lowest = std::max(lowest, one.bottom());
        QVERIFY(lowest > view.viewport()->height() / 2.0 && lowest <= view.viewport()->height());
        QCOMPARE(view.heightForWidth(view.width()), view.height());
        QCOMPARE(view.minimumSizeHint(), FormulaView().minimumSizeHint());
    }

    void colorsFollowThePalette()
    {
        FormulaView view;
        QPalette dark = view.palette();
        dark.setColor(QPalette::Base, QColor(0x20, 0x20, 0x20));
        dark.setColor(QPalette::Text, QColor(0xf0, 0xf0, 0xf0));
        view.setPalette(dark);
        view.resize(420, 600);
        view.setFormulas(formulasOf(picked(frustumGeometry(), 412.0, 299.0, 0.75)));
        const QImage picture = view.viewport()->grab().toImage();
        QCOMPARE(picture.pixelColor(2, 2), QColor(0x20, 0x20, 0x20));
        int lightest = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x)
                lightest = std::max(lightest, picture.pixelColor(x, y).lightness());
        }
        QVERIFY(lightest > 0xd0);
    }
};

UNPROJECTOR_TEST(TestFormulaView)
#include "test_formula_view.moc"
