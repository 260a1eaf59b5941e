#pragma once

#include <QObject>
#include <QPointer>

#include <vector>

class QWidget;

namespace unprojector::gui {

/// Gives the keyboard focus back to the view after a control was used by mouse, so that single
/// keys act on the view again:
/// - after the click of a button, of a spin box's arrow and of a menu or combo box's item;
/// - after Enter or Esc in a field, and after Esc in a list;
/// - after the double click of a list's row, unless it opens an editor.
///
/// A field keeps the focus while the user types. A list keeps it, too: arrow keys go through its
/// rows. So do buttons and combo boxes that the user has reached by Tab.
class FocusReturn : public QObject {
    Q_OBJECT
public:
    /// @param areas  the widgets whose controls give the focus back
    FocusReturn(QWidget &view, std::vector<QWidget *> areas);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Returns whether a control in one of the areas, in the view's window, but not the view itself.
    bool isControl(const QWidget &widget) const;
    /// Gives the focus back once the control has processed the event, if nothing else took it.
    void giveBackAfter(QWidget &control);

    QWidget &m_view;
    std::vector<QWidget *> m_areas;
    QPointer<QWidget> m_clicked; ///< the control that got the focus by mouse
};

} // namespace unprojector::gui
