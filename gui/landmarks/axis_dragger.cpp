#include "gui/landmarks/axis_dragger.h"

#include "core/geometry/camera_motion.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr double kLengthLogical = 58.0;

const std::array<QColor, 3> kColors{QColor(0xe8, 0x4c, 0x3d), QColor(0x5c, 0xc2, 0x3a), QColor(0x4a, 0x90, 0xff)};

WorldVector unitOf(int axis)
{
    WorldVector unit;
    unit[axis] = 1.0;
    return unit;
}

std::optional<QPointF> seenAt(const Setup &setup, const WorldPoint &point)
{
    const Result<glm::dmat4> matrix = clipFromWorld(setup);
    if (!matrix)
        return std::nullopt;
    const glm::dvec4 clip = *matrix * glm::dvec4(point.coordinates(), 1.0);
    if (!(clip.w > 0.0))
        return std::nullopt;
    const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
    const DevicePoint at =
        deviceFromWindow(setup.surface, windowFromNdc(setup.viewport, setup.depthRange, ndc, ndcDepthOf(setup)));
    const WidgetPoint widget = widgetFromDevice(setup.surface, at);
    return QPointF(widget.x, widget.y);
}

double lengthOf(const QPointF &way)
{
    return std::hypot(way.x(), way.y());
}

} // namespace

std::array<AxisArrow, 3> axisArrows(const Setup &setup, const WorldPoint &point)
{
    constexpr double kLeastLogical = 14.0;
    std::array<AxisArrow, 3> arrows;
    const double length = kLengthLogical * worldPerLogicalPixel(setup, point);
    const std::optional<QPointF> from = seenAt(setup, point);
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<QPointF> to = seenAt(setup, point + unitOf(axis) * length);
        if (from && to)
            arrows[static_cast<std::size_t>(axis)] = {*from, *to, lengthOf(*to - *from) >= kLeastLogical};
    }
    return arrows;
}

std::optional<int> axisUnder(const std::array<AxisArrow, 3> &arrows, const QPointF &pointer)
{
    constexpr double kReach = 6.0, kFromPoint = 12.0;
    std::optional<int> nearest;
    double least = kReach;
    for (int axis = 0; axis < 3; ++axis) {
        const AxisArrow &arrow = arrows[static_cast<std::size_t>(axis)];
        if (!arrow.isUsable)
            continue;
        const QPointF way = arrow.to - arrow.from, off = pointer - arrow.from;
        const double length = lengthOf(way);
        const double along = QPointF::dotProduct(way, off) / length;
        const double beside = std::abs(way.x() * off.y() - way.y() * off.x()) / length;
        if (along >= kFromPoint && along <= length + kReach && beside <= least) {
            least = beside;
            nearest = axis;
        }
    }
    return nearest;
}

std::optional<double> wayAlong(const WorldPoint &point, int axis, const ray::Ray<WorldSpace> &ray)
{
    const WorldVector unit = unitOf(axis), along = normalized(ray.along), between = ray.from - point;
    const double across = dot(unit, along);
    const double square = 1.0 - across * across; // of the sine of the angle
    constexpr double kLeast = 1e-4;
    if (!(square > kLeast))
        return std::nullopt;
    return (dot(unit, between) - across * dot(along, between)) / square;
}

void drawAxes(QPainter &painter, const std::array<AxisArrow, 3> &arrows, std::optional<int> dragged)
{
    painter.setRenderHint(QPainter::Antialiasing);
    for (int axis = 0; axis < 3; ++axis) {
        const AxisArrow &arrow = arrows[static_cast<std::size_t>(axis)];
        if (!arrow.isUsable || (dragged && *dragged != axis))
            continue;
        const QPointF way = (arrow.to - arrow.from) / lengthOf(arrow.to - arrow.from), aside(-way.y(), way.x());
        constexpr double kHead = 10.0, kHalf = 4.5, kGap = 10.0;
        const QPointF neck = arrow.to - way * kHead;
        const QPolygonF head({arrow.to, neck + aside * kHalf, neck - aside * kHalf});
        const QColor color = kColors[static_cast<std::size_t>(axis)];
        painter.setPen(QPen(QColor(0x18, 0x1a, 0x1c), 4.5));
        painter.setBrush(QColor(0x18, 0x1a, 0x1c));
        painter.drawLine(arrow.from + way * kGap, neck);
        painter.drawPolygon(head);
        painter.setPen(QPen(color, 2.0));
        painter.setBrush(color);
        painter.drawLine(arrow.from + way * kGap, neck);
        painter.setPen(Qt::NoPen);
        painter.drawPolygon(head);
    }
}

} // namespace unprojector::gui
