#pragma once

#include "core/matrices/matrix_findings.h"
#include "core/matrices/pasted_matrix.h"

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
    void setFindings(const std::vector<matrices::MatrixFinding> &findings, matrices::MatrixRole role,
                     matrices::NumberOrder order);

signals:
    void repairWanted(const unprojector::matrices::MatrixFinding &finding);

private:
    std::vector<matrices::MatrixFinding> m_findings;
    QStringList m_texts; ///< as shown
    QVBoxLayout *m_rows;
};

} // namespace unprojector::gui
