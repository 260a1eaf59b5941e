#pragma once

#include <QWidget>

class QBoxLayout;
class QLabel;
class QToolButton;
class QTreeView;

namespace unprojector::gui {

class LifecycleLog;

/// The log as a table with folded rows that can be opened. It follows the newest row unless the
/// user has scrolled up.
class LifecyclePanel : public QWidget {
    Q_OBJECT
public:
    explicit LifecyclePanel(LifecycleLog &log, QWidget *parent = nullptr);

    ~LifecyclePanel() override;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void useFont();
    void fitColumns();
    /// Shows the full text of the current row below the table.
    void showCalls();
    void placeButtons();
    void follow();
    void copy() const;
    void enableButtons();

    LifecycleLog &m_log;
    QTreeView *m_table = nullptr;
    QLabel *m_calls;
    QToolButton *m_copy;
    QToolButton *m_clear;
    QBoxLayout *m_layout, *m_buttons;
    int m_wholeWidth = 0; ///< of all columns, with the least readable width of the calls
    bool m_follows = true;
    bool m_willFollow = false; ///< the scroll to the end is under way
};

} // namespace unprojector::gui
