#pragma once

#include <QScrollArea>

namespace unprojector::gui {

/// On a small window the panel within scrolls, instead of holding the window open; a bar beside it takes nothing of its width.
class PanelScroll : public QScrollArea {
public:
    explicit PanelScroll(QWidget *panel);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
};

} // namespace unprojector::gui
