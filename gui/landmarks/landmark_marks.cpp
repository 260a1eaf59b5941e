#include "gui/landmarks/landmark_marks.h"

#include "core/geometry/angle.h"
#include "core/geometry/camera_motion.h"
#include "gui/document/picks.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

using landmarks::Landmark;

class Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::LandmarkMark)
};

const QColor kUsualColor(0xff, 0xc2, 0x2e);
const QColor kDark(0x18, 0x1a, 0x1c), kLight(0xff, 0xff, 0xff);

/// Returns whether the scene hides a point.
bool isBehind(const SceneDocument &document, const Landmark &landmark, const DevicePoint &at)
{
    const std::vector<glm::dvec4> &planes = document.scene().clipPlanes;
    const double pixel = worldPerLogicalPixel(document.setup(), *landmark.world);
    const auto isCutAway = [&](const glm::dvec4 &plane) {
        return glm::dot(plane, glm::dvec4(landmark.world->coordinates(), 1.0))
               < -pixel * glm::length(glm::dvec3(plane));
    };
    if (std::any_of(planes.begin(), planes.end(), isCutAway))
        return true;
    const ray::SceneRays *rays = document.picks().rays();
    if (!rays)
        return false;
    const Result<std::optional<ray::SceneHit>> hit = rays->at(at);
    const auto ray = rays->rays().at(at);
    if (!hit || !*hit || !ray)
        return false;
    // Triangle indices are counted in each object.
    if (const auto *held = std::get_if<landmarks::OnTriangle>(&landmark.anchor);
        held && (*hit)->triangle && (*hit)->triangle->triangle == held->triangle
        && document.objects()[(*hit)->object].name == landmark.object)
        return false;
    const double t = dot(*landmark.world - ray->from, ray->along) / dot(ray->along, ray->along);
    // A point up to a pixel below the surface, as from a file with few digits, counts as on it.
    const double deep = std::max(pixel, 4.0 * length((*hit)->uncertainty));
    return (*hit)->t < t && distance((*hit)->world, *landmark.world) > deep;
}

/// Cells of the view that are occupied: labels in free cells overlap nothing.
class Room {
public:
    explicit Room(const QRectF &area)
        : m_area(area), m_columns(std::max(1, int(area.width() / kCell))),
          m_rows(std::max(1, int(area.height() / kCell))),
          m_taken(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), false)
    {
    }
    bool isFree(const QRectF &box) const
    {
        return m_area.contains(box) && everyCell(box, [this](std::size_t cell) { return !m_taken[cell]; });
    }
    void take(const QRectF &box)
    {
        everyCell(box, [this](std::size_t cell) { return m_taken[cell] = true; });
    }

private:
    static constexpr double kCell = 3.0;

    /// Visits cells until `visit` returns false.
    template <class Visit>
    bool everyCell(const QRectF &box, const Visit &visit) const
    {
        const auto index = [](double way, int count) { return std::clamp(int(std::floor(way / kCell)), 0, count - 1); };
        const int left = index(box.left() - m_area.left(), m_columns);
        const int right = index(box.right() - m_area.left(), m_columns);
        const int top = index(box.top() - m_area.top(), m_rows), bottom = index(box.bottom() - m_area.top(), m_rows);
        for (int row = top; row <= bottom; ++row) {
            for (int column = left; column <= right; ++column) {
                if (!visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns)
                           + static_cast<std::size_t>(column)))
                    return false;
            }
        }
        return true;
    }

    QRectF m_area;
    int m_columns, m_rows;
    std::vector<bool> m_taken;
};

QRectF boxOf(const QPointF &middle, double half)
{
    return {middle.x() - half, middle.y() - half, 2.0 * half, 2.0 * half};
}

/// The padding between a label's text and its box.
QSizeF paddingOf(const QFontMetricsF &metrics)
{
    return {metrics.height() * 0.25, metrics.height() * 0.06};
}

QPointF nearestOf(const QRectF &box, const QPointF &point)
{
    return {std::clamp(point.x(), box.left(), box.right()), std::clamp(point.y(), box.top(), box.bottom())};
}

} // namespace

std::vector<LandmarkMark> landmarkMarks(const SceneDocument &document)
{
    std::vector<LandmarkMark> marks;
    const std::vector<Landmark> &landmarks = document.landmarks();
    const Setup &g = document.setup();
    const Result<glm::dmat4> matrix = landmarks.empty() ? Result<glm::dmat4>(glm::dmat4(1.0)) : clipFromWorld(g);
    if (landmarks.empty() || !matrix)
        return marks;
    const SceneLandmarks &list = document.sceneLandmarks();
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        const Landmark &landmark = landmarks[i];
        if (landmark.isHidden || !landmark.isPlaced())
            continue;
        const glm::dvec4 clip = *matrix * glm::dvec4(landmark.world->coordinates(), 1.0);
        if (!(clip.w > 0.0) || !(std::abs(clip.x) <= clip.w) || !(std::abs(clip.y) <= clip.w))
            continue;
        const NdcPoint ndc(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
        const DevicePoint at = deviceFromWindow(g.surface, windowFromNdc(g.viewport, g.depthRange, ndc, ndcDepthOf(g)));
        const WidgetPoint widget = widgetFromDevice(g.surface, at);
        LandmarkMark mark;
        mark.index = i;
        mark.at = QPointF(widget.x, widget.y);
        mark.isBehind = isBehind(document, landmark, at);
        mark.isSelected = list.isSelected(i);
        mark.isCurrent = list.current() == i;
        mark.color = landmark.color ? QColor(landmark.color->r, landmark.color->g, landmark.color->b) : kUsualColor;
        const QString name = SceneLandmarks::shownNameOf(landmarks, i);
        mark.label = mark.isBehind ? Texts::tr("%1 (behind)", "a point that the surface hides").arg(name) : name;
        marks.push_back(std::move(mark));
    }
    return marks;
}

const LandmarkMark *markUnder(const std::vector<LandmarkMark> &marks, const QPointF &pointer, bool isInSightOnly)
{
    const LandmarkMark *nearest = nullptr;
    double least = 0.0;
    for (const LandmarkMark &mark : marks) {
        const double away = std::hypot(mark.at.x() - pointer.x(), mark.at.y() - pointer.y());
        const double counted = away + (mark.isBehind ? kMarkReach : 0.0);
        if (isInSightOnly && mark.isBehind)
            continue;
        if (away <= kMarkReach && (!nearest || counted < least)) {
            nearest = &mark;
            least = counted;
        }
    }
    return nearest;
}

std::vector<PlacedLabel> placedLabels(const std::vector<LandmarkMark> &marks, const QFontMetricsF &metrics,
                                      const QRectF &area, const std::vector<QLineF> &lines,
                                      const std::vector<QRectF> &taken)
{
    Room room(area);
    for (const QRectF &box : taken) {
        if (!box.isNull())
            room.take(box);
    }
    for (const QLineF &line : lines) {
        const int steps = 1 + static_cast<int>(line.length() / kMarkRadius);
        for (int i = 0; i <= steps; ++i)
            room.take(boxOf(line.pointAt(static_cast<double>(i) / steps), kMarkRadius));
    }
    for (const LandmarkMark &mark : marks)
        room.take(boxOf(mark.at, kMarkRadius));
    std::vector<std::size_t> order(marks.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    const auto rank = [&](std::size_t i) {
        return marks[i].isCurrent ? 0 : marks[i].isSelected ? 1 : marks[i].isBehind ? 3 : 2;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });

    // Near positions at the sides first, then above and below; then all around, farther away each
    // time.
    struct Way {
        double x, y; ///< of the box's centre, in halves of the box and the gap
    };
    constexpr std::array kWays{Way{1, 0},   Way{-1, 0}, Way{1, -1}, Way{1, 1},
                               Way{-1, -1}, Way{-1, 1}, Way{0, -1}, Way{0, 1}};
    constexpr double kClose = 3.0;
    constexpr int kRings = 6, kTurns = 16;
    const QSizeF padding = paddingOf(metrics);
    std::vector<PlacedLabel> labels;
    for (const std::size_t i : order) {
        const LandmarkMark &mark = marks[i];
        const QSizeF size(metrics.horizontalAdvance(mark.label) + 2.0 * padding.width(),
                          metrics.height() + 2.0 * padding.height());
        const auto placeAt = [&](double gap, double x, double y) -> std::optional<PlacedLabel> {
            const double away = kMarkRadius + gap;
            const QPointF middle = mark.at + QPointF(x * (away + size.width() / 2.0), y * (away + size.height() / 2.0));
            const QRectF box(middle - QPointF(size.width() / 2.0, size.height() / 2.0), size);
            return room.isFree(box) ? std::optional(PlacedLabel{i, box, gap > kClose}) : std::nullopt;
        };
        const auto place = [&]() -> std::optional<PlacedLabel> {
            for (const Way &way : kWays) {
                if (const auto label = placeAt(kClose, way.x, way.y))
                    return label;
            }
            for (int ring = 1; ring <= kRings; ++ring) {
                for (int turn = 0; turn < kTurns; ++turn) {
                    const double angle = 2.0 * kPi * turn / kTurns;
                    if (const auto label = placeAt(ring * size.height(), std::cos(angle), std::sin(angle)))
                        return label;
                }
            }
            return std::nullopt;
        };
        if (const std::optional<PlacedLabel> label = place()) {
            room.take(label->box);
            labels.push_back(*label);
        }
    }
    return labels;
}

void drawLandmarks(QPainter &painter, const std::vector<LandmarkMark> &marks, const std::vector<PlacedLabel> &labels)
{
    painter.setRenderHint(QPainter::Antialiasing);
    for (const PlacedLabel &label : labels) {
        if (!label.hasLeader)
            continue;
        const QPointF from = marks[label.mark].at, to = nearestOf(label.box, from);
        painter.setPen(QPen(QColor(0, 0, 0, 150), 2.5));
        painter.drawLine(from, to);
        painter.setPen(QPen(marks[label.mark].color, 1.0));
        painter.drawLine(from, to);
    }
    for (const LandmarkMark &mark : marks) {
        if (mark.isSelected) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(kDark, 4.0));
            painter.drawEllipse(mark.at, kMarkRadius + 3.0, kMarkRadius + 3.0);
            painter.setPen(QPen(kLight, 2.0));
            painter.drawEllipse(mark.at, kMarkRadius + 3.0, kMarkRadius + 3.0);
        }
        // Dark around light, visible on any surface; the exact position stays visible as a dot.
        painter.setPen(QPen(kDark, mark.isBehind ? 3.5 : 1.5));
        painter.setBrush(mark.isBehind ? QBrush(Qt::NoBrush) : QBrush(mark.color));
        painter.drawEllipse(mark.at, kMarkRadius, kMarkRadius);
        if (mark.isBehind) {
            painter.setPen(QPen(mark.color, 1.5));
            painter.drawEllipse(mark.at, kMarkRadius, kMarkRadius);
        } else {
            painter.setPen(Qt::NoPen);
            painter.setBrush(kDark);
            painter.drawEllipse(mark.at, 1.0, 1.0);
        }
    }
    const QSizeF padding = paddingOf(QFontMetricsF(painter.font()));
    for (const PlacedLabel &label : labels) {
        const LandmarkMark &mark = marks[label.mark];
        painter.setPen(Qt::NoPen);
        painter.setBrush(mark.isSelected ? QColor(0xff, 0xff, 0xff, 235)
                                         : QColor(0x18, 0x1a, 0x1c, mark.isBehind ? 120 : 190));
        painter.drawRoundedRect(label.box, 3.0, 3.0);
        painter.setPen(mark.isSelected ? kDark : mark.isBehind ? QColor(0xd0, 0xd0, 0xd0) : kLight);
        painter.drawText(label.box.adjusted(padding.width(), 0.0, 0.0, 0.0),
                         Qt::AlignVCenter | Qt::AlignLeft | Qt::TextSingleLine | Qt::TextDontClip, mark.label);
    }
}

QString landmarkTip(const SceneDocument &document, const LandmarkMark &mark)
{
    const Landmark &landmark = document.landmarks()[mark.index];
    QStringList lines{
        SceneLandmarks::shownNameOf(document.landmarks(), mark.index),
        QStringLiteral("%1, %2, %3")
            .arg(shortestText(landmark.world->x), shortestText(landmark.world->y), shortestText(landmark.world->z))};
    if (!landmark.note.empty())
        lines << QString::fromStdString(landmark.note);
    if (mark.isBehind)
        lines << Texts::tr("A surface hides it in this view.");
    return lines.join(u'\n').toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
}

} // namespace unprojector::gui
