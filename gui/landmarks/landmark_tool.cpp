#include "gui/landmarks/landmark_tool.h"

#include "gui/document/landmark_placing.h"
#include "gui/document/picks.h"
#include "gui/landmarks/expected_landmarks.h"
#include "gui/view/scene_view.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QStyleHints>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

using landmarks::Landmark;

DevicePoint deviceOf(const Surface &surface, const QPointF &logical)
{
    return deviceFromWidget(surface, WidgetPoint(logical.x(), logical.y()));
}

/// The movement for an arrow key, device pixels; nothing for another key.
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

LandmarkTool::LandmarkTool(SceneDocument &document, SceneView &view)
    : QObject(&view), m_document(document), m_view(view), m_drawing(document, view)
{
    connect(&m_document, &SceneDocument::opened, this, &LandmarkTool::endDrag);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Landmarks) // the dragged landmark may be gone
            endDrag();
        if (m_arrows != Arrows::Hidden && visibleCurrent() != m_arrowsOf)
            setArrows(Arrows::Hidden);
        if (changes & (kVisibleChanges | Change::Preview | Change::Landmarks | Change::LandmarkSelection))
            m_drawing.forgetMarks();
        m_drawing.forgetImage();
    });
    // Only now is it known which landmarks are hidden.
    connect(&m_document.picks().rayCasters(), &RayCasters::built, this, [this] {
        m_drawing.forgetMarks();
        if (!m_document.landmarks().empty())
            m_view.update();
    });
}

void LandmarkTool::setExpected(ExpectedLandmarks &expected)
{
    m_drawing.setExpected(expected);
    connect(&expected, &ExpectedLandmarks::changed, this, [this] {
        m_drawing.forgetImage();
        m_view.update();
    });
}

void LandmarkTool::setPlacing(bool isPlacing)
{
    if (std::exchange(m_isPlacing, isPlacing) == isPlacing)
        return;
    m_drawing.aimLoupe(std::nullopt);
    setArrows(Arrows::Hidden);
    emit placingChanged(isPlacing);
}

bool LandmarkTool::prepareToDraw()
{
    m_drawing.prepareLoupe();
    return m_drawing.hasLoupe() || m_drawing.hasMarks();
}

void LandmarkTool::draw(QPainter &painter, const std::vector<QRectF> &taken)
{
    const auto shownArrows = arrows();
    std::vector<QLineF> lines;
    for (const AxisArrow &arrow : shownArrows.value_or(std::array<AxisArrow, 3>())) {
        if (arrow.isUsable)
            lines.emplace_back(arrow.from, arrow.to);
    }
    if (m_drawing.hasMarks())
        m_drawing.draw(painter, taken, std::move(lines));
    if (shownArrows)
        drawAxes(painter, *shownArrows, m_drag == Drag::Axis ? std::optional(m_axis) : std::nullopt);
    m_drawing.drawLoupe(painter);
}

std::optional<DevicePoint> LandmarkTool::pointedAt(const QPointF &local) const
{
    const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.setup().surface, m_view.widgetPosition(local));
    return pixel ? std::optional(pixelCenter(*pixel)) : std::nullopt;
}

bool LandmarkTool::refuses(const QMouseEvent &event)
{
    bool isSecond = event.type() == QEvent::MouseButtonDblClick && (m_isPlacing || m_lastPress);
    if (m_lastPress && m_lastPress->milliseconds > 0) { // a third click comes as a single one
        const QStyleHints &hints = *QGuiApplication::styleHints();
        const quint64 latest = m_lastPress->milliseconds + static_cast<quint64>(hints.mouseDoubleClickInterval());
        const QPointF way = event.position() - m_lastPress->at;
        isSecond = isSecond
                   || (event.timestamp() < latest && way.manhattanLength() <= double(hints.mouseDoubleClickDistance()));
    }
    if (!isSecond)
        return false;
    m_lastPress = PlacingPress{event.position(), event.timestamp()};
    QToolTip::showText(event.globalPosition().toPoint(), tr("The second click of a double-click places nothing."),
                       &m_view);
    return true;
}

ViewTool::Press LandmarkTool::press(const QMouseEvent &event, const QString &mergeKey)
{
    m_lastPress.reset();
    if (m_isPlacing)
        m_lastPress = PlacingPress{event.position(), event.timestamp()};
    const WidgetPoint position = m_view.widgetPosition(event.position());
    const QPointF pointer(position.x, position.y);
    const LandmarkMark *mark = markUnder(m_drawing.marks(), pointer, true);
    m_mergeKey = mergeKey;
    if (!mark)
        return pressArrow(pointer) ? Press::Drags : Press::Passed;
    const LandmarkMark pressed = *mark; // a copy: the selection changes the marks
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        m_document.sceneLandmarks().toggle(pressed.index);
    } else if (m_document.sceneLandmarks().isSelected(pressed.index)) {
        m_document.sceneLandmarks().select(m_document.sceneLandmarks().selection(), pressed.index);
    } else {
        m_document.sceneLandmarks().selectOnly(pressed.index);
    }
    // The user may be about to turn the view: a landmark that was not selected before must not move
    // along.
    if (!m_isPlacing && !pressed.isSelected)
        return Press::Navigates;
    m_dragged = pressed.index;
    m_dragStart = pressed.at;
    m_draggedWith.clear();
    for (const LandmarkMark &other : m_drawing.marks()) {
        if (other.isSelected && !other.isBehind && other.index != pressed.index)
            m_draggedWith.emplace_back(other.index, other.at);
    }
    m_leftBehind = 0;
    m_grab = pressed.at - pointer;
    m_hasMoved = false;
    m_stepAtPress = m_document.undoStack().index();
    const bool isWaiting = m_isPlacing && m_document.sceneLandmarks().nextUnplaced();
    m_drag = isWaiting && !event.modifiers().testFlag(Qt::ControlModifier) ? Drag::Pressed : Drag::Landmark;
    return Press::Drags;
}

void LandmarkTool::dragTo(const QPointF &local)
{
    switch (m_drag) {
    case Drag::None: return;
    case Drag::Pressed: {
        const WidgetPoint position = m_view.widgetPosition(local);
        const QPointF moved = QPointF(position.x, position.y) + m_grab - m_dragStart;
        if (moved.manhattanLength() < QApplication::startDragDistance()) // a click by an unsteady hand
            return;
        m_drag = Drag::Landmark;
        dragLandmark(local);
        return;
    }
    case Drag::Landmark: dragLandmark(local); return;
    case Drag::Axis: dragAlongAxis(local); return;
    }
}

void LandmarkTool::release(const QPointF &local)
{
    m_drawing.aimLoupe(m_isPlacing ? pointedAt(local) : std::nullopt);
    const Drag ended = std::exchange(m_drag, Drag::None);
    if (ended == Drag::Landmark && m_hasMoved && m_leftBehind > 0)
        tellUnmoved(m_leftBehind, local);
    if ((ended != Drag::Axis && ended != Drag::Pressed) || m_hasMoved)
        return;
    if (m_isPlacing) // a click on an arrow or a mark is a click on the surface below it
        click(local);
    else
        m_view.pickAt(m_view.widgetPosition(local));
}

void LandmarkTool::hover(const std::optional<QPointF> &local)
{
    hoverArrows(local);
    if (!local)
        m_drawing.aimLoupe(std::nullopt);
    else if (m_isPlacing)
        m_drawing.aimLoupe(pointedAt(*local));
}

void LandmarkTool::dragLandmark(const QPointF &local)
{
    const WidgetPoint position = m_view.widgetPosition(local);
    const QPointF wanted = QPointF(position.x, position.y) + m_grab;
    const std::optional<Landmark> there = landmarkOnMesh(m_document, deviceOf(m_document.setup().surface, wanted));
    if (!there) // beside the mesh it stays at its last position on it
        return;
    m_hasMoved = true;
    std::vector<SceneLandmarks::Move> moves{{m_dragged, *there}};
    for (const auto &[place, at] : m_draggedWith) {
        const std::optional<Landmark> other =
            landmarkOnMesh(m_document, deviceOf(m_document.setup().surface, at + wanted - m_dragStart));
        const std::string &before = m_document.landmarks()[place].object;
        if (other && (before.empty() || other->object == before)) // not from one object onto another
            moves.push_back({place, *other});
    }
    const std::vector<std::size_t> selected = selectedInView();
    const auto wantedMoves =
        static_cast<std::size_t>(std::count_if(selected.begin(), selected.end(), [this](std::size_t index) {
            return m_document.landmarks()[index].isPlaced();
        }));
    m_leftBehind = wantedMoves - std::min(wantedMoves, moves.size());
    const QScopedValueRollback<bool> moving(m_isMoving, true);
    static_cast<void>(m_document.sceneLandmarks().moveAll(moves, m_mergeKey));
    m_drawing.aimLoupe(deviceOf(m_document.setup().surface, wanted));
}

std::optional<std::size_t> LandmarkTool::visibleCurrent() const
{
    const std::optional<std::size_t> current = m_document.sceneLandmarks().current();
    const std::vector<Landmark> &landmarks = m_document.landmarks();
    const bool isVisible =
        current && *current < landmarks.size() && landmarks[*current].isPlaced() && !landmarks[*current].isHidden;
    return isVisible ? current : std::nullopt;
}

std::optional<std::array<AxisArrow, 3>> LandmarkTool::arrows() const
{
    const std::optional<std::size_t> current = m_arrows == Arrows::Hidden ? std::nullopt : visibleCurrent();
    if (!current)
        return std::nullopt;
    return axisArrows(m_document.setup(), *m_document.landmarks()[*current].world);
}

bool LandmarkTool::setArrowsShown(bool areShown)
{
    if (areShown && !visibleCurrent())
        return false;
    setArrows(areShown ? Arrows::Asked : Arrows::Hidden);
    return true;
}

void LandmarkTool::setArrows(Arrows arrows)
{
    m_arrowsOf = visibleCurrent();
    const Arrows before = std::exchange(m_arrows, arrows);
    if (before == arrows)
        return;
    m_drawing.forgetImage();
    m_view.update();
    if ((before == Arrows::Asked) != (arrows == Arrows::Asked))
        emit arrowsChanged(arrows == Arrows::Asked);
}

void LandmarkTool::hoverArrows(const std::optional<QPointF> &local)
{
    constexpr double kAtMark = 16.0; // where the arrows begin
    const bool wasOver = std::exchange(m_isOverCurrent, false);
    double away = kAtMark;
    QPointF pointer;
    if (local) {
        const WidgetPoint position = m_view.widgetPosition(*local);
        pointer = QPointF(position.x, position.y);
        for (const LandmarkMark &mark : m_drawing.marks()) {
            if (mark.isCurrent && !mark.isBehind)
                away = std::hypot(mark.at.x() - pointer.x(), mark.at.y() - pointer.y());
        }
        m_isOverCurrent = away <= kMarkReach;
    }
    if (m_arrows == Arrows::Asked)
        return;
    const bool isNameWaiting = m_isPlacing && m_document.sceneLandmarks().nextUnplaced();
    const auto shown = arrows();
    // After a placement the pointer is on the mark already: it has to come back to it.
    const bool comes = m_isOverCurrent && !wasOver;
    const bool stays = shown && local && (away < kAtMark || axisUnder(*shown, pointer));
    setArrows((comes || stays) && !isNameWaiting ? Arrows::Hovered : Arrows::Hidden);
}

bool LandmarkTool::pressArrow(const QPointF &pointer)
{
    const auto shown = arrows();
    const std::optional<int> axis = shown ? axisUnder(*shown, pointer) : std::nullopt;
    const ray::SceneRays *rays = axis ? m_document.picks().rays() : nullptr;
    if (!rays)
        return false;
    m_dragged = *m_document.sceneLandmarks().current();
    m_axisStart = *m_document.landmarks()[m_dragged].world;
    const auto ray = rays->rays().at(deviceOf(m_document.setup().surface, pointer));
    const std::optional<double> from = ray ? wayAlong(m_axisStart, *axis, *ray) : std::nullopt;
    if (!from)
        return false;
    m_axis = *axis;
    m_axisFrom = *from;
    m_hasMoved = false;
    m_stepAtPress = m_document.undoStack().index();
    m_drag = Drag::Axis;
    return true;
}

void LandmarkTool::dragAlongAxis(const QPointF &local)
{
    m_hasMoved = true; // it is no click, even if it cannot move the landmark
    const ray::SceneRays *rays = m_document.picks().rays();
    if (!rays)
        return;
    const WidgetPoint position = m_view.widgetPosition(local);
    const auto ray = rays->rays().at(deviceFromWidget(m_document.setup().surface, position));
    const std::optional<double> way = ray ? wayAlong(m_axisStart, m_axis, *ray) : std::nullopt;
    if (!way)
        return;
    WorldPoint to = m_axisStart;
    to[m_axis] += *way - m_axisFrom;
    const QScopedValueRollback<bool> moving(m_isMoving, true);
    static_cast<void>(m_document.sceneLandmarks().moveTo(m_dragged, to, m_mergeKey));
}

void LandmarkTool::click(const QPointF &local)
{
    const WidgetPoint position = m_view.widgetPosition(local);
    const std::optional<PixelClick> click = m_view.clickAt(position);
    const std::optional<Landmark> there =
        landmarkOfClick(m_document, position, click ? std::optional(click->sample) : std::nullopt);
    if (there) {
        static_cast<void>(m_document.sceneLandmarks().place(*there));
        m_isOverCurrent = true;
        return;
    }
    QToolTip::showText(m_view.mapToGlobal(local).toPoint(), tr("Background: no surface here"), &m_view);
}

void LandmarkTool::endDrag()
{
    if (m_isMoving || std::exchange(m_drag, Drag::None) == Drag::None)
        return;
    m_drawing.aimLoupe(std::nullopt);
    m_view.endToolDrag();
}

std::vector<std::size_t> LandmarkTool::selectedInView() const
{
    std::vector<std::size_t> shown;
    for (const std::size_t index : m_document.sceneLandmarks().selection()) {
        if (!m_document.landmarks()[index].isHidden)
            shown.push_back(index);
    }
    return shown;
}

bool LandmarkTool::isKey(const QKeyEvent &event) const
{
    const bool isPlain = (event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier)) == Qt::NoModifier;
    if (event.key() == Qt::Key_Escape)
        return isPlain && (m_drag != Drag::None || m_isPlacing);
    if (event.key() == Qt::Key_Delete)
        return isPlain && !selectedInView().empty();
    return m_isPlacing && nudgeOf(event) && visibleCurrent(); // else nothing moves, and keys turn the view
}

void LandmarkTool::pressKey(const QKeyEvent &event, bool isDragged)
{
    if (event.key() == Qt::Key_Escape) {
        if (m_drag == Drag::None) {
            setPlacing(false);
            return;
        }
        endDrag();
        if (m_hasMoved && m_document.undoStack().index() > m_stepAtPress) // not an earlier step
            m_document.undoStack().undo();
        return;
    }
    if (isDragged)
        return; // the mouse is already dragging it
    if (event.key() == Qt::Key_Delete) {
        static_cast<void>(m_document.sceneLandmarks().remove(selectedInView()));
        return;
    }
    nudge(*nudgeOf(event));
}

void LandmarkTool::nudge(const QPointF &way)
{
    // The uncertainty follows the step: moves by tenths of a pixel aim at one of them.
    const double pixels = std::min(1.0, std::abs(way.x()) + std::abs(way.y()));
    SceneLandmarks &landmarks = m_document.sceneLandmarks();
    const std::vector<std::size_t> selected = selectedInView();
    const auto wanted = std::count_if(selected.begin(), selected.end(),
                                      [&](std::size_t index) { return landmarks.all()[index].isPlaced(); });
    std::vector<SceneLandmarks::Move> moves;
    std::optional<QPointF> left;
    std::optional<DevicePoint> aim;
    for (const LandmarkMark &mark : m_drawing.marks()) {
        if (!landmarks.isSelected(mark.index))
            continue;
        DevicePoint to = deviceOf(m_document.setup().surface, mark.at);
        to.x += way.x();
        to.y += way.y();
        const std::optional<Landmark> there = mark.isBehind ? std::nullopt : landmarkOnSurface(m_document, to, pixels);
        if (mark.isBehind && (!left || mark.isCurrent))
            left = m_view.localPosition(WidgetPoint(mark.at.x(), mark.at.y()));
        if (!there)
            continue;
        moves.push_back({mark.index, *there});
        if (mark.isCurrent)
            aim = to;
    }
    QString key = QStringLiteral("nudge");
    for (const SceneLandmarks::Move &move : moves)
        key += u' ' + QString::number(move.index);
    static_cast<void>(landmarks.moveAll(moves, key));
    if (aim) {
        m_drawing.aimLoupe(*aim);
        m_view.reportHover(widgetFromDevice(m_document.setup().surface, *aim));
    }
    const auto unmoved = static_cast<int>(wanted) - static_cast<int>(moves.size());
    if (wanted == 1 && left)
        QToolTip::showText(m_view.mapToGlobal(*left).toPoint(),
                           tr("A surface hides it: turn the view, or go to it (G)."), &m_view);
    else if (wanted > 1 && unmoved > 0)
        tellUnmoved(static_cast<std::size_t>(unmoved), left.value_or(QPointF(m_view.rect().center())));
}

void LandmarkTool::tellUnmoved(std::size_t count, const QPointF &at)
{
    QToolTip::showText(m_view.mapToGlobal(at).toPoint(),
                       tr("Selected landmarks not moved, because they are hidden or outside the view: %1.").arg(count),
                       &m_view);
}

bool LandmarkTool::showMenu(const QPointF &local, const QPoint &global)
{
    const WidgetPoint position = m_view.widgetPosition(local);
    const LandmarkMark *mark = markUnder(m_drawing.marks(), QPointF(position.x, position.y));
    if (!mark)
        return false;
    const std::size_t index = mark->index; // the selection changes the marks
    SceneLandmarks &landmarks = m_document.sceneLandmarks();
    landmarks.select(landmarks.isSelected(index) ? landmarks.selection() : std::vector{index}, index);
    emit menuRequested(global);
    return true;
}

bool LandmarkTool::showTip(const QHelpEvent &event)
{
    if (m_document.landmarks().empty())
        return false;
    const WidgetPoint position = m_view.widgetPosition(QPointF(event.pos()));
    const LandmarkMark *mark = markUnder(m_drawing.marks(), QPointF(position.x, position.y));
    QToolTip::showText(event.globalPos(), mark ? landmarkTip(m_document, *mark) : QString(), &m_view);
    return true;
}

} // namespace unprojector::gui
