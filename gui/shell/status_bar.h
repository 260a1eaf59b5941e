#pragma once

#include <QStatusBar>

namespace unprojector::gui {

/// A status bar whose message ends in "…" if there is no room for all of it; the tooltip then
/// shows all. Qt's own cuts the message.
class StatusBar : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusBar(QWidget *parent = nullptr);

    /// The room of a message: up to the permanent widgets.
    QRect messageRoom() const;
    /// The message as shown in its room.
    QString shownMessage() const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
};

} // namespace unprojector::gui
