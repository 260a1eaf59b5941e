#pragma once

#include "core/doctor/diagnosis.h"
#include "gui/widgets/whole_table.h"

namespace unprojector::gui {

/// The mistakes that may explain the wrong points, the best first: its answer, the number of
/// explained digits, its error. Long names wrap.
class CandidatesTable : public WholeTable {
    Q_OBJECT
public:
    explicit CandidatesTable(QWidget *parent = nullptr);

    /// @param first  of the points; determines the digits of the answers
    void setDiagnosis(const doctor::Diagnosis &diagnosis, const doctor::WrongPoint &first);

signals:
    /// Emitted when the user chooses a candidate. @param index  among the candidates
    void chosen(int index);
};

} // namespace unprojector::gui
