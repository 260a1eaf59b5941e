#include "gui/outside/observer_view.h"

#include "core/geometry/angle.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// What a hand does to the observer view.

namespace unprojector::gui {
namespace {

/// The keys that this view takes before the window's shortcuts see them.
bool isOwnKey(const QKeyEvent &event)
{
    if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier)
        return false;
    switch (event.key()) {
    case Qt::Key_F:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus: return true;
    default: return false;
    }
}

} // namespace

std::optional<ClipPlaneDrag> ObserverView::planeAt(const QPointF &position) const
{
    const std::optional<ObserverPicture> p = picture();
    if (!p)
        return std::nullopt;
    glm::dmat4 widgetFromClip(1.0);
    widgetFromClip[0][0] = width() / 2.0;
    widgetFromClip[1][1] = -height() / 2.0;
    widgetFromClip[3] = {width() / 2.0, height() / 2.0, 0.0, 1.0};
    const glm::dmat4 widgetFromEye = widgetFromClip * p->clipFromDrawn * p->drawnFromEye;

    constexpr double kReachPixels = 6.0;
    const glm::dvec2 pointer(position.x(), position.y());
    double closest = kReachPixels;
    std::optional<ClipPlaneDrag> found;
    constexpr std::array<std::array<std::size_t, 2>, 4> kEdges{{{0, 1}, {1, 3}, {3, 2}, {2, 0}}};
    for (const ClipPlane plane : {ClipPlane::Near, ClipPlane::Far}) {
        const std::size_t first = plane == ClipPlane::Near ? 0 : 4;
        for (const auto &edge : kEdges) {
            const glm::dvec3 from = p->corners[first + edge[0]].coordinates(),
                             to = p->corners[first + edge[1]].coordinates();
            const glm::dvec4 a = widgetFromEye * glm::dvec4(from, 1.0), b = widgetFromEye * glm::dvec4(to, 1.0);
            if (!(a.w > 0.0) || !(b.w > 0.0))
                continue;
            const glm::dvec2 pixelA = glm::dvec2(a) / a.w, along = glm::dvec2(b) / b.w - pixelA;
            const double length = glm::dot(along, along);
            const double share = length > 0.0 ? std::clamp(glm::dot(pointer - pixelA, along) / length, 0.0, 1.0) : 0.0;
            const double distance = glm::length(pointer - pixelA - along * share);
            if (!(distance < closest))
                continue;
            // Back from the share of the edge in the picture to that of the edge itself.
            const double s = share * a.w / (share * a.w + (1.0 - share) * b.w);
            const ClipPlaneDrag drag(p->projection, plane, EyePoint(from * (1.0 - s) + to * s), widgetFromEye, pointer);
            // Seen from straight ahead a plane does not move in the picture.
            constexpr double kLeastPixels = 12.0;
            const ProjectionWindow w = projectionWindow(p->projection);
            if (glm::length(drag.pixelsPerUnit()) * (w.farDistance - w.nearDistance) < kLeastPixels)
                continue;
            closest = distance;
            found = drag;
        }
    }
    return found;
}

void ObserverView::setHotPlane(const std::optional<ClipPlaneDrag> &drag)
{
    const std::optional<ClipPlane> plane = drag ? std::optional(drag->plane()) : std::nullopt;
    if (drag) {
        const glm::dvec2 rate = drag->pixelsPerUnit();
        setCursor(std::abs(rate.x) >= std::abs(rate.y) ? Qt::SizeHorCursor : Qt::SizeVerCursor);
    } else {
        unsetCursor();
    }
    if (plane == m_hotPlane)
        return;
    m_hotPlane = plane;
    update();
}

void ObserverView::dragPlane(const QPointF &position)
{
    const Scene &scene = m_document.scene();
    const std::optional<Projection> projection =
        m_planeDrag->projectionAt(scene.projection, {position.x(), position.y()});
    if (!projection)
        return;
    // A step that would leave no valid picture is not taken.
    static_cast<void>(m_document.edit(
        {m_planeDrag->plane() == ClipPlane::Near ? tr("Near plane") : tr("Far plane"), m_gesture}, [&](Scene &changed) {
            changed.projection = *projection;
            changed.clipDistancesFitObjects = false;
        }));
}

void ObserverView::orbit(double yawRadians, double pitchRadians)
{
    m_observer.camera() = orbited(m_observer.camera(), m_observer.camera().center, yawRadians, pitchRadians);
    m_isTouched = true;
    update();
}

void ObserverView::zoom(const QPointF &position, double factor)
{
    const Result<EyeFrame> frame = eyeFrame(m_observer.camera());
    if (!frame)
        return;
    // The point under the pointer at the depth of the centre keeps its place.
    const double scale = worldPerLogicalPixel(m_observer, m_observer.camera().center);
    const WorldPoint anchor = m_observer.camera().center + frame->side * ((position.x() - width() / 2.0) * scale)
                              - frame->upward * ((position.y() - height() / 2.0) * scale);
    Picture next = zoomed(m_observer, anchor, factor);
    // Closer than this the picture would lose its digits, farther off it shows nothing.
    const double away = distance(next.camera().center, next.camera().eye);
    if (away < 1e-3 * m_reference.scale || away > 1e3 * m_reference.scale || !check(next))
        return;
    m_observer.camera() = next.camera();
    m_isTouched = true;
    update();
}

bool ObserverView::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && isOwnKey(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    const bool isHandled = QOpenGLWidget::event(event);
    // Shown in another place of the window it has got a new, empty framebuffer, and Qt paints what lies over the window's
    // own picture only when it is asked to.
    if (event->type() == QEvent::Show)
        update();
    return isHandled;
}

void ObserverView::mousePressEvent(QMouseEvent *event)
{
    const bool pans = event->button() == Qt::MiddleButton
                      || (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ShiftModifier));
    if (m_drag != Drag::None || (!pans && event->button() != Qt::LeftButton))
        return;
    m_lastPosition = event->position();
    m_gesture = QStringLiteral("observer drag %1").arg(++m_gestureCount);
    m_planeDrag = pans ? std::nullopt : planeAt(event->position());
    setHotPlane(m_planeDrag);
    m_drag = pans ? Drag::Pan : m_planeDrag ? Drag::Plane : Drag::Orbit;
}

void ObserverView::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF delta = event->position() - m_lastPosition;
    m_lastPosition = event->position();
    switch (m_drag) {
    case Drag::None: setHotPlane(planeAt(event->position())); return;
    case Drag::Plane:
        if (!delta.isNull())
            dragPlane(event->position());
        return;
    case Drag::Orbit: {
        // Half a turn for the height of the view.
        const double radiansPerPixel = kPi / std::max(1, height());
        orbit(delta.x() * radiansPerPixel, delta.y() * radiansPerPixel);
        return;
    }
    case Drag::Pan: {
        const Result<EyeFrame> frame = eyeFrame(m_observer.camera());
        if (!frame)
            return;
        const double scale = worldPerLogicalPixel(m_observer, m_observer.camera().center);
        m_observer.camera() = moved(m_observer.camera(), (frame->upward * delta.y() - frame->side * delta.x()) * scale);
        m_isTouched = true;
        update();
        return;
    }
    }
}

void ObserverView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->buttons() != Qt::NoButton)
        return;
    m_drag = Drag::None;
    m_planeDrag.reset();
    setHotPlane(rect().contains(event->position().toPoint()) ? planeAt(event->position()) : std::nullopt);
}

void ObserverView::mouseDoubleClickEvent(QMouseEvent *event)
{
    mousePressEvent(event); // two quick drags are no double click
}

void ObserverView::wheelEvent(QWheelEvent *event)
{
    zoom(event->position(), std::pow(1.2, event->angleDelta().y() / 120.0));
    setHotPlane(planeAt(event->position()));
    event->accept();
}

void ObserverView::keyPressEvent(QKeyEvent *event)
{
    if (!isOwnKey(*event)) {
        QOpenGLWidget::keyPressEvent(event);
        return;
    }
    constexpr double kStep = kPi / 36.0; // 5 degrees
    constexpr double kZoom = 1.2;
    const QPointF middle(width() / 2.0, height() / 2.0);
    switch (event->key()) {
    case Qt::Key_F: fit(); break;
    case Qt::Key_Left: orbit(-kStep, 0.0); break;
    case Qt::Key_Right: orbit(kStep, 0.0); break;
    case Qt::Key_Up: orbit(0.0, -kStep); break;
    case Qt::Key_Down: orbit(0.0, kStep); break;
    case Qt::Key_Minus: zoom(middle, 1.0 / kZoom); break;
    default: zoom(middle, kZoom); break;
    }
}

void ObserverView::leaveEvent(QEvent *event)
{
    QOpenGLWidget::leaveEvent(event);
    if (m_drag == Drag::None)
        setHotPlane(std::nullopt);
}

} // namespace unprojector::gui
