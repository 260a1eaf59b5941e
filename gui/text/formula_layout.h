#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace unprojector::gui {

/// The serif font of formulas, at the size of the window's text.
QFont formulaFont(double pointSize);

/// A formula typeset in lines of a given width: fractions on their bars, columns in brackets,
/// single letters in italics. The markup is formula_markup's with terms in it, `<t n>…</t>`. Lines
/// break before =, + and −, outside parentheses; if that is not enough, before ×; finally the font
/// gets smaller.
class FormulaLayout {
public:
    FormulaLayout(const QString &markup, const QFont &font);

    /// @param width  logical pixels
    void setWidth(double width);
    QSizeF size() const { return m_size; }
    /// The rectangles covered by letters and bars, one each: italics extend beyond their advance.
    std::vector<QRectF> inkRects() const;

    struct Colors {
        QColor ink;
        QColor mark; ///< behind the term
    };
    /// @param marked  a term, marked wherever it occurs; empty: none
    void paint(QPainter &painter, const QPointF &topLeft, const Colors &colors, const QString &marked) const;
    /// The innermost term at a position, relative to the top left; empty if there is none.
    QString termAt(const QPointF &position) const;
    /// The rectangles of all occurrences of a term, for tests and tooltips.
    std::vector<QRectF> placesOf(const QString &term) const;

    struct Box {
        enum class Kind { Text, Row, Fraction, Column };
        Kind kind = Kind::Row;
        QString text;
        QFont font;
        QString term;
        std::vector<Box> parts;
        QPointF origin; ///< start of the baseline, in the enclosing box
        double width = 0.0, ascent = 0.0, descent = 0.0;
        double axis = 0.0; ///< height of fractions' bars above the baseline
        enum class Break { No, Late, Early };
        Break breakBefore = Break::No;

        QRectF rect() const { return {origin.x(), origin.y() - ascent, width, ascent + descent}; }
    };

private:
    void build(double scale);
    /// @return the widest line
    double breakLines(double width, bool isLate);

    QString m_markup;
    QFont m_font;
    Box m_whole;              ///< as parsed
    std::vector<Box> m_lines; ///< of m_whole
    QSizeF m_size;
};

} // namespace unprojector::gui
