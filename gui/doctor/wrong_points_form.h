#pragma once

#include "core/doctor/diagnosis.h"
#include "core/doctor/written_points.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTimer;

namespace unprojector::gui {

/// The doctor's second and third step, for the clicks and the points that a program printed for
/// them: a row each, with the pixel, the depth if known, and the program's point.
class WrongPointsForm : public QWidget {
    Q_OBJECT
public:
    explicit WrongPointsForm(QWidget *parent = nullptr);
    ~WrongPointsForm() override;

    /// The complete and valid rows, in order; their space is the world.
    std::vector<doctor::WrongPoint> points() const;
    bool isEmpty() const;
    /// The first fault in words, with what to do about it; empty if there is none.
    QString fault() const;
    /// Sets the setup that limits depths and pixels.
    void setSetup(const geometry::Setup &setup);

    /// Enters a click into the first row without a program's point, or into a new one.
    /// @param depth  nothing: not known. It is shown with few digits but used in full
    void addClick(const geometry::DevicePoint &pixel, const std::optional<double> &depth);
    /// Reverts the last addClick, unless the user has typed since.
    /// @return whether anything was reverted
    bool takeBackClick();
    /// Keeps the last click: it cannot be reverted any more.
    void forgetClick() { m_beforeClick.reset(); }
    /// A row of a click, with what was typed into it.
    struct ClickedRow {
        QString pixel, depth, got;
        std::optional<double> clickedDepth; ///< the full depth of the click
    };
    /// Removes the rows of clicks, which belong to their scene, without `changed`. Typed pixels stay.
    std::vector<ClickedRow> takeClickedRows();
    /// Puts such rows behind the present ones, without `changed`.
    void putBack(const std::vector<ClickedRow> &rows);
    /// Drops the depths of clicks, which belong to the camera of their view. Typed depths stay.
    void forgetClickedDepths();
    /// Focuses the first row without a program's point.
    void focusWaiting();

signals:
    void changed();

private:
    struct Row;
    struct Fault {
        QLineEdit *field;
        QString text; ///< what is wrong, and what to do
    };

    Row &addRow();
    /// A row that is not yet in the layout, see arrange().
    Row &makeRow();
    void removeRow(const Row *row);
    void arrange();
    /// Parses a table instead of a point. @return whether it was one
    bool takeTable(Row &row, const QString &text);
    void edited(Row &row);
    /// The first fault of a row.
    std::optional<Fault> faultOf(const Row &row) const;
    void markFaults();

    /// The first row without a program's point; null if there is none.
    Row *waitingRow() const;

    struct BeforeClick {
        Row *row;
        bool isNew; ///< the click has added it
        QString pixel, clickedPixel, depth;
        std::optional<double> clickedDepth;
    };

    std::vector<std::unique_ptr<Row>> m_rows;
    std::optional<BeforeClick> m_beforeClick;
    std::optional<geometry::Setup> m_setup;
    QString m_tableFault;
    QGridLayout *m_grid;
    QLabel *m_fault;
    QPushButton *m_add;
    QTimer *m_pause; ///< in typing: faults are shown afterwards
};

} // namespace unprojector::gui
