#pragma once

#include <QSize>
#include <QWidget>

class QGridLayout;
class QVBoxLayout;

namespace unprojector::gui {

/// The view in the middle of the window, with widgets over it. The view receives clicks beside
/// those widgets.
class ViewFrame : public QWidget {
public:
    explicit ViewFrame(QWidget &view);

    /// Adds a widget over the whole width of the view, below those added before.
    void addBar(QWidget &bar);
    /// Adds a widget in the upper left corner, below the bars.
    void addNote(QWidget &note);
    /// Adds a widget over the view, aligned within it.
    void add(QWidget &widget, Qt::Alignment alignment);

    /// Limits the view's size and centres it in the frame; invalid: it fills the frame.
    /// @param size  logical pixels
    void limitView(const QSize &size);

private:
    QWidget &m_view;
    QGridLayout *m_layout;
    QVBoxLayout *m_bars;
};

} // namespace unprojector::gui
