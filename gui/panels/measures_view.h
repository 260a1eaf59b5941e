#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QTreeWidget;

namespace unprojector::gui {

class SceneDocument;
class SegmentedSwitch;

/// What the selected points measure, each with the error that follows from how sure they are; or how alike left and right are.
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

    void showRows();
    /// The table is as high as its rows: none is cut off.
    void showWholeRows();
    void showUnit();
    void setUnit(int index);
    void showMenu(const QPoint &place);

    SceneDocument &m_document;
    SegmentedSwitch *m_what;
    QComboBox *m_unit;
    QTreeWidget *m_rows;
    QLabel *m_empty;
};

} // namespace unprojector::gui
