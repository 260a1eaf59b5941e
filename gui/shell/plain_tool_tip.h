#pragma once

class QAction;

namespace unprojector::gui {

/// Keeps the tool tip of an action as its text is, for one with names in it: what looks like markup there is shown as it is
/// written.
void keepToolTipPlain(QAction *action);

} // namespace unprojector::gui
