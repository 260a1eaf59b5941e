#pragma once

#include <QString>
#include <QWidget>

class QToolButton;

namespace unprojector::gui {

/// A heading that opens and closes the content below it. Closed at first.
class Fold : public QWidget {
    Q_OBJECT
public:
    /// @param content     shown while the fold is open
    /// @param helpAnchor  of the "?" beside the heading; empty: none
    Fold(const QString &title, const QString &toolTip, QWidget *content, const QString &helpAnchor = {},
         QWidget *parent = nullptr);

    bool isOpen() const;
    void setOpen(bool isOpen);

signals:
    void toggled(bool isOpen);

private:
    /// Scrolls what is around it to what it has opened.
    void bringIntoSight();

    QToolButton *m_head;
};

} // namespace unprojector::gui
