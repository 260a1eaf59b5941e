#pragma once

#include <QTableView>

namespace unprojector::gui {

class CoordinatesModel;

/// A table of coordinates as high as its rows, whose columns share its width: those of coordinates show as many digits as there
/// is room for, and where not even a few are left it scrolls. Neither its height nor its columns follow from what is picked.
class CoordinatesTable : public QTableView {
    Q_OBJECT
public:
    /// @param rowNames  all that rows will ever be called: room is for the longest
    CoordinatesTable(CoordinatesModel *model, const QStringList &rowNames, QWidget *parent = nullptr);

    /// The selected cells with all their digits, a row a line, tab-separated.
    QString selectedText() const;

    /// Wide enough not to scroll.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    static constexpr int kPadding = 8; ///< of a cell, both sides

    /// Gives each column its width.
    /// @param available  for all of them, logical pixels
    virtual void shareWidth(int available) = 0;
    /// What all of them need at the least, whichever are shown; logical pixels.
    virtual int leastWidth() const = 0;
    /// How wide a column of so many characters is, at least as its head.
    int columnWidthFor(int column, int characters) const;
    /// How many characters a column has room for.
    int charactersIn(int column) const;
    /// The widths anew. Whoever derives from this calls it once when it is made.
    void fitColumns();

    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void useFonts();

    CoordinatesModel *m_model;
    QStringList m_rowNames;
};

} // namespace unprojector::gui
