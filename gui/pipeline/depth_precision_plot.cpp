#include "gui/pipeline/depth_precision_plot.h"

#include "gui/text/number_text.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::gui {
using namespace unproject;

namespace {

constexpr double kGap = 4.0; ///< logical pixels
constexpr double kMarkRadius = 4.0;

/// A power of ten as an axis label.
QString tickText(double value)
{
    return significantText(value, 1).replace(u'-', u'−');
}

} // namespace

/// The mapping of distances and errors to the widget.
struct DepthPrecisionPlot::Axes {
    QRectF area;
    bool isLogarithmic = true;       ///< along x
    double first = 1.0, last = 10.0; ///< distances
    int lowest = -7, highest = 0;    ///< decades of errors

    double shareOf(double distance) const
    {
        return isLogarithmic ? std::log(distance / first) / std::log(last / first)
                             : (distance - first) / (last - first);
    }
    double distanceAt(double share) const
    {
        return isLogarithmic ? first * std::pow(last / first, share) : first + share * (last - first);
    }
    QPointF at(double distance, double error) const
    {
        const double up = (std::log10(error) - lowest) / (highest - lowest);
        return {area.left() + shareOf(distance) * area.width(), area.bottom() - up * area.height()};
    }
};

DepthPrecisionPlot::DepthPrecisionPlot(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Error of a rounded depth over the distance"));
    setToolTip(tr("Across: the distance in front of the eye, from the near to the far plane.\nUp: the error that "
                  "rounding the depth causes along the view, ±.\nBoth in the scene's units. The circle is the clicked "
                  "point. A click's ± also contains the errors of drawing."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void DepthPrecisionPlot::show(std::vector<Curve> curves, const std::optional<double> &marked)
{
    m_curves = std::move(curves);
    m_marked = marked;
    update();
}

QSize DepthPrecisionPlot::sizeHint() const
{
    return {44 * fontMetrics().horizontalAdvance(u'0'), 13 * fontMetrics().height()};
}

QSize DepthPrecisionPlot::minimumSizeHint() const
{
    return {26 * fontMetrics().horizontalAdvance(u'0'), 10 * fontMetrics().height()};
}

DepthPrecisionPlot::Axes DepthPrecisionPlot::axes() const
{
    Axes axes;
    const DepthScale &scale = m_curves.front().scale;
    axes.isLogarithmic = scale.nearDistance > 0.0;
    axes.first = scale.nearDistance;
    constexpr double kFarEnough = 1e3; // for a far plane at infinity
    axes.last = std::isinf(scale.farDistance) ? kFarEnough * scale.nearDistance : scale.farDistance;
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const Curve &curve : m_curves) {
        for (const double distance : {std::max(axes.first, curve.scale.nearDistance), axes.last}) {
            const double error = halfDepthStepAt(curve.scale, curve.format, distance);
            least = std::min(least, error);
            most = std::max(most, error);
        }
    }
    axes.lowest = static_cast<int>(std::floor(std::log10(least)));
    axes.highest = std::max(axes.lowest + 1, static_cast<int>(std::ceil(std::log10(most))));
    // The error of reversed floats approaches 0 at the far plane; the curve may leave the plot
    // below.
    constexpr int kMostDecades = 8;
    axes.lowest = std::max(axes.lowest, axes.highest - kMostDecades);
    // Numbers beside the axis, and a line of them and the axis' name below.
    const QFontMetricsF metrics(font());
    double widest = 0.0;
    for (int decade = axes.lowest; decade <= axes.highest; ++decade)
        widest = std::max(widest, metrics.horizontalAdvance(tickText(std::pow(10.0, decade))));
    axes.area = QRectF(rect()).adjusted(widest + 2.0 * kGap, namePlaces().back().y() + metrics.height() + kGap,
                                        -2.0 * kGap, -2.0 * metrics.height() - 2.0 * kGap);
    return axes;
}

QPen DepthPrecisionPlot::penOf(std::size_t index) const
{
    // Blue and orange are distinguishable with every kind of colour vision; these are bright enough
    // on both backgrounds.
    constexpr std::array kStyles{Qt::SolidLine, Qt::DashLine, Qt::DotLine};
    const bool isDark = palette().color(QPalette::Base).lightnessF() < 0.5F;
    const std::array colors{palette().color(QPalette::Text),
                            isDark ? QColor(0x6a, 0xb0, 0xf0) : QColor(0x0a, 0x5f, 0xb0),
                            isDark ? QColor(0xf0, 0xa0, 0x50) : QColor(0xb0, 0x50, 0x00)};
    QPen pen(colors.at(index), 2.0, kStyles.at(index));
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

void DepthPrecisionPlot::paintAxes(QPainter &painter, const Axes &axes) const
{
    const QFontMetricsF metrics(font());
    const QRectF &area = axes.area;
    QColor grid = palette().color(QPalette::Text);
    grid.setAlphaF(0.15F);
    const QColor ink = palette().color(QPalette::WindowText);
    // The decades that have room for their numbers.
    const int decades = axes.highest - axes.lowest;
    const int step = std::max(1, static_cast<int>(std::ceil(decades * 1.3 * metrics.height() / area.height())));
    for (int decade = axes.lowest; decade <= axes.highest; decade += step) {
        const double value = std::pow(10.0, decade), y = axes.at(axes.last, value).y();
        painter.setPen(grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(ink);
        painter.drawText(QRectF(0.0, y - metrics.height() / 2.0, area.left() - kGap, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, tickText(value));
    }
    // The ends, and numbers between them that fit.
    std::vector<double> ticks{axes.first, axes.last};
    if (axes.isLogarithmic) {
        for (int decade = static_cast<int>(std::ceil(std::log10(axes.first))); std::pow(10.0, decade) < axes.last;
             ++decade)
            ticks.push_back(std::pow(10.0, decade));
    } else if (axes.first < 0.0 && axes.last > 0.0) {
        ticks.push_back(0.0);
    }
    std::vector<QRectF> taken;
    const double top = area.bottom() + kGap;
    for (const double tick : ticks) {
        const QString text = writtenText(tick, 3).replace(u'-', u'−');
        const double x = area.left() + axes.shareOf(tick) * area.width(),
                     width = metrics.horizontalAdvance(text) + kGap;
        QRectF place(x - width / 2.0, top, width, metrics.height());
        place.moveLeft(std::clamp(place.left(), 0.0, std::max(0.0, this->width() - width)));
        painter.setPen(grid);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        if (std::any_of(taken.begin(), taken.end(), [&place](const QRectF &other) { return other.intersects(place); }))
            continue;
        taken.push_back(place);
        painter.setPen(ink);
        painter.drawText(place, Qt::AlignCenter, text);
    }
    painter.drawText(QRectF(0.0, top + metrics.height(), width(), metrics.height()), Qt::AlignCenter,
                     metrics.elidedText(tr("distance in front of the eye, scene units"), Qt::ElideRight, width()));
    painter.drawText(QRectF(kGap, 0.0, width() - kGap, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(tr("± along the view, scene units"), Qt::ElideRight, width() - kGap));
    painter.setPen(ink);
    painter.drawRect(area);
}

void DepthPrecisionPlot::paintCurve(QPainter &painter, const Axes &axes, std::size_t index) const
{
    const Curve &curve = m_curves[index];
    QPainterPath path;
    const int points = std::max(2, static_cast<int>(axes.area.width()));
    for (int i = 0; i <= points; ++i) {
        const double distance = axes.distanceAt(static_cast<double>(i) / points);
        if (distance < curve.scale.nearDistance)
            continue;
        const QPointF at = axes.at(distance, halfDepthStepAt(curve.scale, curve.format, distance));
        if (!std::isfinite(at.y()))
            continue;
        if (path.elementCount() == 0)
            path.moveTo(at);
        else
            path.lineTo(at);
    }
    painter.setPen(penOf(index));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

void DepthPrecisionPlot::paintMark(QPainter &painter, const Axes &axes) const
{
    if (!m_marked || *m_marked < axes.first || *m_marked > axes.last)
        return;
    const Curve &curve = m_curves.front();
    const QPointF at = axes.at(*m_marked, halfDepthStepAt(curve.scale, curve.format, *m_marked));
    painter.setPen(QPen(palette().color(QPalette::Text), 1.0, Qt::DotLine));
    painter.drawLine(QPointF(axes.area.left(), at.y()), at);
    painter.drawLine(at, QPointF(at.x(), axes.area.bottom()));
    painter.setPen(QPen(palette().color(QPalette::Text), 2.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(at, kMarkRadius, kMarkRadius);
}

/// Side by side above the curves, in as many lines as needed.
std::vector<QPointF> DepthPrecisionPlot::namePlaces() const
{
    const QFontMetricsF metrics(font());
    std::vector<QPointF> places;
    QPointF at(kGap, metrics.height());
    for (const Curve &curve : m_curves) {
        const double needed = sampleWidth() + metrics.horizontalAdvance(curve.name) + 4.0 * kGap;
        if (at.x() > kGap && at.x() + needed > width())
            at = {kGap, at.y() + metrics.height()};
        places.push_back(at);
        at.rx() += needed;
    }
    return places;
}

double DepthPrecisionPlot::sampleWidth() const
{
    return 3.0 * QFontMetricsF(font()).horizontalAdvance(u'0');
}

void DepthPrecisionPlot::paintNames(QPainter &painter) const
{
    const QFontMetricsF metrics(font());
    const std::vector<QPointF> places = namePlaces();
    for (std::size_t index = 0; index < m_curves.size(); ++index) {
        const QPointF at = places[index];
        const double middle = at.y() + metrics.height() / 2.0, text = at.x() + sampleWidth() + kGap;
        painter.setPen(penOf(index));
        painter.drawLine(QPointF(at.x(), middle), QPointF(at.x() + sampleWidth(), middle));
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRectF(text, at.y(), width() - text, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(m_curves[index].name, Qt::ElideRight, width() - text));
    }
}

void DepthPrecisionPlot::paintEvent(QPaintEvent *)
{
    if (m_curves.empty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    const Axes axes = this->axes();
    painter.fillRect(axes.area, palette().color(QPalette::Base));
    paintAxes(painter, axes);
    paintNames(painter);
    painter.setClipRect(axes.area.adjusted(-1.0, -1.0, 1.0, 1.0));
    for (std::size_t index = m_curves.size(); index-- > 0;)
        paintCurve(painter, axes, index);
    paintMark(painter, axes);
}

} // namespace unprojector::gui
