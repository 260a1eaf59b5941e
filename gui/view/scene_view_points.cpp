// What the hand does with placed points in the view, and how they are shown.

#include "gui/view/scene_view.h"

#include "gui/view/highlight_marks.h"
#include "gui/view/measure_mark.h"
#include "gui/view/point_loupe.h"
#include "gui/view/scene_overlay.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace unprojector::gui {
namespace {

using landmarks::Landmark;

DevicePoint deviceOf(const Surface &surface, const QPointF &logical)
{
    return deviceFromWidget(surface, WidgetPoint(logical.x(), logical.y()));
}

/// How far an arrow key moves a point, device pixels; nothing for another key.
std::optional<QPointF> nudgeOf(const QKeyEvent &event)
{
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
    double pixels = 1.0;
    if (modifiers == Qt::ShiftModifier)
        pixels = 10.0;
    else if (modifiers == Qt::AltModifier)
        pixels = 0.1;
    else if (modifiers != Qt::NoModifier)
        return std::nullopt;
    switch (event.key()) {
    case Qt::Key_Left: return QPointF(-pixels, 0.0);
    case Qt::Key_Right: return QPointF(pixels, 0.0);
    case Qt::Key_Up: return QPointF(0.0, -pixels);
    case Qt::Key_Down: return QPointF(0.0, pixels);
    default: return std::nullopt;
    }
}

} // namespace

void SceneView::setPlacing(bool isPlacing)
{
    if (std::exchange(m_isPlacing, isPlacing) == isPlacing)
        return;
    aimLoupe(std::nullopt);
    emit placingChanged(isPlacing);
}

const std::vector<PointMark> &SceneView::marks()
{
    if (!m_marks)
        m_marks = pointMarks(m_document);
    return *m_marks;
}

void SceneView::drawMap()
{
    if (!m_map.isNull())
        paintOver(1.0, [this](QPainter &painter) { painter.drawImage(0, 0, m_map); }); // pixel on pixel
}

std::vector<QRectF> SceneView::takenCorners() const
{
    std::vector<QRectF> taken;
    const Picture &g = m_document.geometry();
    if (const Result<Drawable> drawn = drawable(g)) {
        const double side = SceneOverlay::axesSide(*drawn);
        const WidgetPoint low = widgetFromDevice(
            g.surface, deviceFromWindow(g.surface, WindowPoint(g.viewport.x, g.viewport.y + side, 0.0)));
        taken.emplace_back(QPointF(low.x, low.y), QSizeF(side, side) / g.surface.devicePixelRatio);
    }
    if (m_corner && m_corner->isVisible())
        taken.emplace_back(QRectF(rect().topRight() - QPoint(m_corner->width(), 0), QSizeF(m_corner->size())));
    return taken;
}

void SceneView::drawMarks()
{
    const std::vector<PointMark> &shown = marks();
    const HighlightMarks highlights = highlightsInView(m_document, m_highlights);
    if (shown.empty() && !m_loupeAt && highlights.isEmpty())
        return;
    const QImage loupe = m_loupeAt ? pixelsAbout(*m_loupeAt) : QImage();
    paintOver(currentSurface().devicePixelRatio, [&](QPainter &painter) {
        const QFontMetricsF metrics(painter.font());
        const std::vector<QRectF> ofHighlights = boxesOf(highlights, painter.font(), QRectF(rect()), takenCorners());
        drawHighlights(painter, highlights, ofHighlights);
        const auto shownArrows = arrows();
        std::vector<QLineF> lines;
        for (const AxisArrow &arrow : shownArrows.value_or(std::array<AxisArrow, 3>())) {
            if (arrow.isUsable)
                lines.emplace_back(arrow.from, arrow.to);
        }
        const std::optional<MeasureMark> measure = measureMark(m_document);
        std::vector<PointMark> labelled = shown;
        if (measure) { // beside its line, and clear of the points' own
            lines.insert(lines.end(), measure->lines.begin(), measure->lines.end());
            labelled.push_back(measure->label);
        }
        std::vector<PlacedLabel> labels = placedLabels(labelled, metrics, QRectF(rect()), lines, ofHighlights);
        std::optional<PlacedLabel> ofMeasure;
        std::erase_if(labels, [&](const PlacedLabel &label) {
            if (label.mark < shown.size())
                return false;
            ofMeasure = label;
            return true;
        });
        if (measure)
            drawMeasure(painter, *measure, ofMeasure);
        drawPoints(painter, shown, labels);
        if (shownArrows)
            drawAxes(painter, *shownArrows, m_drag == Drag::Axis ? std::optional(m_draggedAxis) : std::nullopt);
        if (m_loupeAt) {
            const ray::SceneRays *rays = m_document.rays();
            const double taken = m_corner && m_corner->isVisible() ? m_corner->width() : 0.0;
            drawLoupe(painter, loupeBox(m_document.geometry().surface, *m_loupeAt, taken), *m_loupeAt, loupe,
                      rays ? loupeEdges(*rays, *m_loupeAt) : std::vector<QLineF>());
        }
    });
}

void SceneView::aimLoupe(const std::optional<DevicePoint> &at)
{
    if (!at && !m_loupeAt)
        return;
    m_loupeAt = at;
    update();
}

std::optional<DevicePoint> SceneView::pointedAt(const QPointF &local) const
{
    const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.geometry().surface, widgetPosition(local));
    return pixel ? std::optional(pixelCenter(*pixel)) : std::nullopt;
}

QImage SceneView::pixelsAbout(const DevicePoint &at)
{
    const QRect wanted = loupePixels(at);
    const Surface surface = currentSurface();
    const QRect there = wanted & QRect(0, 0, surface.widthPixels, surface.heightPixels);
    QImage pixels(wanted.size(), QImage::Format_RGBA8888);
    pixels.fill(Qt::black);
    if (there.isEmpty())
        return pixels;
    QImage read(there.size(), QImage::Format_RGBA8888);
    // Four bytes a pixel: no row is padded.
    glReadPixels(there.left(), framebufferRow(surface, {there.left(), there.bottom()}), there.width(), there.height(),
                 GL_RGBA, GL_UNSIGNED_BYTE, read.bits());
    for (int row = 0; row < there.height(); ++row) {
        const uchar *from = read.constScanLine(there.height() - 1 - row);
        const std::ptrdiff_t beside = there.left() - wanted.left();
        uchar *to = pixels.scanLine(there.top() - wanted.top() + row) + 4 * beside;
        for (std::ptrdiff_t i = 0; i < there.width(); ++i) {
            std::copy_n(from + 4 * i, 3, to + 4 * i);
            to[4 * i + 3] = 255; // whatever the framebuffer has there
        }
    }
    return pixels;
}

/// @return whether a mark in sight was pressed: it is selected; one that was selected before, and any while points are placed, can
/// be dragged
bool SceneView::pressMark(const QMouseEvent &event)
{
    const WidgetPoint position = widgetPosition(event.position());
    const QPointF pointer(position.x, position.y);
    const PointMark *mark = markUnder(marks(), pointer, true);
    if (!mark)
        return pressArrow(pointer);
    const PointMark pressed = *mark; // what is selected now has other marks
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        m_document.points().toggle(pressed.place);
    } else if (m_document.points().isSelected(pressed.place)) {
        m_document.points().select(m_document.points().selection(), pressed.place);
    } else {
        m_document.points().selectOnly(pressed.place);
    }
    // A hand that turns the view must not take a point along that nobody has chosen.
    if (!m_isPlacing && !pressed.isSelected) {
        m_pivot = pivotAt(position);
        m_drag = Drag::Orbit;
        return true;
    }
    m_draggedPoint = pressed.place;
    m_dragStart = pressed.at;
    m_draggedWith.clear();
    for (const PointMark &other : marks()) {
        if (other.isSelected && !other.isBehind && other.place != pressed.place)
            m_draggedWith.emplace_back(other.place, other.at);
    }
    m_leftBehind = 0;
    m_pointGrab = pressed.at - pointer;
    m_hasMovedPoint = false;
    m_stepAtPress = m_document.undoStack().index();
    m_drag = Drag::Point;
    return true;
}

void SceneView::dragPoint(const QPointF &local)
{
    const WidgetPoint position = widgetPosition(local);
    const QPointF wanted = QPointF(position.x, position.y) + m_pointGrab;
    const std::optional<Landmark> there = m_document.points().onMeshAt(deviceOf(m_document.geometry().surface, wanted));
    if (!there) // beside the mesh it waits where it was last on it
        return;
    m_hasMovedPoint = true;
    std::vector<ScenePoints::Move> moves{{m_draggedPoint, *there}};
    for (const auto &[place, at] : m_draggedWith) {
        const std::optional<Landmark> other =
            m_document.points().onMeshAt(deviceOf(m_document.geometry().surface, at + wanted - m_dragStart));
        const std::string &before = m_document.landmarks()[place].object;
        if (other && (before.empty() || other->object == before)) // not from one object onto another
            moves.push_back({place, *other});
    }
    const std::vector<std::size_t> selected = selectedInView();
    const auto wantedMoves =
        static_cast<std::size_t>(std::count_if(selected.begin(), selected.end(), [this](std::size_t place) {
            return !m_document.landmarks()[place].isMissing();
        }));
    m_leftBehind = wantedMoves - std::min(wantedMoves, moves.size());
    const QScopedValueRollback<bool> moving(m_isMovingPoint, true);
    static_cast<void>(m_document.points().moveAll(moves, m_gesture));
    aimLoupe(deviceOf(m_document.geometry().surface, wanted));
}

std::optional<std::array<AxisArrow, 3>> SceneView::arrows() const
{
    const std::optional<std::size_t> current = m_document.points().current();
    if (!m_isPlacing || !current)
        return std::nullopt;
    const Landmark &point = m_document.landmarks()[*current];
    if (point.isMissing() || point.isHidden)
        return std::nullopt;
    return axisArrows(m_document.geometry(), *point.world);
}

bool SceneView::pressArrow(const QPointF &pointer)
{
    const auto shown = arrows();
    const std::optional<int> axis = shown ? axisUnder(*shown, pointer) : std::nullopt;
    const ray::SceneRays *rays = axis ? m_document.rays() : nullptr;
    if (!rays)
        return false;
    m_draggedPoint = *m_document.points().current();
    m_axisStart = *m_document.landmarks()[m_draggedPoint].world;
    const auto ray = rays->rays().at(deviceOf(m_document.geometry().surface, pointer));
    const std::optional<double> from = ray ? wayAlong(m_axisStart, *axis, *ray) : std::nullopt;
    if (!from)
        return false;
    m_draggedAxis = *axis;
    m_axisFrom = *from;
    m_hasMovedPoint = false;
    m_stepAtPress = m_document.undoStack().index();
    m_drag = Drag::Axis;
    return true;
}

void SceneView::dragAlongAxis(const QPointF &local)
{
    const ray::SceneRays *rays = m_document.rays();
    if (!rays)
        return;
    const WidgetPoint position = widgetPosition(local);
    const auto ray = rays->rays().at(deviceFromWidget(m_document.geometry().surface, position));
    const std::optional<double> way = ray ? wayAlong(m_axisStart, m_draggedAxis, *ray) : std::nullopt;
    if (!way)
        return;
    WorldPoint to = m_axisStart;
    to[m_draggedAxis] += *way - m_axisFrom;
    m_hasMovedPoint = true;
    const QScopedValueRollback<bool> moving(m_isMovingPoint, true);
    static_cast<void>(m_document.points().moveTo(m_draggedPoint, to, m_gesture));
}

void SceneView::placePointAt(const QPointF &local)
{
    const WidgetPoint position = widgetPosition(local);
    const std::optional<Landmark> there = m_document.points().placedAt(position, sampleAt(position));
    if (there) {
        static_cast<void>(m_document.points().place(*there));
        return;
    }
    QToolTip::showText(mapToGlobal(local).toPoint(), tr("Background: no surface here"), this);
}

void SceneView::endPointDrag()
{
    if (!isPointDragged() || m_isMovingPoint)
        return;
    m_drag = Drag::None;
    aimLoupe(std::nullopt);
}

std::vector<std::size_t> SceneView::selectedInView() const
{
    std::vector<std::size_t> shown;
    for (const std::size_t place : m_document.points().selection()) {
        if (!m_document.landmarks()[place].isHidden)
            shown.push_back(place);
    }
    return shown;
}

bool SceneView::isPointKey(const QKeyEvent &event) const
{
    const bool isPlain = (event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier)) == Qt::NoModifier;
    if (event.key() == Qt::Key_Escape)
        return isPlain && (isPointDragged() || m_isPlacing);
    if (event.key() == Qt::Key_Delete)
        return isPlain && !selectedInView().empty();
    const std::optional<std::size_t> current = m_document.points().current();
    if (!m_isPlacing || !current || !nudgeOf(event))
        return false;
    const Landmark &point = m_document.landmarks()[*current];
    return !point.isHidden && !point.isMissing(); // else there is nothing to be moved, and keys turn the view
}

void SceneView::pressPointKey(const QKeyEvent &event)
{
    if (event.key() == Qt::Key_Escape) {
        if (!isPointDragged()) {
            setPlacing(false);
            return;
        }
        m_drag = Drag::None;
        aimLoupe(std::nullopt);
        if (m_hasMovedPoint && m_document.undoStack().index() > m_stepAtPress) // not what was done before
            m_document.undoStack().undo();
        return;
    }
    if (m_drag != Drag::None)
        return; // a hand has it already
    if (event.key() == Qt::Key_Delete) {
        static_cast<void>(m_document.points().remove(selectedInView()));
        return;
    }
    nudge(*nudgeOf(event));
}

void SceneView::nudge(const QPointF &way)
{
    // As exact as the step: who moves by tenths of a pixel means one of them.
    const double pixels = std::min(1.0, std::abs(way.x()) + std::abs(way.y()));
    ScenePoints &points = m_document.points();
    const std::vector<std::size_t> selected = selectedInView();
    const auto wanted = std::count_if(selected.begin(), selected.end(),
                                      [&](std::size_t place) { return !points.all()[place].isMissing(); });
    std::vector<ScenePoints::Move> moves;
    std::optional<QPointF> left;
    std::optional<DevicePoint> aim;
    for (const PointMark &mark : marks()) {
        if (!points.isSelected(mark.place))
            continue;
        DevicePoint to = deviceOf(m_document.geometry().surface, mark.at);
        to.x += way.x();
        to.y += way.y();
        const std::optional<Landmark> there = mark.isBehind ? std::nullopt : points.onSurfaceAt(to, pixels);
        if (mark.isBehind && (!left || mark.isCurrent))
            left = mark.at;
        if (!there)
            continue;
        moves.push_back({mark.place, *there});
        if (mark.isCurrent)
            aim = to;
    }
    QString key = QStringLiteral("nudge");
    for (const ScenePoints::Move &move : moves)
        key += u' ' + QString::number(move.place);
    static_cast<void>(points.moveAll(moves, key));
    if (aim) {
        aimLoupe(*aim);
        reportHover(widgetFromDevice(m_document.geometry().surface, *aim));
    }
    const auto unmoved = static_cast<int>(wanted) - static_cast<int>(moves.size());
    if (wanted == 1 && left)
        QToolTip::showText(mapToGlobal(*left).toPoint(),
                           tr("It is behind what is seen here: turn the view, or go to it (G)."), this);
    else if (wanted > 1 && unmoved > 0)
        tellUnmoved(static_cast<std::size_t>(unmoved), left.value_or(QPointF(rect().center())));
}

void SceneView::tellUnmoved(std::size_t count, const QPointF &at)
{
    QToolTip::showText(mapToGlobal(at).toPoint(),
                       tr("Selected points that were not moved, behind what is seen here or beside it: %1.").arg(count),
                       this);
}

void SceneView::showTip(const QHelpEvent &event)
{
    const WidgetPoint position = widgetPosition(QPointF(event.pos()));
    const PointMark *mark = markUnder(marks(), QPointF(position.x, position.y));
    QToolTip::showText(event.globalPos(), mark ? pointTip(m_document, *mark) : QString(), this);
}

} // namespace unprojector::gui
