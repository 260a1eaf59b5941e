#pragma once

#include "gui/landmarks/measure_rows.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QTreeWidget;

namespace unprojector::gui {

class SceneDocument;
class SegmentedSwitch;

/// What the selected points measure, each with the error that follows from how sure they are; or how alike left and right are.
/// The measure that is chosen in the list is shown in the view, and so is its like when other points are selected.
class MeasuresView : public QWidget {
    Q_OBJECT
public:
    explicit MeasuresView(SceneDocument &document, QWidget *parent = nullptr);

    /// The rows that are shown, with all digits.
    QString csv() const;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    enum Shown { OfSelection, OfSides };

    std::vector<MeasureRow> rows() const;
    void showRows();
    /// The table is as high as its rows: none is cut off.
    void showWholeRows();
    /// Shows the chosen row in the view.
    void showChosen();
    void showUnit();
    void setUnit(int index);
    void showMenu(const QPoint &place);

    SceneDocument &m_document;
    SegmentedSwitch *m_what;
    QComboBox *m_unit;
    QTreeWidget *m_rows;
    QLabel *m_empty;
    std::vector<MeasureRow> m_listed;
    QString m_chosenKind;        ///< of what is shown in the view; empty: nothing is
    std::optional<int> m_chosen; ///< the row of it, where there is one
    bool m_isShowing = false;
};

} // namespace unprojector::gui
