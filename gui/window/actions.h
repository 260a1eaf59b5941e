#pragma once

#include "gui/widgets/icons.h"

#include <QKeySequence>
#include <QLatin1String>
#include <QString>

#include <functional>

class QAction;
class QMenu;
class QObject;
class QToolBar;

namespace unprojector::gui {

/// The name of the action that asks for the view's size: panels that show the size lead to it.
inline constexpr QLatin1String kViewSizeAction("viewSize");

/// Triggers the action of this name, wherever it stands.
void trigger(const QObject &window, QLatin1String name);

/// An action at the end of a menu, with its tip and its key in the tool tip and its tip in the status bar.
QAction *addAction(QMenu &menu, const QString &text, const QKeySequence &key, const QString &tip,
                   std::function<void()> slot = {});
/// The same for one that can be on and off.
QAction *addSwitch(QMenu &menu, const QString &text, const QKeySequence &key, const QString &tip);
/// Puts an action onto the tool bar too, as a drawing with its name in the tool tip.
void putOnBar(QToolBar &bar, QAction &action, Drawing drawing);

} // namespace unprojector::gui
