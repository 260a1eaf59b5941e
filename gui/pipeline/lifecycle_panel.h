#pragma once

#include <QWidget>

class QBoxLayout;
class QTableView;
class QToolButton;

namespace unprojector::gui {

class LifecycleLog;

/// The log as a table. It follows the newest row unless the user has scrolled up.
class LifecyclePanel : public QWidget {
    Q_OBJECT
public:
    explicit LifecyclePanel(LifecycleLog &log, QWidget *parent = nullptr);

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
    int reserveColumns(double scale);
    void placeButtons();
    void fitCalls();
    void fitRow(int row);
    void follow();
    void copy() const;
    void enableButtons();

    LifecycleLog &m_log;
    QTableView *m_table = nullptr;
    QToolButton *m_copy;
    QToolButton *m_clear;
    QBoxLayout *m_layout, *m_buttons;
    int m_leastCallsWidth = 0;
    int m_wholeWidth = 0; ///< of all columns in type of the window's size
    bool m_follows = true;
    bool m_willFollow = false; ///< the scroll to the end is under way
};

} // namespace unprojector::gui
