#include "gui/view/drop_labels.h"

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/text/number_text.h"
#include "gui/view/painters/scene_lines.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <optional>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

std::optional<QPointF> widgetOf(const Setup &setup, const WorldPoint &point)
{
    const Result<glm::dmat4> matrix = clipFromWorld(setup);
    const Result<WindowPoint> window = windowFromWorld(setup, point);
    if (!matrix || !window || !((*matrix * glm::dvec4(point.coordinates(), 1.0)).w > 0.0)) // it lies behind the eye
        return std::nullopt;
    const WidgetPoint widget = widgetFromDevice(setup.surface, deviceFromWindow(setup.surface, *window));
    return QPointF(widget.x, widget.y);
}

namespace {

/// The largest share of a way along one axis where a label is still inside the view.
/// @param start, way, view, label  logical pixels; the last two are lengths
double roomAlong(double start, double way, double view, double label)
{
    constexpr double kEdge = 1.0;
    const double end = way > 0.0 ? view - label / 2.0 - kEdge : label / 2.0 + kEdge;
    return way == 0.0 ? 1.0 : std::clamp((end - start) / way, 0.0, 1.0);
}

} // namespace

std::vector<DropLabel> dropLabels(const SceneDocument &document, const QFont &font, const std::vector<QRectF> &taken)
{
    const Picks &picks = document.picks();
    const std::optional<WorldPoint> point = picks.pick() && picks.pick()->hit() ? picks.pickedPoint() : std::nullopt;
    const std::optional<QPointF> start = point ? widgetOf(document.setup(), *point) : std::nullopt;
    std::vector<DropLabel> labels;
    if (!start)
        return labels;
    constexpr int kDigits = 4;
    const WorldVector uncertainty = pickedUncertainty(picks.keptPick());
    const double unit = std::pow(10.0, -decimalsFor(*point, kDigits));
    const QFontMetricsF metrics(font);
    const std::vector<LineSegment> lines = dropLines(*point, document.ground().box);
    constexpr double kMark = 9.0; // half of the pick's mark
    const Surface &surface = document.setup().surface;
    const QRectF view(0.0, 0.0, logicalFromDevice(surface, surface.widthPixels),
                      logicalFromDevice(surface, surface.heightPixels));
    std::vector<QRectF> boxes = taken;
    boxes.emplace_back(*start - QPointF(kMark, kMark), QSizeF(2.0 * kMark, 2.0 * kMark));
    for (int axis = 0; axis < 3; ++axis) {
        const LineSegment &line = lines[static_cast<std::size_t>(axis)];
        const std::optional<QPointF> foot = widgetOf(document.setup(), WorldPoint(line.to));
        if (!foot)
            continue;
        const QPointF way = *foot - *start;
        const QString text = QStringLiteral("%1 %2")
                                 .arg(QStringLiteral("xyz")[axis])
                                 .arg(certainText((*point)[axis], std::max(unit, uncertainty[axis])));
        const QSizeF size(metrics.horizontalAdvance(text) + metrics.height() / 2.0, metrics.height());
        const double length = std::hypot(way.x(), way.y());
        if (length < size.height())
            continue; // the line is hardly visible
        // The label is at the middle of the line, else further along or beyond its foot, where
        // there is room, or as far along as the view reaches: a cut number is another number.
        const double behind = 1.0 + (size.width() / 2.0 + kMark) / length;
        const double reach = std::min(roomAlong(start->x(), way.x(), view.width(), size.width()),
                                      roomAlong(start->y(), way.y(), view.height(), size.height()));
        for (const double share : {0.5, 0.75, 1.0, behind, reach, reach / 2.0}) {
            QRectF box(QPointF(), size);
            box.moveCenter(*start + way * share);
            if (!view.contains(box) || std::any_of(boxes.begin(), boxes.end(), [&box](const QRectF &other) {
                    return other.intersects(box);
                }))
                continue;
            boxes.push_back(box);
            labels.push_back({text, QColor::fromRgbF(line.color.r, line.color.g, line.color.b), box});
            break;
        }
    }
    return labels;
}

void drawDropLabels(QPainter &painter, const std::vector<DropLabel> &labels)
{
    painter.setRenderHint(QPainter::Antialiasing);
    for (const DropLabel &label : labels) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(255, 255, 255, 225)); // axis colours are readable on white, in both themes
        painter.drawRoundedRect(label.box, 3.0, 3.0);
        painter.setPen(label.color.darker(115));
        painter.drawText(label.box, Qt::AlignCenter | Qt::TextSingleLine | Qt::TextDontClip, label.text);
    }
}

} // namespace unprojector::gui
