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

/// The colours of a figure, taken from the page around it.
struct FigureColors {
    QColor ink;
    QColor quiet;  ///< axes, measures, auxiliary lines
    QColor accent; ///< the subject of the figure
    QColor second; ///< what the subject is compared with
    QColor paper;

    /// @param link  contrasts with the text
    static FigureColors of(const QColor &text, const QColor &link, const QColor &paper);
};

/// Lines, arrows and labels of a figure. Coordinates are in multiples of the font height, so that a
/// figure grows with its text: from the top left corner, x to the right and y down. Labels use the
/// markup of FormulaLayout. They wait for paintLabels(): width and slant of letters depend on the
/// font, so free positions are known only after all lines.
class Drawing {
public:
    enum class Stroke { Ink, Quiet, Dashed, Accent, Second, SecondDashed };
    /// The side of its anchor on which a label stands; Center is on it.
    enum class Side { Center, Left, Right, Above, Below };

    /// @param place  the figure's rectangle, in the painter's units
    Drawing(QPainter &painter, const QRectF &place, const QFont &font, const FigureColors &colors);

    void line(const QPointF &from, const QPointF &to, Stroke stroke = Stroke::Ink);
    void path(const std::vector<QPointF> &points, Stroke stroke = Stroke::Ink);
    void outline(std::vector<QPointF> corners, Stroke stroke = Stroke::Ink);
    /// A light, transparent tint.
    void area(const std::vector<QPointF> &corners, Stroke stroke = Stroke::Accent);
    void arrow(const QPointF &from, const QPointF &to, Stroke stroke = Stroke::Ink);
    void dot(const QPointF &at, Stroke stroke = Stroke::Ink);
    /// @param side  preferred direction for a label that has to move
    void label(const QPointF &at, const QString &markup, Side side = Side::Center, Stroke stroke = Stroke::Ink);
    /// A dimension line: with an arrow head at each end, and its name at the middle.
    void measure(const QPointF &from, const QPointF &to, const QString &markup, Side side);
    /// The sign of 90° at a corner between the directions to two points.
    void rightAngle(const QPointF &corner, const QPointF &one, const QPointF &other);
    /// An arc at a corner between the directions to two points, with its name outside.
    void angle(const QPointF &corner, const QPointF &one, const QPointF &other, double radius, const QString &markup);
    /// Moves each label off all lines and other labels, by the shortest way, and paints them.
    void paintLabels();

private:
    struct Label {
        FormulaLayout text;
        std::vector<QRectF> ink; ///< relative to its corner
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
    std::vector<QLineF> m_lines; ///< drawn so far, in the painter's units
    std::vector<Label> m_labels;
};

/// A point on the line between two others: 0 at the first, 1 at the second.
QPointF between(const QPointF &from, const QPointF &to, double share);

namespace figures {

/// A label's markup, which is the same in all languages, in UTF-8.
QString text(const char *markup);
/// The corners of a rectangle, clockwise from the upper left one.
std::vector<QPointF> rectangle(double left, double top, double right, double bottom);

} // namespace figures
} // namespace unprojector::gui
