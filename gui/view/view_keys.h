#pragma once

#include <QPoint>

#include <optional>

class QKeyEvent;

namespace unprojector::gui {

/// The view's action for a key.
struct ViewKey {
    enum class Kind { Turn, Move, Aim, Zoom, Pick };
    Kind kind = Kind::Pick;
    QPoint way = {}; ///< of an arrow, x to the right and y down; for Aim in device pixels
    int notches = 0; ///< for Zoom
};

/// @return nothing for a key without an action
std::optional<ViewKey> viewKeyOf(const QKeyEvent &event);

} // namespace unprojector::gui
