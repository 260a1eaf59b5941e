#pragma once

class QAction;

namespace unprojector::gui {

/// Makes the tooltip of an action plain text: markup in names is shown literally.
void keepToolTipPlain(QAction *action);

} // namespace unprojector::gui
