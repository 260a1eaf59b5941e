#pragma once

#include <QSet>
#include <QTreeView>

#include <cstddef>
#include <optional>
#include <vector>

class QSortFilterProxyModel;

namespace unprojector::gui {

class LandmarksModel;
class SceneDocument;

/// The list of landmarks. Its selection and the document's are the same. A click on a column head
/// sorts the rows, but not the document; the third click restores the document's order, the only
/// one in which rows can be dragged.
class LandmarksTable : public QTreeView {
    Q_OBJECT
public:
    LandmarksTable(SceneDocument &document, LandmarksModel *model, QWidget *parent = nullptr);

    /// The indices of the selected landmarks, in the order of the rows.
    std::vector<std::size_t> selectedIndices() const;
    /// Edits the name of the current landmark.
    void renameCurrent();
    /// Commits pending input, as Enter does.
    void applyTyped();

    QSize sizeHint() const override;

signals:
    void removeRequested();
    void copyRequested();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void useFonts();
    void fitColumns();
    /// The width of a column for a number of characters and its head.
    int widthFor(int column, int characters) const;
    /// Gives the columns of numbers and names the room that some rows of the model need, except
    /// columns that the user has resized. Columns without digits are narrow.
    void widen(int first, int last);
    /// Gives the name column the room of its longest name, as far as the columns up to ± leave it,
    /// and at least that of a usual name.
    void fitName();
    void showSelection();
    void tellSelection();

    SceneDocument &m_document;
    QSortFilterProxyModel *m_rows;
    int m_widestName = 0;                       ///< with its check box and margins
    QSet<int> m_ownWidths;                      ///< columns that the user has resized
    bool m_isFitting = false;                   ///< column widths are being computed
    bool m_isShowing = false;                   ///< the document's selection is being shown and must not be sent back
    std::optional<std::size_t> m_shownUnplaced; ///< the next landmark to place when the rows were last shown
};

} // namespace unprojector::gui
