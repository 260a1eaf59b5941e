#pragma once

#include <QFrame>

namespace unprojector::gui {

class ObserverPanel;

/// The view from outside in a corner of the view: it stands over it and leaves its size and its aspect alone. Its own corner
/// is drawn to make it larger. The observer goes with it, unless it was put elsewhere before.
class ObserverInset : public QFrame {
public:
    /// @param area  the corner of which it stands in
    /// @param share  of the area's width and height; an empty one: as it is at first
    ObserverInset(ObserverPanel &observer, QWidget &area, const QSizeF &share);

    /// What it was drawn to, of the area's width and height.
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
