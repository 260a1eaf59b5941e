#pragma once

#include "core/doctor/diagnosis.h"

#include <QTableWidget>

namespace unprojector::gui {

/// The mistakes that may explain the wrong points, the best first: its answer, the number of
/// explained digits, its error. Long names wrap.
class CandidatesTable : public QTableWidget {
    Q_OBJECT
public:
    explicit CandidatesTable(QWidget *parent = nullptr);

    /// @param first  of the points; determines the digits of the answers
    void setDiagnosis(const doctor::Diagnosis &diagnosis, const doctor::WrongPoint &first);

signals:
    /// Emitted when the user chooses a candidate. @param index  among the candidates
    void chosen(int index);

protected:
    void changeEvent(QEvent *event) override;

private:
    /// Makes each row as high as its name, and the table as high as its rows.
    void fitRows();
};

} // namespace unprojector::gui
