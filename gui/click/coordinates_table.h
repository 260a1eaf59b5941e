#pragma once

#include <QTableView>

#include <vector>

namespace unprojector::gui {

class CoordinatesModel;

/// A table of coordinates as high as its rows. Its columns grow with their numbers and don't
/// shrink, so that the table doesn't move from click to click. If they need more than the table's
/// width, it scrolls.
class CoordinatesTable : public QTableView {
    Q_OBJECT
public:
    explicit CoordinatesTable(CoordinatesModel *model, QWidget *parent = nullptr);

    void setColumnShown(int column, bool isShown);

    /// The selected cells with all their digits, a row a line, tab-separated.
    QString selectedText() const;

    /// Wide enough not to scroll.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void useFonts();
    /// The widths that the numbers need, as far as the columns are shown.
    void measure();
    void fit();

    CoordinatesModel *m_model;
    std::vector<int> m_widths; ///< the largest width so far of each column
};

} // namespace unprojector::gui
