#pragma once

#include "core/matrices/matrix_findings.h"
#include "core/matrices/pasted_matrix.h"

#include <QWidget>

#include <vector>

class QVBoxLayout;

namespace unprojector::gui {

/// What is to be seen of a matrix, each in a sentence with the button that does something about it.
class MatrixFindingsView : public QWidget {
    Q_OBJECT
public:
    explicit MatrixFindingsView(QWidget *parent = nullptr);

    /// @param order  that the matrix is read in
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
