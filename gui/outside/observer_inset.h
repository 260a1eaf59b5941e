#pragma once

#include <QFrame>

namespace unprojector::gui {

class ObserverPanel;

/// The view from outside in a corner of the view, which keeps its size and aspect. Dragging its own
/// corner enlarges it. The observer adapts, unless the user has moved it before.
class ObserverInset : public QFrame {
public:
    /// @param area  in whose corner it is placed
    /// @param share  of the area's width and height; empty: the default
    ObserverInset(ObserverPanel &observer, QWidget &area, const QSizeF &share);

    /// Its size as a share of the area's width and height.
    const QSizeF &share() const { return m_share; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

private:
    void place();

    QWidget &m_area;
    QSizeF m_share; ///< of the area
    QPoint m_grabbed;
    bool m_isResizing = false;
};

} // namespace unprojector::gui
