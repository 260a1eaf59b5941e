#pragma once

#include "core/cameras/pasted_matrix.h"
#include "core/pipeline/matrix_findings.h"

#include <QWidget>

#include <vector>

class QVBoxLayout;

namespace unprojector::gui {

/// The findings about a matrix, each in a sentence with a button that fixes it.
class MatrixFindingsView : public QWidget {
    Q_OBJECT
public:
    explicit MatrixFindingsView(QWidget *parent = nullptr);

    /// @param order  in which the matrix is read
    void setFindings(const std::vector<pipeline::MatrixFinding> &findings, pipeline::MatrixRole role,
                     cameras::NumberOrder order);

signals:
    void repairWanted(const unprojector::pipeline::MatrixFinding &finding);

private:
    std::vector<pipeline::MatrixFinding> m_findings;
    QStringList m_texts; ///< as shown
    QVBoxLayout *m_rows;
};

} // namespace unprojector::gui
