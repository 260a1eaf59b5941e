#include "gui/window/panel_scroll.h"

#include <QScrollBar>

#include <algorithm>

namespace unprojector::gui {

PanelScroll::PanelScroll(QWidget *panel)
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setWidget(panel);
}

QSize PanelScroll::sizeHint() const
{
    return {widget()->sizeHint().width() + verticalScrollBar()->sizeHint().width(), QScrollArea::sizeHint().height()};
}

QSize PanelScroll::minimumSizeHint() const
{
    constexpr int kLeastDigits = 20, kLeastLines = 4;
    return {kLeastDigits * fontMetrics().horizontalAdvance(u'0'), kLeastLines * fontMetrics().lineSpacing()};
}

/// Hides the horizontal bar at the panel's least width: Qt can otherwise keep both bars, each for
/// the room that the other takes.
void PanelScroll::resizeEvent(QResizeEvent *event)
{
    const int least = std::max(widget()->minimumWidth(), widget()->minimumSizeHint().width())
                      + verticalScrollBar()->sizeHint().width();
    setHorizontalScrollBarPolicy(width() >= least ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
    QScrollArea::resizeEvent(event);
}

} // namespace unprojector::gui
