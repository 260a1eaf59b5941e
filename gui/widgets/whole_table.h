#pragma once

#include <QTableWidget>

namespace unprojector::gui {

/// A read-only table, as high as its rows: the panel around it scrolls, not the table. Its columns
/// are as wide as their texts.
class WholeTable : public QTableWidget {
    Q_OBJECT
public:
    WholeTable(int rows, int columns, QWidget *parent = nullptr);

    /// Adapts height and widths to the current cells.
    void fit();

protected:
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
};

} // namespace unprojector::gui
