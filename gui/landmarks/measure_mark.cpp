#include "gui/landmarks/measure_mark.h"

#include "gui/document/scene_curves.h"

#include <QPainter>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

using Shape = ShownMeasure::Shape;

/// World lines in the view.
class Drawing {
public:
    explicit Drawing(const Setup &setup) : m_setup(setup), m_clipFromWorld(clipFromWorld(setup)) {}

    std::optional<QPointF> seen(const glm::dvec3 &point) const
    {
        if (!m_clipFromWorld)
            return std::nullopt;
        const glm::dvec4 clip = *m_clipFromWorld * glm::dvec4(point, 1.0);
        if (!(clip.w > 0.0))
            return std::nullopt;
        const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
        const DevicePoint device = deviceFromWindow(
            m_setup.surface, windowFromNdc(m_setup.viewport, m_setup.depthRange, ndc, ndcDepthOf(m_setup)));
        const WidgetPoint widget = widgetFromDevice(m_setup.surface, device);
        return QPointF(widget.x, widget.y);
    }
    void add(const glm::dvec3 &from, const glm::dvec3 &to)
    {
        const std::optional<QPointF> a = seen(from), b = seen(to);
        if (a && b)
            m_lines.emplace_back(*a, *b);
    }
    void addImage(const glm::dvec3 &image)
    {
        if (const std::optional<QPointF> at = seen(image))
            m_images.push_back(*at);
    }
    void addPlane(const std::array<WorldPoint, 4> &corners)
    {
        QPolygonF polygon;
        for (const WorldPoint &corner : corners) {
            if (const std::optional<QPointF> at = seen(corner.coordinates()))
                polygon << *at;
        }
        if (polygon.size() == static_cast<qsizetype>(corners.size()))
            m_plane = polygon;
    }
    MeasureMark take() { return {std::move(m_lines), std::move(m_plane), std::move(m_images), {}}; }

private:
    const Setup &m_setup;
    Result<glm::dmat4> m_clipFromWorld;
    std::vector<QLineF> m_lines;
    QPolygonF m_plane;
    std::vector<QPointF> m_images;
};

/// Adds both legs of an angle, and an arc between them.
/// @return the middle of the arc
glm::dvec3 addAngle(Drawing &drawing, const std::vector<glm::dvec3> &at)
{
    constexpr int kSteps = 24;
    constexpr double kShare = 0.35; // of the shorter leg
    const glm::dvec3 a = at[1] - at[0], c = at[2] - at[0];
    drawing.add(at[0], at[1]);
    drawing.add(at[0], at[2]);
    const double radius = kShare * std::min(glm::length(a), glm::length(c));
    const glm::dvec3 from = glm::normalize(a), other = glm::normalize(c);
    const glm::dvec3 side = other - glm::dot(from, other) * from;
    if (!(glm::length(side) > 0.0))
        return at[0] + radius * from;
    const double angle = std::atan2(glm::length(side), glm::dot(from, other));
    const auto onArc = [&](double share) {
        return at[0] + radius * (std::cos(share * angle) * from + std::sin(share * angle) * glm::normalize(side));
    };
    for (int i = 0; i < kSteps; ++i)
        drawing.add(onArc(double(i) / kSteps), onArc(double(i + 1) / kSteps));
    return onArc(0.5);
}

/// Adds the triangle of the plane, the height over it, and a line from its foot to the middle of
/// the triangle.
/// @return the middle of the height
glm::dvec3 addHeight(Drawing &drawing, const std::vector<glm::dvec3> &at)
{
    for (std::size_t i = 0; i < 3; ++i)
        drawing.add(at[i], at[(i + 1) % 3]);
    const glm::dvec3 normal = glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
    const glm::dvec3 foot = at[3] - glm::dot(at[3] - at[0], normal) * normal;
    drawing.add(at[3], foot);
    drawing.add(foot, (at[0] + at[1] + at[2]) / 3.0);
    return (at[3] + foot) / 2.0;
}

/// Adds the plane; for a pair the mirror image of each landmark, with a line to the other one; and
/// for a landmark of the middle a line to its foot on the plane.
/// @param at  landmarks by twos: a landmark and its partner, or itself
/// @return the position of the label: on the line of a single pair or landmark, else on the plane
glm::dvec3 addMirror(Drawing &drawing, const std::vector<glm::dvec3> &at, const ShownMeasure::Mirror &mirror)
{
    drawing.addPlane(mirror.corners);
    glm::dvec3 middle = mirror.corners[3].coordinates();
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
        const glm::dvec3 image = mirror.plane.mirrored(WorldPoint(at[i])).coordinates();
        const bool isMiddle = at[i] == at[i + 1];
        const glm::dvec3 to = isMiddle ? (at[i] + image) / 2.0 : image;
        drawing.addImage(image);
        drawing.add(at[i + 1], to);
        if (!isMiddle) {
            const glm::dvec3 other = mirror.plane.mirrored(WorldPoint(at[i + 1])).coordinates();
            drawing.addImage(other);
            drawing.add(at[i], other);
        }
        if (at.size() == 2)
            middle = (at[1] + to) / 2.0;
    }
    return middle;
}

/// Adds a polyline. @return its middle, measured along it
glm::dvec3 addPolyline(Drawing &drawing, const std::vector<glm::dvec3> &at)
{
    std::vector<WorldPoint> path;
    for (std::size_t i = 0; i < at.size(); ++i) {
        path.push_back(WorldPoint(at[i]));
        if (i > 0)
            drawing.add(at[i - 1], at[i]);
    }
    return curves::resampled(path, 3)[1].coordinates();
}

} // namespace

std::optional<MeasureMark> measureMark(const SceneDocument &document)
{
    const std::optional<ShownMeasure> &shown = document.curves().shownMeasure();
    if (!shown)
        return std::nullopt;
    std::vector<glm::dvec3> at;
    for (const std::size_t index : shown->points) {
        if (index >= document.landmarks().size() || !document.landmarks()[index].isPlaced())
            return std::nullopt; // the list of measures is updated right after
        at.push_back(document.landmarks()[index].world->coordinates());
    }
    Drawing drawing(document.setup());
    glm::dvec3 middle(0.0);
    switch (shown->shape) {
    case Shape::Polyline: middle = addPolyline(drawing, at); break;
    case Shape::Angle: middle = addAngle(drawing, at); break;
    case Shape::Height: middle = addHeight(drawing, at); break;
    case Shape::Mirror:
        if (!shown->mirror)
            return std::nullopt;
        middle = addMirror(drawing, at, *shown->mirror);
        break;
    case Shape::Surface: {
        const SceneCurves::Line *line = document.curves().throughSelected();
        if (!line || !line->line || line->isComputing || line->line->path.empty())
            return std::nullopt;
        middle = curves::resampled(line->line->path, 3)[1].coordinates();
        break;
    }
    }
    const std::optional<QPointF> seen = drawing.seen(middle);
    if (!seen)
        return std::nullopt;
    MeasureMark mark = drawing.take();
    mark.label.at = *seen;
    mark.label.label = shown->text;
    mark.label.isCurrent = true; // it is placed before others
    return mark;
}

void drawMeasure(QPainter &painter, const MeasureMark &mark, const std::optional<PlacedLabel> &label)
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (!mark.plane.isEmpty()) {
        painter.setPen(QPen(QColor(0x1f, 0x5f, 0xbf, 200), 1.5));
        painter.setBrush(QColor(0x56, 0xb4, 0xe9, 60)); // the surface shows through
        painter.drawPolygon(mark.plane);
    }
    std::vector<QLineF> lines = mark.lines;
    for (const QPointF &image : mark.images) { // crosses
        lines.emplace_back(image - QPointF(kMarkRadius, kMarkRadius), image + QPointF(kMarkRadius, kMarkRadius));
        lines.emplace_back(image - QPointF(kMarkRadius, -kMarkRadius), image + QPointF(kMarkRadius, -kMarkRadius));
    }
    if (label && label->hasLeader)
        lines.emplace_back(mark.label.at, label->box.center()); // the box hides its end
    for (const auto &[color, width] : {std::pair(QColor(0, 0, 0, 170), 3.5), std::pair(QColor(Qt::white), 1.5)}) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
        for (const QLineF &line : lines)
            painter.drawLine(line);
    }
    if (!label)
        return;
    painter.setPen(QPen(QColor(0, 0, 0, 170), 1.0));
    painter.setBrush(QColor(0xff, 0xf4, 0xcc, 240));
    painter.drawRoundedRect(label->box, 3.0, 3.0);
    painter.setPen(QColor(0x18, 0x1a, 0x1c));
    painter.drawText(label->box, Qt::AlignCenter | Qt::TextSingleLine | Qt::TextDontClip, mark.label.label);
}

} // namespace unprojector::gui
