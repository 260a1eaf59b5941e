#include "gui/pipeline/viewport_drawing.h"

#include "core/geometry/proportions.h"
#include "gui/text/number_text.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
namespace {

constexpr double kGap = 6.0; ///< between the drawings and around texts, logical pixels
constexpr double kDotRadius = 3.0;
const QColor kPointerColor(214, 64, 32);

QString limitText(double value, int digits = 4)
{
    return writtenText(value, digits).replace(u'-', u'−');
}

/// The limits of an interval with as many digits as fit side by side, at most four.
std::pair<QString, QString> limitTexts(double low, double high, const QFontMetricsF &metrics, double width)
{
    for (int digits = 4; digits > 1; --digits) {
        auto texts = std::pair(limitText(low, digits), limitText(high, digits));
        if (metrics.horizontalAdvance(texts.first) + metrics.horizontalAdvance(texts.second) + kGap <= width)
            return texts;
    }
    return {limitText(low, 1), limitText(high, 1)};
}

/// The longest text of a limit with few digits.
double longestLimit(const QFontMetricsF &metrics)
{
    return metrics.horizontalAdvance(QStringLiteral("−8.8e+88"));
}

/// The largest rectangle with this aspect in the middle of an area.
QRectF fitted(const QSizeF &size, const QRectF &area)
{
    QRectF rect(QPointF(0.0, 0.0), size.scaled(area.size(), Qt::KeepAspectRatio));
    rect.moveCenter(area.center());
    return rect;
}

QColor faded(QColor color, double alpha)
{
    color.setAlphaF(static_cast<float>(alpha));
    return color;
}

/// The share of width and height for the circle in the projection window: as large as fits well.
QSizeF circleShare(const ProjectionWindow &w)
{
    constexpr double kFill = 0.7;
    const double width = std::abs(w.right - w.left), height = std::abs(w.top - w.bottom);
    const double diameter = kFill * std::min(width, height);
    return {diameter / width, diameter / height};
}

QRectF circleIn(const QRectF &rect, const QSizeF &share)
{
    QRectF circle(0.0, 0.0, rect.width() * share.width(), rect.height() * share.height());
    circle.moveCenter(rect.center());
    return circle;
}

/// The position at shares of the width from the left and of the height from the bottom.
QPointF atShare(const QRectF &rect, double x, double y)
{
    return {rect.left() + x * rect.width(), rect.bottom() - y * rect.height()};
}

} // namespace

ViewportDrawing::ViewportDrawing(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Window, viewport and projection window to scale"));
    setToolTip(tr("Left: the window with the viewport in it, to scale in device pixels.\nRight: the projection window, "
                  "to scale in eye units, with the lines x = 0 and y = 0.\nThe dot is the pointer. The viewport shows "
                  "how the circle of the projection window is stretched."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ViewportDrawing::setSetup(const Setup &setup)
{
    m_geometry = setup;
    m_still = {};
    const Surface &s = setup.surface;
    const Viewport &v = setup.viewport;
    const ProjectionWindow w = projectionWindow(setup.projection());
    setAccessibleDescription(
        tr("Window %1 × %2; viewport from (%3, %4), %5 × %6; projection window from %7 to %8 and from %9 to %10")
            .arg(s.widthPixels)
            .arg(s.heightPixels)
            .arg(v.x)
            .arg(v.y)
            .arg(v.width)
            .arg(v.height)
            .arg(limitText(w.left), limitText(w.right), limitText(w.bottom))
            .arg(limitText(w.top)));
    update();
}

void ViewportDrawing::setPointer(const std::optional<WindowPoint> &pointer)
{
    update(pointerRegion());
    m_pointer = pointer;
    update(pointerRegion());
}

QSize ViewportDrawing::sizeHint() const
{
    return minimumSizeHint() + QSize(8 * fontMetrics().horizontalAdvance(u'0'), 3 * fontMetrics().height());
}

QSize ViewportDrawing::minimumSizeHint() const
{
    // Two limits side by side in each half.
    const double half = 2.0 * longestLimit(fontMetrics()) + kGap + 2.0;
    return {static_cast<int>(std::ceil(2.0 * half + 2.0 * kGap)), 7 * fontMetrics().height()};
}

double ViewportDrawing::captionHeight() const
{
    return fontMetrics().height() + 2.0;
}

void ViewportDrawing::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_still = {};
}

void ViewportDrawing::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    m_still = {};
}

void ViewportDrawing::paintStill()
{
    m_still = QPixmap(size() * devicePixelRatio());
    m_still.setDevicePixelRatio(devicePixelRatio());
    m_still.fill(Qt::transparent);
    QPainter painter(&m_still);
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    const double half = (width() - 2.0 * kGap) / 2.0;
    m_windowRect = paintWindow(painter, QRectF(0.0, 0.0, half, height()));
    m_projectionRect = paintProjectionWindow(painter, QRectF(half + 2.0 * kGap, 0.0, half, height()));
}

void ViewportDrawing::paintEvent(QPaintEvent *)
{
    if (m_still.isNull() || m_still.devicePixelRatio() != devicePixelRatio())
        paintStill();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_still);
    if (!m_pointer)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintPointer(painter, m_windowRect, pointerInWindow());
    paintPointer(painter, m_projectionRect, pointerInProjectionWindow());
}

QPointF ViewportDrawing::pointerInWindow() const
{
    return atShare(m_windowRect, m_pointer->x / m_geometry.surface.widthPixels,
                   m_pointer->y / m_geometry.surface.heightPixels);
}

QPointF ViewportDrawing::pointerInProjectionWindow() const
{
    const glm::dvec2 share = proportions(m_geometry, *m_pointer).share;
    return atShare(m_projectionRect, share.x, share.y);
}

QRegion ViewportDrawing::pointerRegion() const
{
    if (!m_pointer)
        return {};
    const auto cross = [](const QRectF &rect, const QPointF &position) {
        if (!rect.contains(position))
            return QRegion();
        constexpr double kReach = kDotRadius + 1.0;
        const QRectF across(rect.left() - kReach, position.y() - kReach, rect.width() + 2.0 * kReach, 2.0 * kReach);
        const QRectF along(position.x() - kReach, rect.top() - kReach, 2.0 * kReach, rect.height() + 2.0 * kReach);
        return QRegion(across.toAlignedRect()) + QRegion(along.toAlignedRect());
    };
    return cross(m_windowRect, pointerInWindow()) + cross(m_projectionRect, pointerInProjectionWindow());
}

QRectF ViewportDrawing::paintWindow(QPainter &painter, const QRectF &area) const
{
    const Surface &s = m_geometry.surface;
    const Viewport &v = m_geometry.viewport;
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(area.topLeft(), QSizeF(area.width(), captionHeight())), Qt::AlignHCenter | Qt::AlignTop,
                     tr("Window"));

    // The viewport may extend beyond the window: both are shown.
    const QRectF window(0.0, 0.0, s.widthPixels, s.heightPixels);
    const QRectF viewport(v.x, flippedY(s, v.y + v.height), v.width, v.height);
    const QRectF both = window.united(viewport);
    const QRectF drawn = fitted(both.size(), area.adjusted(1.0, captionHeight(), -1.0, -captionHeight()));
    const double scale = drawn.width() / both.width();
    const auto placed = [&](const QRectF &rect) {
        return QRectF(drawn.topLeft() + (rect.topLeft() - both.topLeft()) * scale, rect.size() * scale);
    };
    const QRectF windowRect = placed(window), viewportRect = placed(viewport);
    painter.fillRect(windowRect, palette().color(QPalette::Base));
    painter.fillRect(viewportRect, faded(palette().color(QPalette::Highlight), 0.22));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.drawEllipse(circleIn(viewportRect, circleShare(projectionWindow(m_geometry.projection()))));
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.drawRect(windowRect);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.drawRect(viewportRect);

    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(area.left(), drawn.bottom() + 2.0, area.width(), captionHeight()),
                     Qt::AlignHCenter | Qt::AlignTop, QStringLiteral("%1 × %2").arg(s.widthPixels).arg(s.heightPixels));
    return windowRect;
}

QRectF ViewportDrawing::paintProjectionWindow(QPainter &painter, const QRectF &area) const
{
    const ProjectionWindow w = projectionWindow(m_geometry.projection());
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(area.topLeft(), QSizeF(area.width(), captionHeight())), Qt::AlignHCenter | Qt::AlignTop,
                     fontMetrics().horizontalAdvance(tr("Projection window")) <= area.width() ? tr("Projection window")
                                                                                              : tr("Projection"));

    // Room for the limits at the right and below, of one width, so that the drawing does not jump.
    const double numberWidth = longestLimit(fontMetrics()) + 4.0;
    const QRectF free = area.adjusted(1.0, captionHeight(), -numberWidth, -captionHeight());
    const QRectF rect = fitted({std::abs(w.right - w.left), std::abs(w.top - w.bottom)}, free);
    painter.fillRect(rect, faded(palette().color(QPalette::Highlight), 0.22));
    painter.setPen(QPen(faded(palette().color(QPalette::WindowText), 0.3), 1.0));
    const double zeroX = -w.left / (w.right - w.left), zeroY = -w.bottom / (w.top - w.bottom);
    if (zeroX > 0.0 && zeroX < 1.0)
        painter.drawLine(atShare(rect, zeroX, 0.0), atShare(rect, zeroX, 1.0));
    if (zeroY > 0.0 && zeroY < 1.0)
        painter.drawLine(atShare(rect, 0.0, zeroY), atShare(rect, 1.0, zeroY));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.drawEllipse(circleIn(rect, circleShare(w)));
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.drawRect(rect);

    painter.setPen(palette().color(QPalette::WindowText));
    // A narrow window has its limits beside it instead of overlapping.
    const auto [left, right] = limitTexts(w.left, w.right, fontMetrics(), area.width());
    const double leftWidth = fontMetrics().horizontalAdvance(left), rightWidth = fontMetrics().horizontalAdvance(right);
    const double overlap = std::max(0.0, leftWidth + rightWidth + kGap - rect.width());
    const double leftEdge = std::clamp(rect.left() - overlap / 2.0, area.left(),
                                       std::max(area.left(), area.right() - leftWidth - kGap - rightWidth));
    const double rightEdge = std::max(rect.right() + overlap / 2.0, leftEdge + leftWidth + kGap + rightWidth);
    const double ascent = fontMetrics().ascent();
    const double bottomLine = std::max(rect.bottom() - 1.0, rect.top() + captionHeight() + ascent);
    const double belowLine = std::max(rect.bottom() + 2.0 + ascent, bottomLine + captionHeight());
    painter.drawText(QPointF(leftEdge, belowLine), left);
    painter.drawText(QPointF(rightEdge - rightWidth, belowLine), right);
    const auto beside = [&](double value) {
        return limitTexts(value, value, fontMetrics(), 2.0 * (area.right() - rect.right() - 4.0) + kGap).first;
    };
    painter.drawText(QPointF(rect.right() + 4.0, rect.top() + ascent - 1.0), beside(w.top));
    painter.drawText(QPointF(rect.right() + 4.0, bottomLine), beside(w.bottom));
    return rect;
}

void ViewportDrawing::paintPointer(QPainter &painter, const QRectF &within, const QPointF &position) const
{
    if (!within.contains(position))
        return;
    painter.setPen(QPen(faded(kPointerColor, 0.6), 1.0));
    painter.drawLine(QPointF(within.left(), position.y()), QPointF(within.right(), position.y()));
    painter.drawLine(QPointF(position.x(), within.top()), QPointF(position.x(), within.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPointerColor);
    painter.drawEllipse(position, kDotRadius, kDotRadius);
}

} // namespace unprojector::gui
