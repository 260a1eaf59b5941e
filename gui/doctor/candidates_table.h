#pragma once

#include "core/doctor/diagnosis.h"

#include <QTableWidget>

namespace unprojector::gui {

/// What could have made the wrong points, the best first: its answer, how many digits it explains, how far off it is.
class CandidatesTable : public QTableWidget {
    Q_OBJECT
public:
    explicit CandidatesTable(QWidget *parent = nullptr);

    /// @param first  of the points, by whose digits the answers are written
    void setDiagnosis(const doctor::Diagnosis &diagnosis, const doctor::WrongPoint &first);

signals:
    /// A hand has chosen one. @param index  among the candidates
    void chosen(int index);
};

} // namespace unprojector::gui
