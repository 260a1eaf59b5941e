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

/// The list of placed points. What is selected in it is what is selected in the document, both ways. It is sorted by a click on
/// a head, which changes nothing but the view; by the third click it is in the points' own order again, the only one in which
/// rows can be dragged.
class LandmarksTable : public QTreeView {
    Q_OBJECT
public:
    LandmarksTable(SceneDocument &document, LandmarksModel *model, QWidget *parent = nullptr);

    /// The places of the selected points, in the order of the rows.
    std::vector<std::size_t> selectedIndices() const;
    /// Edits the name of the current point.
    void renameCurrent();
    /// What is being typed counts, as if Enter were pressed.
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
    /// Gives coordinates the room that those of some rows of the model need, but not to columns that the user has resized.
    void widenCoordinates(int first, int last);
    /// Names have the room that the columns up to ± leave.
    void fitName();
    void showSelection();
    void tellSelection();

    SceneDocument &m_document;
    QSortFilterProxyModel *m_rows;
    QSet<int> m_ownWidths;                      ///< columns that the user has resized
    bool m_isFitting = false;                   ///< columns get the width that they need
    bool m_isShowing = false;                   ///< the document's selection, which it need not be told of
    std::optional<std::size_t> m_shownUnplaced; ///< the point that waited when the rows were shown last
};

} // namespace unprojector::gui
