#pragma once

#include "gui/widgets/copy_menu.h"

#include <QTableView>

namespace unprojector::gui {

class NumberGridModel;

/// Numbers in columns of equal width, in brackets like a printed matrix. It is as high as its rows;
/// a single column is no wider than its numbers. If whole numbers need more room, it scrolls
/// sideways. Arrow keys move through the numbers; Copy copies the selected ones with all digits. If
/// the model is editable, a double-click, F2, Enter or a digit starts editing, and Paste sets all
/// numbers at once.
class NumberGrid : public QTableView {
    Q_OBJECT
public:
    explicit NumberGrid(NumberGridModel *model, QWidget *parent = nullptr);

    /// The number at a position of the grid, or none.
    Copyable numberAt(const QPoint &globalPosition) const;

    /// The selected numbers with all digits, a row a line, tab-separated.
    QString selectedText() const;

    /// @param areShown  whether the model's labels stand before the numbers; else the headings
    /// above the columns name them
    void setLabelsShown(bool areShown);
    /// Hides the scroll bar: another one scrolls the grid sideways.
    void hideScrollBar();

    /// Commits pending input.
    void applyTyped();

    QSize minimumSizeHint() const override;

signals:
    /// Emitted when a number becomes the current one or gets the focus again, except by the Tab
    /// key.
    void entered(const QModelIndex &index);
    /// Emitted when the Tab key moves the focus to a number.
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
    bool m_isReached = false; ///< while the Tab key moves the focus
};

} // namespace unprojector::gui
