#pragma once

#include <QWidget>

class QToolButton;

namespace unprojector::gui {

class HelpLink;

/// The heading of a folding group: a click, Space or Enter folds and unfolds it, Left folds, Right
/// unfolds, Up and Down ask for another heading. A button at its end resets the group to its
/// defaults.
class GroupHeading : public QWidget {
    Q_OBJECT
public:
    GroupHeading(const QString &title, const QString &help, const QString &resetHelp, QWidget *parent = nullptr);

    bool isOpen() const { return m_isOpen; }
    void setOpen(bool isOpen);
    /// Sets the anchor of the group's formulas in the help; without it the heading has no link.
    void setHelp(const QString &anchor);
    /// The widget of the heading with the keyboard focus.
    QToolButton *button() const { return m_fold; }

signals:
    void openChanged(bool isOpen);
    void resetRequested();
    /// Emitted when the previous (-1) or next (+1) heading should get the focus.
    void neighbourRequested(int direction);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QToolButton *m_fold;
    QToolButton *m_reset;
    HelpLink *m_help;
    bool m_isOpen = true;
};

} // namespace unprojector::gui
