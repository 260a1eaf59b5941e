// What keys do in the view, at a crosshair.

#include "gui/view/scene_view.h"

#include "core/geometry/angle.h"
#include "gui/document/camera_looks.h"
#include "gui/view/view_tool.h"

#include <QHelpEvent>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

/// What the view does at a key.
struct KeyDeed {
    enum class Kind { Turn, Move, Aim, Zoom, Pick };
    Kind kind = Kind::Pick;
    QPoint way = {}; ///< of an arrow, x to the right and y down; of Aim in device pixels
    int notches = 0; ///< of Zoom
};

std::optional<QPoint> arrowOf(int key)
{
    switch (key) {
    case Qt::Key_Left: return QPoint(-1, 0);
    case Qt::Key_Right: return QPoint(1, 0);
    case Qt::Key_Up: return QPoint(0, -1);
    case Qt::Key_Down: return QPoint(0, 1);
    default: return std::nullopt;
    }
}

std::optional<KeyDeed> deedOf(const QKeyEvent &event)
{
    using Kind = KeyDeed::Kind;
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
    if (const std::optional<QPoint> arrow = arrowOf(event.key())) {
        constexpr int kFarPixels = 10;
        if (modifiers == Qt::NoModifier)
            return KeyDeed{Kind::Turn, *arrow};
        if (modifiers == Qt::ShiftModifier)
            return KeyDeed{Kind::Move, *arrow};
        if (modifiers == Qt::ControlModifier)
            return KeyDeed{Kind::Aim, *arrow};
        if (modifiers == (Qt::ControlModifier | Qt::ShiftModifier))
            return KeyDeed{Kind::Aim, *arrow * kFarPixels};
        return std::nullopt;
    }
    if ((modifiers & ~Qt::KeyboardModifiers(Qt::ShiftModifier)) != Qt::NoModifier) // many keyboards have + on Shift
        return std::nullopt;
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_PageUp: return KeyDeed{Kind::Zoom, {}, 1};
    case Qt::Key_Minus:
    case Qt::Key_PageDown: return KeyDeed{Kind::Zoom, {}, -1};
    case Qt::Key_Return:
    case Qt::Key_Enter: return KeyDeed{Kind::Pick};
    default: return std::nullopt;
    }
}

} // namespace

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
        if ((m_tool && m_tool->isKey(key)) || deedOf(key)) {
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
    const std::optional<KeyDeed> deed = deedOf(*event);
    if (!deed) {
        FrameView::keyPressEvent(event);
        return;
    }
    if (m_drag != Drag::None)
        return; // a hand is turning already
    setCrosshairShown(true);
    const Surface &surface = m_document.geometry().surface;
    const DevicePixel pixel = crosshair();
    const WidgetPoint position = widgetFromDevice(surface, pixelCenter(pixel));
    switch (deed->kind) {
    case KeyDeed::Kind::Turn: {
        constexpr double kStep = kPi / 36.0; // 5 degrees
        const WorldPoint pivot = pivotAt(position);
        setCamera(m_document,
                  orbited(m_document.geometry().camera(), pivot, deed->way.x() * kStep, deed->way.y() * kStep),
                  QStringLiteral("turn by keys"));
        keepPivot(position, pivot);
        return;
    }
    case KeyDeed::Kind::Move: {
        constexpr double kShare = 0.05; // of the view's height
        pan(QPointF(deed->way) * (kShare * height()), pivotAt(position), QStringLiteral("move by keys"));
        return;
    }
    case KeyDeed::Kind::Aim:
        m_crosshair = {std::clamp(pixel.i + deed->way.x(), 0, surface.widthPixels - 1),
                       std::clamp(pixel.j + deed->way.y(), 0, surface.heightPixels - 1)};
        markAt(widgetFromDevice(surface, pixelCenter(*m_crosshair)));
        reportHover(widgetFromDevice(surface, pixelCenter(*m_crosshair))); // what is looked at is told of
        update();
        return;
    case KeyDeed::Kind::Zoom: zoomAt(position, deed->notches, QStringLiteral("zoom by keys")); return;
    case KeyDeed::Kind::Pick:
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
