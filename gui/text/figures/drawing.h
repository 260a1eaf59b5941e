#pragma once

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QString>

#include <vector>

class QPainter;

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
/// and y down, so that a figure grows with its text. Labels are in the markup of FormulaLayout.
class Drawing {
public:
    enum class Stroke { Ink, Quiet, Dashed, Accent, Second, SecondDashed };
    /// The side of a label's anchor that it stands on; Center is on it.
    enum class Side { Center, Left, Right, Above, Below };

    /// @param topLeft  of the figure, in the painter's units
    Drawing(QPainter &painter, const QPointF &topLeft, const QFont &font, const FigureColors &colors);

    void line(const QPointF &from, const QPointF &to, Stroke stroke = Stroke::Ink);
    void path(const std::vector<QPointF> &points, Stroke stroke = Stroke::Ink);
    void outline(std::vector<QPointF> corners, Stroke stroke = Stroke::Ink);
    /// A light tint, that what lies below shows through.
    void area(const std::vector<QPointF> &corners, Stroke stroke = Stroke::Accent);
    void arrow(const QPointF &from, const QPointF &to, Stroke stroke = Stroke::Ink);
    void dot(const QPointF &at, Stroke stroke = Stroke::Ink);
    void label(const QPointF &at, const QString &markup, Side side = Side::Center, Stroke stroke = Stroke::Ink);
    /// How far it is from one point to the other: a line with a head at each end, and its name at the middle.
    void measure(const QPointF &from, const QPointF &to, const QString &markup, Side side);
    /// The sign of 90° at a corner between the ways to two points.
    void rightAngle(const QPointF &corner, const QPointF &one, const QPointF &other);
    /// An arc at a corner between the ways to two points, with its name outside.
    void angle(const QPointF &corner, const QPointF &one, const QPointF &other, double radius, const QString &markup);

private:
    QPointF placed(const QPointF &point) const { return m_topLeft + point * m_em; }
    QColor colorOf(Stroke stroke) const;
    void setPen(Stroke stroke);
    void head(const QPointF &from, const QPointF &to, Stroke stroke);

    QPainter &m_painter;
    QPointF m_topLeft;
    QFont m_font;
    FigureColors m_colors;
    double m_em;
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
