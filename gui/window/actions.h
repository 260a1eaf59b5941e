#pragma once

#include "gui/widgets/icons.h"

#include <QKeySequence>
#include <QString>

#include <functional>

class QAction;
class QMenu;
class QToolBar;

namespace unprojector::gui {

/// An action at the end of a menu, with its tip and its key in the tool tip and its tip in the status bar.
QAction *addAction(QMenu &menu, const QString &text, const QKeySequence &key, const QString &tip,
                   std::function<void()> slot = {});
/// The same for one that can be on and off.
QAction *addSwitch(QMenu &menu, const QString &text, const QKeySequence &key, const QString &tip);
/// Puts an action onto the tool bar too, as a drawing with its name in the tool tip.
void putOnBar(QToolBar &bar, QAction &action, Drawing drawing);

} // namespace unprojector::gui
