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

/// Where wrong points of one program are given, a row each: the pixel, the depth where it is known, and what the program got.
class WrongPointsForm : public QWidget {
    Q_OBJECT
public:
    explicit WrongPointsForm(QWidget *parent = nullptr);
    ~WrongPointsForm() override;

    /// The rows that are complete and can be taken, in their order; their space is the world.
    std::vector<doctor::WrongPoint> points() const;
    bool isEmpty() const;
    /// What cannot be taken, in words, with what to do about it; empty where nothing is wrong.
    QString fault() const;
    /// Which depths and pixels there are.
    void setSetup(const geometry::Setup &setup);

    /// Puts a click into the row that still waits for what the program got, or else into a new one.
    /// @param depth  nothing: not known. It is shown with few digits and used whole
    void addClick(const geometry::DevicePoint &pixel, const std::optional<double> &depth);
    /// The last click was none: what it has filled is as it was before, unless something was typed since.
    /// @return whether anything was taken back
    bool takeBackClick();
    /// Leaves what the last click has filled as it is: it cannot be taken back any more.
    void forgetClick() { m_beforeClick.reset(); }
    /// To the field of the row that waits for what the program got.
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
    void removeRow(const Row *row);
    void arrange();
    /// Takes a table instead of a point. @return whether it was one
    bool takeTable(Row &row, const QString &text);
    void edited(Row &row);
    /// The first that is wrong in a row.
    std::optional<Fault> faultOf(const Row &row) const;
    void markFaults();

    /// The first that waits for what the program got; null where none does.
    Row *waitingRow() const;

    struct BeforeClick {
        Row *row;
        bool isNew; ///< the click has added it
        QString pixel, depth;
        std::optional<double> clickedDepth;
    };

    std::vector<std::unique_ptr<Row>> m_rows;
    std::optional<BeforeClick> m_beforeClick;
    std::optional<geometry::Setup> m_setup;
    QString m_tableFault;
    QGridLayout *m_grid;
    QLabel *m_fault;
    QPushButton *m_add;
    QTimer *m_pause; ///< in typing: what is wrong then is said
};

} // namespace unprojector::gui
