#pragma once

#include "gui/landmarks/measure_rows.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace unprojector::gui {

class SceneDocument;
class SegmentedSwitch;

/// The measures of the selected landmarks, each with the error that follows from their
/// uncertainties; the symmetry of left and right; or the protocol, the measures that the scene keeps.
/// The view shows the chosen measure, and the corresponding one after another selection.
class MeasuresView : public QWidget {
    Q_OBJECT
public:
    explicit MeasuresView(SceneDocument &document, QWidget *parent = nullptr);

    /// The shown rows, with all digits.
    QString csv() const;

signals:
    /// Emitted when a measure cannot be kept or a protocol cannot be read or written.
    void warned(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    enum Shown { OfSelection, OfSides, OfProtocol };

    std::vector<MeasureRow> rows() const;
    void showRows();
    /// Divides the width among the columns: long texts of one leave room to the others.
    void fitColumns();
    /// Makes the table as high as its rows, so that none is cut off.
    void showWholeRows();
    /// Shows the chosen row in the view.
    void showChosen();
    void showUnit();
    void setUnit(int index);
    void showMenu(const QPoint &place);

    // The protocol.
    const std::vector<landmarks::KeptMeasure> &protocol() const;
    void editProtocol(std::vector<landmarks::KeptMeasure> measures, const QString &text);
    void showProtocolButton();
    void keep();
    void removeFromProtocol();
    void rename(QTreeWidgetItem &item);
    void loadProtocol();
    void saveProtocol();
    /// Selects the landmarks of a row of the protocol, so that the view shows them.
    void selectLandmarksOf(std::size_t row);

    SceneDocument &m_document;
    SegmentedSwitch *m_what;
    QToolButton *m_keep, *m_remove; ///< each in a place of its own: a second press must not remove
    QComboBox *m_unit;
    QTreeWidget *m_rows;
    QLabel *m_empty;
    std::vector<MeasureRow> m_listed;
    QString m_chosenKind;        ///< of the measure in the view; empty: none
    std::optional<int> m_chosen; ///< its row, if there is one
    bool m_isShowing = false;
};

} // namespace unprojector::gui
