#pragma once

#include <QTableView>

namespace unprojector::gui {

class ComparisonModel;

/// The table of a pick. Its columns share the width: those of the methods show as many digits as they have room for, and
/// where not even a few are left the table scrolls. Neither its height nor its columns follow from what is picked.
class ComparisonTable : public QTableView {
    Q_OBJECT
public:
    explicit ComparisonTable(ComparisonModel *model, QWidget *parent = nullptr);

    bool showsFloat() const;
    void setShowsFloat(bool shows);

    /// The selected cells with all their digits, a row a line, tab-separated.
    QString selectedText() const;

    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void useFonts();
    void fitColumns();
    int columnWidthFor(int column, int characters) const;

    ComparisonModel *m_model;
};

} // namespace unprojector::gui
