#pragma once

#include "gui/text/formula_layout.h"

#include <QColor>
#include <QFont>
#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;
class QPolygonF;

namespace unprojector::gui {

/// What a figure is drawn with, those of the page around it.
struct FigureColors {
    QColor ink;
    QColor quiet;  ///< axes, measures, what is only a help
    QColor accent; ///< what the figure is about
    QColor second; ///< what it is compared with
    QColor paper;

    /// @param link  stands out from the text
    static FigureColors of(const QColor &text, const QColor &link, const QColor &paper);
};

/// Lines, arrows and lettering of a figure. Coordinates are in heights of its type from the top left corner, x to the right
/// and y down, so that a figure grows with its text. Labels are in the markup of FormulaLayout. They wait for paintLabels():
/// how wide and slanted letters are depends on the font, so a label stands clear only when all lines are known.
class Drawing {
public:
    enum class Stroke { Ink, Quiet, Dashed, Accent, Second, SecondDashed };
    /// The side of a label's anchor that it stands on; Center is on it.
    enum class Side { Center, Left, Right, Above, Below };

    /// @param place  of the figure, in the painter's units
    Drawing(QPainter &painter, const QRectF &place, const QFont &font, const FigureColors &colors);

    void line(const QPointF &from, const QPointF &to, Stroke stroke = Stroke::Ink);
    void path(const std::vector<QPointF> &points, Stroke stroke = Stroke::Ink);
    void outline(std::vector<QPointF> corners, Stroke stroke = Stroke::Ink);
    /// A light tint, that what lies below shows through.
    void area(const std::vector<QPointF> &corners, Stroke stroke = Stroke::Accent);
    void arrow(const QPointF &from, const QPointF &to, Stroke stroke = Stroke::Ink);
    void dot(const QPointF &at, Stroke stroke = Stroke::Ink);
    /// @param side  a label that has to move prefers this way
    void label(const QPointF &at, const QString &markup, Side side = Side::Center, Stroke stroke = Stroke::Ink);
    /// How far it is from one point to the other: a line with a head at each end, and its name at the middle.
    void measure(const QPointF &from, const QPointF &to, const QString &markup, Side side);
    /// The sign of 90° at a corner between the ways to two points.
    void rightAngle(const QPointF &corner, const QPointF &one, const QPointF &other);
    /// An arc at a corner between the ways to two points, with its name outside.
    void angle(const QPointF &corner, const QPointF &one, const QPointF &other, double radius, const QString &markup);
    /// Moves each label off all lines and other labels, as little as that takes, and paints them.
    void paintLabels();

private:
    struct Label {
        FormulaLayout text;
        std::vector<QRectF> ink; ///< from its corner
        QPointF corner;
        Side side;
        Stroke stroke;
    };

    QPointF placed(const QPointF &point) const { return m_place.topLeft() + point * m_em; }
    QColor colorOf(Stroke stroke) const;
    void setPen(Stroke stroke);
    void head(const QPointF &from, const QPointF &to, Stroke stroke);
    void avoid(const QPolygonF &line);
    bool isClear(const Label &label, const QPointF &corner) const;
    bool isBeside(const QRectF &ink, const Label &other) const;

    QPainter &m_painter;
    QRectF m_place;
    QFont m_font;
    FigureColors m_colors;
    double m_em;
    std::vector<QLineF> m_lines; ///< those drawn, in the painter's units
    std::vector<Label> m_labels;
};

/// A point of the line between two others: 0 at the first, 1 at the second.
QPointF between(const QPointF &from, const QPointF &to, double share);

namespace figures {

/// A label's markup that is the same in all languages, in UTF-8.
QString text(const char *markup);
/// Its corners, from the upper left one clockwise.
std::vector<QPointF> rectangle(double left, double top, double right, double bottom);

} // namespace figures
} // namespace unprojector::gui
