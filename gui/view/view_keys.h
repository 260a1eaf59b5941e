#pragma once

#include <QPoint>

#include <optional>

class QKeyEvent;

namespace unprojector::gui {

/// What the view does at a key.
struct ViewKey {
    enum class Kind { Turn, Move, Aim, Zoom, Pick };
    Kind kind = Kind::Pick;
    QPoint way = {}; ///< of an arrow, x to the right and y down; of Aim in device pixels
    int notches = 0; ///< of Zoom
};

/// @return nothing for a key that is none of the view's
std::optional<ViewKey> viewKeyOf(const QKeyEvent &event);

} // namespace unprojector::gui
