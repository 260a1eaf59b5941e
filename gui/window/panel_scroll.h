#pragma once

#include <QScrollArea>

namespace unprojector::gui {

/// A scroll area for a panel: in a small window the panel scrolls instead of keeping the window
/// large; the scroll bar takes no width from it.
class PanelScroll : public QScrollArea {
public:
    explicit PanelScroll(QWidget *panel);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
};

} // namespace unprojector::gui
