#pragma once

#include <QSize>
#include <QWidget>

class QGridLayout;
class QVBoxLayout;

namespace unprojector::gui {

/// The view in the middle of the window, and what stands over it. Beside what stands over it the view is clicked.
class ViewFrame : public QWidget {
public:
    explicit ViewFrame(QWidget &view);

    /// Puts a widget over the whole width of the view, below those that were added before.
    void addBar(QWidget &bar);
    /// Puts a widget into the upper left corner, below the bars.
    void addNote(QWidget &note);
    /// Puts a widget over the view, aligned within it.
    void add(QWidget &widget, Qt::Alignment alignment);

    /// Lets the view be no larger than this, in the middle of the frame; not valid: it fills the frame.
    /// @param size  logical pixels
    void limitView(const QSize &size);

private:
    QWidget &m_view;
    QGridLayout *m_layout;
    QVBoxLayout *m_bars;
};

} // namespace unprojector::gui
