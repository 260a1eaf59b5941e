// What the mouse does in the view.

#include "gui/view/scene_view.h"

#include "core/geometry/angle.h"
#include "gui/document/camera_looks.h"
#include "gui/view/view_menu.h"
#include "gui/view/view_tool.h"

#include <QApplication>
#include <QMimeData>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
namespace {

/// A hand that only clicks trembles: it drags from the desktop's distance on.
bool isDrag(const QPointF &way)
{
    return std::abs(way.x()) + std::abs(way.y()) >= QApplication::startDragDistance();
}

} // namespace

WidgetPoint SceneView::widgetPosition(const QPointF &local) const
{
    const QPointF corner = mapTo(window(), QPointF(0.0, 0.0));
    return widgetOnSurface(currentSurface(), WidgetPoint(local.x(), local.y()), WidgetPoint(corner.x(), corner.y()));
}

void SceneView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::RightButton && m_drag == Drag::None)
        m_menuPosition = event->position();
    const bool pans = event->button() == Qt::MiddleButton
                      || (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ShiftModifier));
    if (m_drag != Drag::None || (!pans && event->button() != Qt::LeftButton))
        return;
    m_lastPosition = event->position();
    m_hasMoved = false;
    m_gesture = QStringLiteral("drag %1").arg(++m_gestureCount);
    const WidgetPoint position = widgetPosition(event->position());
    setCrosshairShown(false);
    const ViewTool::Press pressed = pans || !m_tool ? ViewTool::Press::Passed : m_tool->press(*event, m_gesture);
    if (pressed == ViewTool::Press::Drags) {
        m_drag = Drag::Tool;
        return;
    }
    m_toolTakesClick = pressed == ViewTool::Press::Passed && !pans && m_tool && m_tool->takesClicks();
    if (pans || m_toolTakesClick || pressed == ViewTool::Press::Navigates) {
        m_pivot = pivotAt(position);
    } else {
        m_pivot = m_document.geometry().camera().center; // where nothing can be read
        m_formerPick = m_document.keptPick();
        pickAt(position);
    }
    m_drag = pans ? Drag::Pan : Drag::Orbit;
}

void SceneView::mouseMoveEvent(QMouseEvent *event)
{
    if (m_menuPosition && isDrag(event->position() - *m_menuPosition))
        m_menuPosition.reset();
    const QPointF delta = event->position() - m_lastPosition;
    if (m_drag != Drag::None && !m_hasMoved) {
        if (!isDrag(delta))
            return;
        // A drag it is and not a click: what the press has picked goes, and what was picked before comes back.
        if (const std::optional<KeptPick> former = std::exchange(m_formerPick, std::nullopt))
            m_document.putBack(*former);
    }
    m_hasMoved = true;
    m_lastPosition = event->position();
    switch (m_drag) {
    case Drag::None:
        if (event->buttons() == Qt::NoButton)
            reportHover(event->position());
        if (m_tool && event->buttons() == Qt::NoButton)
            m_tool->hover(event->position());
        return;
    case Drag::Orbit: {
        // Half a turn for the height of the view.
        const double radiansPerPixel = kPi / std::max(1, height());
        setCamera(
            m_document,
            orbited(m_document.geometry().camera(), m_pivot, delta.x() * radiansPerPixel, delta.y() * radiansPerPixel),
            m_gesture);
        return;
    }
    case Drag::Pan: pan(delta, m_pivot, m_gesture); return;
    case Drag::Tool: m_tool->dragTo(event->position()); return;
    }
}

void SceneView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::RightButton) {
        const std::optional<QPointF> position = std::exchange(m_menuPosition, std::nullopt);
        if (position && m_drag == Drag::None)
            showViewMenu(*this, m_document, widgetPosition(*position), event->globalPosition().toPoint());
    }
    if (event->buttons() != Qt::NoButton)
        return;
    if (m_tool && m_drag != Drag::None)
        m_tool->release(event->position());
    const bool isClick = std::exchange(m_drag, Drag::None) != Drag::None && !m_hasMoved;
    if (std::exchange(m_toolTakesClick, false) && isClick)
        m_tool->click(event->position());
    m_formerPick.reset();
    if (rect().contains(event->position().toPoint()))
        reportHover(event->position());
}

void SceneView::reportHover(const QPointF &local)
{
    markAt(widgetPosition(local));
    reportHover(widgetPosition(local));
}

void SceneView::reportHover(const WidgetPoint &position)
{
    m_pointed = m_hovered = position;
    requestHover();
}

void SceneView::markAt(const WidgetPoint &position)
{
    const ray::Snap snap = m_document.snap();
    const ray::SceneRays *rays = snap == ray::Snap::Surface ? nullptr : m_document.rays();
    const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.geometry().surface, position);
    if (!rays || !pixel) {
        clearMark();
        return;
    }
    const Result<std::optional<ray::SceneHit>> hit = rays->at(pixelCenter(*pixel), snap);
    if (!hit || !*hit) {
        clearMark();
        return;
    }
    m_mark = {snap, **hit, {}};
    if (m_mark->hit.triangle)
        m_mark->corners = rays->corners(m_mark->hit);
    update();
}

void SceneView::clearMark()
{
    if (std::exchange(m_mark, std::nullopt))
        update();
}

void SceneView::requestHover()
{
    // A request under way is not overtaken, or a pointer that never rests would never be answered. A picture that is
    // about to be drawn, or drawn on, is not drawn for the pointer's sake: it asks again.
    if (!isReady() || !m_hovered || m_isStale || isCoarse() || frame().isRequested())
        return;
    const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.geometry().surface, *m_hovered);
    const std::optional<WidgetPoint> position = std::exchange(m_hovered, std::nullopt);
    if (!pixel)
        return;
    m_requested = {*position, *pixel, {}};
    makeCurrent();
    frame().request(*pixel);
    doneCurrent();
    m_hoverTimer.start(0);
}

void SceneView::takeHover()
{
    constexpr int kPollMilliseconds = 2;
    if (!isReady() || !m_requested)
        return;
    makeCurrent();
    const std::optional<DepthSample> sample = frame().takeRequested();
    doneCurrent();
    if (frame().isRequested()) {
        m_hoverTimer.start(kPollMilliseconds);
        return;
    }
    PixelClick click = *std::exchange(m_requested, std::nullopt);
    if (m_isStale) { // the answer is of a picture that is past: the next one is asked
        m_hovered = m_hovered.value_or(click.position);
        return;
    }
    if (sample) {
        click.sample = withDot(*sample);
        emit hovered(click);
    }
    requestHover();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (m_drag != Drag::None || event->button() != Qt::LeftButton)
        return;
    if (m_tool && m_tool->takesClicks()) { // two clicks, one soon after the other
        mousePressEvent(event);
        return;
    }
    const std::optional<PixelClick> click = clickAt(widgetPosition(event->position()));
    if (!click || !click->sample.hit())
        return;
    const Result<Pick> pick = m_document.unprojected(*click);
    m_document.setPick(pick);
    setCamera(m_document, recentered(m_document.geometry(), pivotOf(m_document.geometry().camera(), pick)));
}

void SceneView::wheelEvent(QWheelEvent *event)
{
    if (event->angleDelta().y() == 0)
        return; // sideways
    setCrosshairShown(false);
    zoomAt(widgetPosition(event->position()), event->angleDelta().y() / 120.0, QStringLiteral("wheel"));
    reportHover(event->position());
    event->accept();
}

WorldPoint SceneView::pivotAt(const WidgetPoint &position)
{
    // Steps can come faster than pictures. What is turned about or zoomed to stays in its place, so nothing is drawn to
    // read it again.
    if (m_stillPivot && m_stillPosition == position)
        return *m_stillPivot;
    const std::optional<PixelClick> click = clickAt(position);
    return click ? pivotOf(m_document.geometry().camera(), m_document.unprojected(*click))
                 : m_document.geometry().camera().center;
}

void SceneView::keepPivot(const WidgetPoint &position, const WorldPoint &pivot)
{
    m_stillPosition = position;
    m_stillPivot = pivot;
}

void SceneView::zoomAt(const WidgetPoint &position, double notches, const QString &mergeKey)
{
    const WorldPoint pivot = pivotAt(position);
    const Picture next = zoomed(m_document.geometry(), pivot, std::pow(1.2, notches));
    setView(m_document, next.camera(), next.projection(), mergeKey);
    keepPivot(position, pivot);
}

void SceneView::pan(const QPointF &way, const WorldPoint &pivot, const QString &mergeKey)
{
    const Picture &g = m_document.geometry();
    const Result<EyeFrame> frame = eyeFrame(g.camera());
    if (!frame)
        return;
    const double scale = worldPerLogicalPixel(g, pivot);
    setCamera(m_document, moved(g.camera(), (frame->upward * way.y() - frame->side * way.x()) * scale), mergeKey);
}

void SceneView::leaveEvent(QEvent *event)
{
    FrameView::leaveEvent(event);
    m_hovered.reset();
    m_pointed.reset();
    clearMark();
    if (m_tool && m_drag == Drag::None)
        m_tool->hover(std::nullopt);
    if (m_requested) {
        m_requested.reset();
        makeCurrent();
        frame().dropRequest();
        doneCurrent();
    }
    emit pointerLeft();
}

void SceneView::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void SceneView::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    emit filesDropped(event->mimeData()->urls());
}

} // namespace unprojector::gui
