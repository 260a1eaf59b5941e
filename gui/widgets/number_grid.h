#pragma once

#include "gui/widgets/copy_menu.h"

#include <QTableView>

namespace unprojector::gui {

class NumberGridModel;

/// Numbers under each other in columns of equal width, as a matrix is printed, in brackets. It is as high as its rows; one
/// column is no wider than its numbers. Where whole numbers need more room than there is, it scrolls sideways. Arrow keys walk
/// through the numbers, Copy takes the selected ones with all their digits. Where the model can be typed into, a double-click,
/// F2, Enter or the number itself does, and Paste takes all numbers at once.
class NumberGrid : public QTableView {
    Q_OBJECT
public:
    explicit NumberGrid(NumberGridModel *model, QWidget *parent = nullptr);

    /// The number at a place of the grid, or none.
    Copyable numberAt(const QPoint &globalPosition) const;

    /// The selected numbers with all digits, a row a line, tab-separated.
    QString selectedText() const;

    /// @param areShown  whether the model's labels stand before the numbers, or something above the columns names them
    void setLabelsShown(bool areShown);
    /// Another scroll bar than its own moves it sideways.
    void hideScrollBar();

    /// What is being typed counts now.
    void applyTyped();

    QSize minimumSizeHint() const override;

signals:
    /// A number became the current one, or came into the focus again; not by the Tab key.
    void entered(const QModelIndex &index);
    /// The Tab key brought the focus to a number.
    void reached(const QModelIndex &index);

protected:
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    void focusInEvent(QFocusEvent *event) override;
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void changeEvent(QEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void paste();
    void useFont();
    void fit();
    int labelLength() const;
    int widthOf(int characters) const;

    NumberGridModel *m_model;
    bool m_showsLabels = true;
    bool m_hasScrollBar = true;
    bool m_isReached = false; ///< while the Tab key brings the focus
};

} // namespace unprojector::gui
