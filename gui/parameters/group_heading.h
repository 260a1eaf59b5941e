#pragma once

#include <QWidget>

class QToolButton;

namespace unprojector::gui {

class HelpLink;

/// The heading of a folding group: a click, Space or Enter folds and unfolds it, Left folds, Right unfolds, Up and Down
/// ask for another heading. At its end is a button that puts the group back to its defaults.
class GroupHeading : public QWidget {
    Q_OBJECT
public:
    GroupHeading(const QString &title, const QString &help, const QString &resetHelp, QWidget *parent = nullptr);

    bool isOpen() const { return m_isOpen; }
    void setOpen(bool isOpen);
    /// Where Help has the group's formulas; without it the heading has no link.
    void setHelp(const QString &anchor);
    /// Where the keyboard reaches the heading.
    QToolButton *button() const { return m_fold; }

signals:
    void openChanged(bool isOpen);
    void resetRequested();
    /// The heading before (-1) or behind (+1) this one is to get the keyboard.
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
