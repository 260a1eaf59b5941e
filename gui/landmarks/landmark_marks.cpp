#include "gui/landmarks/landmark_marks.h"

#include "core/geometry/camera_motion.h"
#include "core/geometry/numbers.h"
#include "gui/document/picks.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

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
    const auto pixel = [&] { return worldPerLogicalPixel(document.setup(), *landmark.world); };
    const auto isCutAway = [&](const glm::dvec4 &plane) {
        return glm::dot(plane, glm::dvec4(landmark.world->coordinates(), 1.0))
               < -pixel() * glm::length(glm::dvec3(plane));
    };
    if (std::any_of(planes.begin(), planes.end(), isCutAway))
        return true;
    const ray::SceneRays *rays = document.picks().rays();
    if (!rays)
        return false;
    const Result<std::optional<ray::SceneHit>> hit = rays->at(at);
    if (!hit || !*hit)
        return false;
    // Triangle indices are counted in each object.
    if (const auto *held = std::get_if<landmarks::OnTriangle>(&landmark.anchor);
        held && (*hit)->triangle && (*hit)->triangle->triangle == held->triangle
        && document.objects()[(*hit)->object].name == landmark.object)
        return false;
    const auto ray = rays->rays().at(at);
    if (!ray)
        return false;
    const double t = dot(*landmark.world - ray->from, ray->along) / dot(ray->along, ray->along);
    // A point up to a pixel below the surface, as from a file with few digits, counts as on it.
    const double deep = std::max(pixel(), 4.0 * length((*hit)->uncertainty));
    return (*hit)->t < t && distance((*hit)->world, *landmark.world) > deep;
}

/// Cells of the view that are occupied: labels in free cells overlap nothing.
class Room {
public:
    explicit Room(const QRectF &area)
        : m_area(area), m_columns(std::max(1, int(area.width() / kCell))),
          m_rows(std::max(1, int(area.height() / kCell))), m_words((m_columns + kBits - 1) / kBits),
          m_taken(static_cast<std::size_t>(m_words) * static_cast<std::size_t>(m_rows), 0)
    {
    }
    bool isFree(const QRectF &box) const
    {
        return m_area.contains(box)
               && everyWord(box, [this](std::size_t word, std::uint64_t cells) { return !(m_taken[word] & cells); });
    }
    void take(const QRectF &box)
    {
        everyWord(box, [this](std::size_t word, std::uint64_t cells) {
            m_taken[word] |= cells;
            return true;
        });
    }

private:
    static constexpr double kCell = 3.0;
    static constexpr int kBits = 64;

    /// Visits the cells of a box, up to 64 of a row at once, until `visit` returns false.
    template <class Visit>
    bool everyWord(const QRectF &box, const Visit &visit) const
    {
        const auto index = [](double way, int count) { return std::clamp(int(std::floor(way / kCell)), 0, count - 1); };
        const int left = index(box.left() - m_area.left(), m_columns);
        const int right = index(box.right() - m_area.left(), m_columns);
        const int top = index(box.top() - m_area.top(), m_rows), bottom = index(box.bottom() - m_area.top(), m_rows);
        for (int row = top; row <= bottom; ++row) {
            for (int word = left / kBits; word <= right / kBits; ++word) {
                const int from = std::max(left - word * kBits, 0), to = std::min(right - word * kBits, kBits - 1);
                const std::uint64_t cells = (~std::uint64_t{0} >> (kBits - 1 - (to - from))) << from;
                if (!visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(m_words)
                               + static_cast<std::size_t>(word),
                           cells))
                    return false;
            }
        }
        return true;
    }

    QRectF m_area;
    int m_columns, m_rows;
    int m_words; ///< of a row, with a bit for each of its cells
    std::vector<std::uint64_t> m_taken;
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

/// A disc, or a diamond for a free landmark.
void drawShape(QPainter &painter, const LandmarkMark &mark, double radius)
{
    if (!mark.isFree) {
        painter.drawEllipse(mark.at, radius, radius);
        return;
    }
    const double half = 1.4 * radius; // about the area of the disc
    painter.drawPolygon(QPolygonF({mark.at + QPointF(half, 0.0), mark.at + QPointF(0.0, half),
                                   mark.at - QPointF(half, 0.0), mark.at - QPointF(0.0, half)}));
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
        mark.isFree = std::holds_alternative<landmarks::Free>(landmark.anchor);
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
                                      const std::vector<QRectF> &taken, double radius)
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
        room.take(boxOf(mark.at, radius));
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
        if (mark.label.isEmpty())
            continue;
        const QSizeF size(metrics.horizontalAdvance(mark.label) + 2.0 * padding.width(),
                          metrics.height() + 2.0 * padding.height());
        const auto placeAt = [&](double gap, double x, double y) -> std::optional<PlacedLabel> {
            const double away = radius + gap;
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

void drawLandmarks(QPainter &painter, const std::vector<LandmarkMark> &marks, const std::vector<PlacedLabel> &labels,
                   double radius)
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
            painter.drawEllipse(mark.at, radius + 3.0, radius + 3.0);
            painter.setPen(QPen(kLight, 2.0));
            painter.drawEllipse(mark.at, radius + 3.0, radius + 3.0);
        }
        // Dark around light, visible on any surface; the exact position stays visible as a dot.
        if (mark.isBehind) {
            painter.setBrush(Qt::NoBrush);
            for (const QPen &pen : {QPen(kDark, 3.5), QPen(mark.color, 1.5)}) {
                painter.setPen(pen);
                drawShape(painter, mark, radius);
            }
            continue;
        }
        constexpr double kHalfRim = 0.75;
        painter.setPen(Qt::NoPen); // two fills are faster than a fill with a rim
        painter.setBrush(kDark);
        drawShape(painter, mark, radius + kHalfRim);
        painter.setBrush(mark.color);
        drawShape(painter, mark, radius - kHalfRim);
        painter.fillRect(boxOf(mark.at, 0.9), kDark);
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
    if (mark.isFree)
        lines << Texts::tr("It is free: no anchor holds it on a surface. B puts it back.");
    return lines.join(u'\n').toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
}

} // namespace unprojector::gui
