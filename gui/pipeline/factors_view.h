#pragma once

#include "core/matrices/matrix_factors.h"
#include "gui/pipeline/matrix_view.h"

#include <QWidget>

#include <array>

class QLabel;

namespace unprojector::gui {

class FactorShares;
class MatrixModel;
class NumberGrid;

/// The factors that a matrix is made of, in the order in which they act on a point, each with what it does; above them their
/// product as it is written, and how far it is from the matrix; below a projection's, how much of each acts.
class FactorsView : public QWidget {
    Q_OBJECT
public:
    explicit FactorsView(QWidget *parent = nullptr);

    /// @param matrix   that the factors' product is compared with
    /// @param isGiven  whether it is the conversion of one that was given as sixteen numbers
    /// @param projection  whose factors they are: what a part of them does can be tried. Null: a view's.
    void setFactors(const std::vector<matrices::MatrixFactor> &factors, const glm::dmat4 &matrix,
                    const MatrixView &view, bool isGiven, const geometry::Projection *projection);
    /// There is nothing to take apart, and why.
    void setNone(const QString &reason);
    /// Where a part of each factor can be tried; hidden where that cannot be.
    FactorShares &shares() const { return *m_shares; }

private:
    struct Part {
        QLabel *text;
        MatrixModel *model;
        NumberGrid *grid;
    };
    QLabel *m_product;
    std::array<Part, 6> m_parts{}; ///< a sheared box in another API's conventions has as many
    FactorShares *m_shares;
    QLabel *m_noShares; ///< why they are not there
};

} // namespace unprojector::gui
