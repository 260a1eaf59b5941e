#include "gui/window/actions.h"

#include <QAction>
#include <QMenu>
#include <QRegularExpression>
#include <QToolBar>

#include <utility>

namespace unprojector::gui {

void trigger(const QObject &window, QLatin1String name)
{
    if (auto *action = window.findChild<QAction *>(name))
        action->trigger();
}

QAction *addAction(QMenu &menu, const QString &text, const QKeySequence &key, const QString &tip,
                   std::function<void()> slot)
{
    QAction *action = menu.addAction(text);
    // Buttons of the tool bar have no key in parentheses: "打开(&O)…" is "打开…".
    static const QRegularExpression keyInParentheses(QStringLiteral("\\(&.\\)"));
    action->setIconText(QString(text).remove(keyInParentheses).remove(u'&'));
    action->setShortcut(key);
    action->setToolTip(key.isEmpty() ? tip
                                     : QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
    action->setStatusTip(tip);
    if (slot)
        QObject::connect(action, &QAction::triggered, action, std::move(slot));
    return action;
}

QAction *addSwitch(QMenu &menu, const QString &text, const QKeySequence &key, const QString &tip)
{
    QAction *action = addAction(menu, text, key, tip);
    action->setCheckable(true);
    return action;
}

void putOnBar(QToolBar &bar, QAction &action, Drawing drawing)
{
    action.setIcon(drawnIcon(drawing));
    action.setIconVisibleInMenu(false);
    bar.addAction(&action);
}

} // namespace unprojector::gui
