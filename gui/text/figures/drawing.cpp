#include "gui/text/figures/drawing.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

/// Lengths in multiples of the font height.
constexpr double kStroke = 0.07;
constexpr double kHeadLength = 0.55, kHeadWidth = 0.36;
constexpr double kDotRadius = 0.17;
constexpr double kLabelGap = 0.22;
/// The least distances of a label's ink from the middle of a line, and from another label's ink.
constexpr double kLineRoom = 0.08, kLabelRoom = 0.45;
constexpr double kRightAngle = 0.5;

constexpr float kTint = 0.16F;

QColor mixed(const QColor &one, const QColor &other, double share)
{
    const auto part = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
    return {part(one.red(), other.red()), part(one.green(), other.green()), part(one.blue(), other.blue())};
}

/// A vector in the direction of the other point, with this length.
QPointF towards(const QPointF &from, const QPointF &to, double length)
{
    const double distance = QLineF(from, to).length();
    return from + (to - from) * (distance > 0.0 ? length / distance : 0.0);
}

/// The direction from a label's anchor to its side; none for Center.
QPointF wayOf(Drawing::Side side)
{
    switch (side) {
    case Drawing::Side::Center: return {};
    case Drawing::Side::Left: return {-1.0, 0.0};
    case Drawing::Side::Right: return {1.0, 0.0};
    case Drawing::Side::Above: return {0.0, -1.0};
    case Drawing::Side::Below: return {0.0, 1.0};
    }
    Q_UNREACHABLE();
}

/// Moves to try in order, the least disturbing first: short moves, and moves that keep a label on
/// its side of the anchor.
std::vector<QPointF> movesOf(Drawing::Side side)
{
    constexpr double kStep = 0.05, kTurn = 360.0;
    constexpr int kSteps = 31, kWays = 24;
    const QPointF away = wayOf(side);
    const auto costOf = [&away](const QPointF &move) {
        return std::hypot(move.x(), move.y()) - 0.5 * QPointF::dotProduct(away, move);
    };
    std::vector<QPointF> moves;
    for (int step = 1; step <= kSteps; ++step) {
        for (int way = 0; way < kWays; ++way)
            moves.push_back(QLineF::fromPolar(step * kStep, way * kTurn / kWays).p2());
    }
    std::stable_sort(moves.begin(), moves.end(),
                     [&](const QPointF &one, const QPointF &other) { return costOf(one) < costOf(other); });
    return moves;
}

/// Returns whether a part of the line lies in the rectangle.
bool isIn(const QRectF &rect, const QLineF &line)
{
    // Clipped by each pair of edges (Liang and Barsky).
    double from = 0.0, to = 1.0;
    const auto clip = [&](double start, double way, double low, double high) {
        if (way == 0.0)
            return start > low && start < high;
        const double one = (low - start) / way, other = (high - start) / way;
        from = std::max(from, std::min(one, other));
        to = std::min(to, std::max(one, other));
        return from < to;
    };
    return clip(line.x1(), line.dx(), rect.left(), rect.right())
           && clip(line.y1(), line.dy(), rect.top(), rect.bottom());
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

Drawing::Drawing(QPainter &painter, const QRectF &place, const QFont &font, const FigureColors &colors)
    : m_painter(painter), m_place(place), m_font(font), m_colors(colors), m_em(QFontMetricsF(font).height())
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
    avoid(QPolygonF() << placed(from) << placed(to));
}

void Drawing::path(const std::vector<QPointF> &points, Stroke stroke)
{
    setPen(stroke);
    QPolygonF line;
    for (const QPointF &point : points)
        line << placed(point);
    m_painter.drawPolyline(line);
    avoid(line);
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
    const QPolygonF triangle({placed(to), placed(base + across), placed(base - across), placed(to)});
    m_painter.drawPolygon(triangle);
    avoid(triangle);
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
    const double radius = kDotRadius * m_em;
    m_painter.drawEllipse(placed(at), radius, radius);
    avoid(QRectF(placed(at) - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius)));
}

void Drawing::label(const QPointF &at, const QString &markup, Side side, Stroke stroke)
{
    const FormulaLayout text(markup, m_font);
    const QSizeF size = text.size();
    const QPointF away = wayOf(side);
    const double gap = kLabelGap * m_em;
    const QPointF corner = placed(at) - QPointF(size.width() / 2.0, size.height() / 2.0)
                           + QPointF(away.x() * (size.width() / 2.0 + gap), away.y() * size.height() / 2.0);
    m_labels.push_back({text, text.inkRects(), corner, side, stroke});
}

void Drawing::avoid(const QPolygonF &line)
{
    for (qsizetype i = 1; i < line.size(); ++i)
        m_lines.emplace_back(line[i - 1], line[i]);
}

bool Drawing::isClear(const Label &label, const QPointF &corner) const
{
    const double room = kLineRoom * m_em, edge = kStroke * m_em;
    const QRectF inside = m_place.adjusted(edge, edge, -edge, -edge);
    return std::all_of(label.ink.begin(), label.ink.end(), [&](const QRectF &rect) {
        const QRectF ink = rect.translated(corner), around = ink.adjusted(-room, -room, room, room);
        return inside.contains(ink)
               && std::none_of(m_lines.begin(), m_lines.end(),
                               [&around](const QLineF &line) { return isIn(around, line); })
               && std::none_of(m_labels.begin(), m_labels.end(),
                               [&](const Label &other) { return &other != &label && isBeside(ink, other); });
    });
}

bool Drawing::isBeside(const QRectF &ink, const Label &other) const
{
    // Closer words look like one label.
    const double apart = kLabelRoom * m_em, room = kLineRoom * m_em;
    const QRectF around = ink.adjusted(-apart, -room, apart, room);
    return std::any_of(other.ink.begin(), other.ink.end(),
                       [&](const QRectF &rect) { return around.intersects(rect.translated(other.corner)); });
}

void Drawing::paintLabels()
{
    for (Label &label : m_labels) {
        if (!isClear(label, label.corner)) {
            const std::vector<QPointF> moves = movesOf(label.side);
            const auto found = std::find_if(moves.begin(), moves.end(), [&](const QPointF &move) {
                return isClear(label, label.corner + move * m_em);
            });
            if (found != moves.end())
                label.corner += *found * m_em;
        }
        label.text.paint(m_painter, label.corner, {colorOf(label.stroke), {}}, {});
    }
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
    avoid(arc.toSubpathPolygons().value(0));
    label(corner + QLineF::fromPolar(radius + 0.65, start + sweep / 2.0).p2(), markup);
}

} // namespace unprojector::gui
