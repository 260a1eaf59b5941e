#pragma once

#include "core/pipeline/matrix_factors.h"
#include "gui/pipeline/matrix_view.h"

#include <QWidget>

#include <array>

class QLabel;

namespace unprojector::gui {

class FactorShares;
class MatrixModel;
class NumberGrid;

/// The factors of a matrix, in the order in which they act on a point, each with its effect. Above
/// them: their product and its residual. Below a projection's factors: sliders for their shares.
class FactorsView : public QWidget {
    Q_OBJECT
public:
    explicit FactorsView(QWidget *parent = nullptr);

    /// @param matrix   that the factors' product is compared with
    /// @param isGiven  whether it is the conversion of one that was given as sixteen numbers
    /// @param projection  of the factors: the sliders then apply parts of them. Null: the factors
    /// of a view.
    void setFactors(const std::vector<pipeline::MatrixFactor> &factors, const glm::dmat4 &matrix,
                    const MatrixView &view, bool isGiven, const geometry::Projection *projection);
    /// Shows that there is nothing to decompose, and why.
    void setNone(const QString &reason);
    /// The sliders for the factors' shares; hidden if there are none.
    FactorShares &shares() const { return *m_shares; }

private:
    struct Part {
        QLabel *text;
        MatrixModel *model;
        NumberGrid *grid;
    };
    QLabel *m_product;
    std::array<Part, 6> m_parts{}; ///< the most factors: a sheared box in another API's conventions
    FactorShares *m_shares;
    QLabel *m_noShares; ///< why there are no sliders
};

} // namespace unprojector::gui
