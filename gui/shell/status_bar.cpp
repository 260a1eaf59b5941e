#include "gui/shell/status_bar.h"

#include "gui/text/error_text.h"
#include "gui/text/fitted_text.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOption>
#include <QToolTip>

#include <algorithm>

namespace unprojector::gui {

StatusBar::StatusBar(QWidget *parent) : QStatusBar(parent)
{
    // As QMainWindow makes its own: a long read-out doesn't widen the window.
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

QRect StatusBar::messageRoom() const
{
    constexpr int kMargin = 6;
    QRect room = rect().adjusted(kMargin, 0, -kMargin, 0);
    for (const QWidget *widget : findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly)) {
        // During a message only permanent widgets are visible.
        if (widget->isHidden())
            continue;
        if (isRightToLeft())
            room.setLeft(std::max(room.left(), widget->geometry().right() + kMargin));
        else
            room.setRight(std::min(room.right(), widget->x() - kMargin));
    }
    return room;
}

QString StatusBar::shownMessage() const
{
    return elidedSentence(currentMessage(), messageRoom().width(),
                          [metrics = fontMetrics()](const QString &text) { return metrics.horizontalAdvance(text); });
}

bool StatusBar::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip && shownMessage() != currentMessage()) {
        QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), plainToolTip(currentMessage()), this);
        return true;
    }
    return QStatusBar::event(event);
}

void StatusBar::paintEvent(QPaintEvent *event)
{
    if (currentMessage().isEmpty()) {
        QStatusBar::paintEvent(event);
        return;
    }
    QPainter painter(this);
    QStyleOption option;
    option.initFrom(this);
    style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, this);
    painter.setPen(palette().windowText().color());
    painter.drawText(messageRoom(), Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine, shownMessage());
}

} // namespace unprojector::gui
