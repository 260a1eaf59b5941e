#include "gui/shell/plain_tool_tip.h"

#include "gui/text/error_text.h"

#include <QAction>

namespace unprojector::gui {

void keepToolTipPlain(QAction *action)
{
    const auto follow = [action] {
        const QString tip = plainToolTip(action->text().remove(u'&'));
        if (action->toolTip() != tip)
            action->setToolTip(tip);
    };
    QObject::connect(action, &QAction::changed, action, follow);
    follow();
}

} // namespace unprojector::gui
