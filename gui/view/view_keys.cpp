#include "gui/view/view_keys.h"

#include <QKeyEvent>

namespace unprojector::gui {
namespace {

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

} // namespace

std::optional<ViewKey> viewKeyOf(const QKeyEvent &event)
{
    using Kind = ViewKey::Kind;
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
    if (const std::optional<QPoint> arrow = arrowOf(event.key())) {
        constexpr int kFarPixels = 10;
        if (modifiers == Qt::NoModifier)
            return ViewKey{Kind::Turn, *arrow};
        if (modifiers == Qt::ShiftModifier)
            return ViewKey{Kind::Move, *arrow};
        if (modifiers == Qt::ControlModifier)
            return ViewKey{Kind::Aim, *arrow};
        if (modifiers == (Qt::ControlModifier | Qt::ShiftModifier))
            return ViewKey{Kind::Aim, *arrow * kFarPixels};
        return std::nullopt;
    }
    if ((modifiers & ~Qt::KeyboardModifiers(Qt::ShiftModifier)) != Qt::NoModifier) // many keyboards have + on Shift
        return std::nullopt;
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_PageUp: return ViewKey{Kind::Zoom, {}, 1};
    case Qt::Key_Minus:
    case Qt::Key_PageDown: return ViewKey{Kind::Zoom, {}, -1};
    case Qt::Key_Return:
    case Qt::Key_Enter: return ViewKey{Kind::Pick};
    default: return std::nullopt;
    }
}

} // namespace unprojector::gui
