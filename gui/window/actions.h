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

/// The name of the action that asks for the view's size: panels that show the size link to it.
inline constexpr QLatin1String kViewSizeAction("viewSize");

/// The name of the action that pastes another program's camera.
inline constexpr QLatin1String kPasteCameraAction("pasteCamera");

/// Triggers the action of this name, in any menu.
void trigger(const QObject &window, QLatin1String name);

/// Appends an action to a menu, with its tip and key in the tooltip and its tip in the status bar.
QAction *addAction(QMenu &menu, const QString &text, const QKeySequence &key, const QString &tip,
                   std::function<void()> slot = {});
/// The same for a checkable action.
QAction *addSwitch(QMenu &menu, const QString &text, const QKeySequence &key, const QString &tip);
/// Adds an action to the tool bar too, as a drawing with its name in the tooltip.
void putOnBar(QToolBar &bar, QAction &action, Drawing drawing);

} // namespace unprojector::gui
