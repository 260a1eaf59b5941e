#include "gui/text/figures/drawing.h"

#include "gui/text/formula_layout.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

/// In heights of the type.
constexpr double kStroke = 0.07;
constexpr double kHeadLength = 0.55, kHeadWidth = 0.36;
constexpr double kDotRadius = 0.17;
constexpr double kLabelGap = 0.22;
constexpr double kRightAngle = 0.5;

constexpr float kTint = 0.16F;

QColor mixed(const QColor &one, const QColor &other, double share)
{
    const auto part = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
    return {part(one.red(), other.red()), part(one.green(), other.green()), part(one.blue(), other.blue())};
}

/// In the direction of the other point, as long as is wanted.
QPointF towards(const QPointF &from, const QPointF &to, double length)
{
    const double distance = QLineF(from, to).length();
    return from + (to - from) * (distance > 0.0 ? length / distance : 0.0);
}

} // namespace

FigureColors FigureColors::of(const QColor &text, const QColor &link, const QColor &paper)
{
    const bool isDark = paper.lightnessF() < 0.5F;
    return {text, mixed(text, paper, 0.4), link, isDark ? QColor(0xf2, 0xa5, 0x5c) : QColor(0xb4, 0x4f, 0x12), paper};
}

QPointF between(const QPointF &from, const QPointF &to, double share)
{
    return from + (to - from) * share;
}

QString figures::text(const char *markup)
{
    return QString::fromUtf8(markup);
}

std::vector<QPointF> figures::rectangle(double left, double top, double right, double bottom)
{
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

Drawing::Drawing(QPainter &painter, const QPointF &topLeft, const QFont &font, const FigureColors &colors)
    : m_painter(painter), m_topLeft(topLeft), m_font(font), m_colors(colors), m_em(QFontMetricsF(font).height())
{
    m_painter.setRenderHint(QPainter::Antialiasing);
}

QColor Drawing::colorOf(Stroke stroke) const
{
    switch (stroke) {
    case Stroke::Ink: return m_colors.ink;
    case Stroke::Quiet:
    case Stroke::Dashed: return m_colors.quiet;
    case Stroke::Accent: return m_colors.accent;
    case Stroke::Second:
    case Stroke::SecondDashed: return m_colors.second;
    }
    Q_UNREACHABLE();
}

void Drawing::setPen(Stroke stroke)
{
    const bool isThin = stroke == Stroke::Quiet || stroke == Stroke::Dashed;
    QPen pen(colorOf(stroke), (isThin ? 0.7 : stroke == Stroke::Accent ? 1.3 : 1.0) * kStroke * m_em);
    pen.setCapStyle(Qt::FlatCap);
    pen.setJoinStyle(Qt::RoundJoin);
    if (stroke == Stroke::Dashed || stroke == Stroke::SecondDashed)
        pen.setDashPattern({5.0, 3.5});
    m_painter.setPen(pen);
    m_painter.setBrush(Qt::NoBrush);
}

void Drawing::line(const QPointF &from, const QPointF &to, Stroke stroke)
{
    setPen(stroke);
    m_painter.drawLine(placed(from), placed(to));
}

void Drawing::path(const std::vector<QPointF> &points, Stroke stroke)
{
    setPen(stroke);
    QPolygonF line;
    for (const QPointF &point : points)
        line << placed(point);
    m_painter.drawPolyline(line);
}

void Drawing::outline(std::vector<QPointF> corners, Stroke stroke)
{
    corners.push_back(corners.front());
    path(corners, stroke);
}

void Drawing::area(const std::vector<QPointF> &corners, Stroke stroke)
{
    QColor tint = colorOf(stroke);
    tint.setAlphaF(kTint);
    QPolygonF polygon;
    for (const QPointF &corner : corners)
        polygon << placed(corner);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(tint);
    m_painter.drawPolygon(polygon);
}

void Drawing::head(const QPointF &from, const QPointF &to, Stroke stroke)
{
    const QPointF base = towards(to, from, kHeadLength);
    const QPointF along = towards({}, to - from, kHeadWidth / 2.0);
    const QPointF across(-along.y(), along.x());
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(colorOf(stroke));
    m_painter.drawPolygon(QPolygonF() << placed(to) << placed(base + across) << placed(base - across));
}

void Drawing::arrow(const QPointF &from, const QPointF &to, Stroke stroke)
{
    line(from, towards(to, from, 0.8 * kHeadLength), stroke);
    head(from, to, stroke);
}

void Drawing::dot(const QPointF &at, Stroke stroke)
{
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(colorOf(stroke));
    m_painter.drawEllipse(placed(at), kDotRadius * m_em, kDotRadius * m_em);
}

void Drawing::label(const QPointF &at, const QString &markup, Side side, Stroke stroke)
{
    const FormulaLayout text(markup, m_font);
    const QSizeF size = text.size();
    const double gap = kLabelGap * m_em;
    QPointF corner = placed(at) - QPointF(size.width() / 2.0, size.height() / 2.0);
    switch (side) {
    case Side::Center: break;
    case Side::Left: corner.rx() -= size.width() / 2.0 + gap; break;
    case Side::Right: corner.rx() += size.width() / 2.0 + gap; break;
    case Side::Above: corner.ry() -= size.height() / 2.0; break;
    case Side::Below: corner.ry() += size.height() / 2.0; break;
    }
    text.paint(m_painter, corner, {colorOf(stroke), {}}, {});
}

void Drawing::measure(const QPointF &from, const QPointF &to, const QString &markup, Side side)
{
    const QPointF middle = between(from, to, 0.5);
    arrow(middle, from, Stroke::Quiet);
    arrow(middle, to, Stroke::Quiet);
    label(middle, markup, side);
}

void Drawing::rightAngle(const QPointF &corner, const QPointF &one, const QPointF &other)
{
    const QPointF first = towards(corner, one, kRightAngle), second = towards(corner, other, kRightAngle);
    path({first, first + second - corner, second}, Stroke::Quiet);
}

void Drawing::angle(const QPointF &corner, const QPointF &one, const QPointF &other, double radius,
                    const QString &markup)
{
    // Counted counter-clockwise, as QLineF and QPainterPath do.
    const double start = QLineF(corner, one).angle();
    double sweep = QLineF(corner, one).angleTo(QLineF(corner, other));
    constexpr double kHalfTurn = 180.0, kTurn = 360.0;
    if (sweep > kHalfTurn)
        sweep -= kTurn;
    const QPointF center = placed(corner);
    const double r = radius * m_em;
    const QRectF circle(center.x() - r, center.y() - r, 2.0 * r, 2.0 * r);
    QPainterPath arc;
    arc.arcMoveTo(circle, start);
    arc.arcTo(circle, start, sweep);
    setPen(Stroke::Quiet);
    m_painter.drawPath(arc);
    label(corner + QLineF::fromPolar(radius + 0.65, start + sweep / 2.0).p2(), markup);
}

} // namespace unprojector::gui
