// What keys do in the view, at a crosshair.

#include "gui/view/scene_view.h"

#include "core/geometry/angle.h"
#include "gui/document/camera_looks.h"
#include "gui/view/view_keys.h"
#include "gui/view/view_menu.h"
#include "gui/view/view_tool.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
void SceneView::contextMenuEvent(QContextMenuEvent *event)
{
    event->accept();
    if (event->reason() == QContextMenuEvent::Mouse)
        return; // at the release, where it was no drag
    setCrosshairShown(true);
    const WidgetPoint position = widgetFromDevice(m_document.geometry().surface, pixelCenter(crosshair()));
    showViewMenu(*this, m_document, position, mapToGlobal(QPointF(position.x, position.y).toPoint()));
}

DevicePixel SceneView::crosshair() const
{
    const auto &[surface, viewport, depthRange, projection, view] = m_document.geometry();
    const auto isInside = [&surface = surface](const DevicePixel &p) {
        return p.i >= 0 && p.j >= 0 && p.i < surface.widthPixels && p.j < surface.heightPixels;
    };
    if (m_crosshair && isInside(*m_crosshair))
        return *m_crosshair;
    const DevicePoint middle = deviceFromWindow(
        surface, WindowPoint(viewport.x + viewport.width / 2.0, viewport.y + viewport.height / 2.0, 0.0));
    // A viewport may reach beyond the view.
    const auto inside = [](double place, int count) {
        return static_cast<int>(std::clamp(std::floor(place), 0.0, count - 1.0));
    };
    return {inside(middle.x, surface.widthPixels), inside(middle.y, surface.heightPixels)};
}

void SceneView::putCrosshair(const WidgetPoint &position)
{
    if (const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.geometry().surface, position))
        m_crosshair = *pixel;
}

void SceneView::setCrosshairShown(bool isShown)
{
    if (isShown == m_isCrosshairShown)
        return;
    m_isCrosshairShown = isShown;
    update();
}

void SceneView::pickAt(const WidgetPoint &position)
{
    putCrosshair(position);
    onLButtonDown(position);
}

void SceneView::pickPixel(const DevicePixel &pixel)
{
    const WidgetPoint position = widgetFromDevice(m_document.geometry().surface, pixelCenter(pixel));
    putCrosshair(position);
    setCrosshairShown(true);
    update();
    onLButtonDown(position);
}

bool SceneView::event(QEvent *event)
{
    // The view's keys come before the window's shortcuts.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto &key = *static_cast<QKeyEvent *>(event);
        if ((m_tool && m_tool->isKey(key)) || viewKeyOf(key)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip && m_tool && m_tool->showTip(*static_cast<QHelpEvent *>(event)))
        return true;
    return FrameView::event(event);
}

void SceneView::keyPressEvent(QKeyEvent *event)
{
    if (m_tool && m_tool->isKey(*event)) {
        m_tool->pressKey(*event, m_drag != Drag::None);
        return;
    }
    const std::optional<ViewKey> key = viewKeyOf(*event);
    if (!key) {
        FrameView::keyPressEvent(event);
        return;
    }
    if (m_drag != Drag::None)
        return; // a hand is turning already
    setCrosshairShown(true);
    const Surface &surface = m_document.geometry().surface;
    const DevicePixel pixel = crosshair();
    const WidgetPoint position = widgetFromDevice(surface, pixelCenter(pixel));
    switch (key->kind) {
    case ViewKey::Kind::Turn: {
        constexpr double kStep = kPi / 36.0; // 5 degrees
        const WorldPoint pivot = pivotAt(position);
        setCamera(m_document,
                  orbited(m_document.geometry().camera(), pivot, key->way.x() * kStep, key->way.y() * kStep),
                  QStringLiteral("turn by keys"));
        keepPivot(position, pivot);
        return;
    }
    case ViewKey::Kind::Move: {
        constexpr double kShare = 0.05; // of the view's height
        pan(QPointF(key->way) * (kShare * height()), pivotAt(position), QStringLiteral("move by keys"));
        return;
    }
    case ViewKey::Kind::Aim:
        m_crosshair = {std::clamp(pixel.i + key->way.x(), 0, surface.widthPixels - 1),
                       std::clamp(pixel.j + key->way.y(), 0, surface.heightPixels - 1)};
        markAt(widgetFromDevice(surface, pixelCenter(*m_crosshair)));
        reportHover(widgetFromDevice(surface, pixelCenter(*m_crosshair))); // what is looked at is told of
        update();
        return;
    case ViewKey::Kind::Zoom: zoomAt(position, key->notches, QStringLiteral("zoom by keys")); return;
    case ViewKey::Kind::Pick:
        onLButtonDown(position);
        // Told like what is under the mouse: the panel with the numbers may be behind another.
        m_hovered = position;
        requestHover();
        return;
    }
}

void SceneView::focusInEvent(QFocusEvent *event)
{
    FrameView::focusInEvent(event);
    // Whoever comes by a key goes on with keys, and sees where the focus is.
    if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)
        setCrosshairShown(true);
}

void SceneView::focusOutEvent(QFocusEvent *event)
{
    FrameView::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason)
        setCrosshairShown(false);
}

} // namespace unprojector::gui
