#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace unprojector::gui {

/// The serif that formulas are set in, at the size of the window's text.
QFont formulaFont(double pointSize);

/// A formula set in lines of a width: fractions on their bars, columns in brackets, single letters in italics. The markup is
/// that of formula_markup with terms in it, `<t n>…</t>`. Lines are broken before =, + and −, outside parentheses; where
/// that is not enough before ×, and then the type gets smaller.
class FormulaLayout {
public:
    FormulaLayout(const QString &markup, const QFont &font);

    /// @param width  logical pixels
    void setWidth(double width);
    QSizeF size() const { return m_size; }
    /// What the letters and bars cover, one rectangle each: italics reach beyond their advance.
    std::vector<QRectF> inkRects() const;

    struct Colors {
        QColor ink;
        QColor mark; ///< behind the term
    };
    /// @param marked  a term, all over the formula; empty: none
    void paint(QPainter &painter, const QPointF &topLeft, const Colors &colors, const QString &marked) const;
    /// The innermost term at a position, counted from the top left; empty where there is none.
    QString termAt(const QPointF &position) const;
    /// All of a term's places, for tests and tooltips.
    std::vector<QRectF> placesOf(const QString &term) const;

    struct Box {
        enum class Kind { Text, Row, Fraction, Column };
        Kind kind = Kind::Row;
        QString text;
        QFont font;
        QString term;
        std::vector<Box> parts;
        QPointF origin; ///< of the baseline's start in the box around it
        double width = 0.0, ascent = 0.0, descent = 0.0;
        double axis = 0.0; ///< of fractions' bars above the baseline
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
    Box m_whole;              ///< what was read
    std::vector<Box> m_lines; ///< of it
    QSizeF m_size;
};

} // namespace unprojector::gui
