#pragma once

#include "core/matrices/matrix_factors.h"
#include "gui/pipeline/matrix_view.h"

#include <QList>
#include <QWidget>

#include <array>
#include <vector>

class QLabel;
class QSlider;

namespace unprojector::gui {

class FactorDrawing;
class MatrixModel;

/// How much of each factor of a projection acts, from nothing to all of it, by sliders; the product of these parts, and what it
/// makes of the view volume. The sliders stay where they are while the projection changes and has the same factors.
class FactorShares : public QWidget {
    Q_OBJECT
public:
    explicit FactorShares(QWidget *parent = nullptr);

    /// A factor, as it is written and told.
    struct Told {
        QString letter;
        QString text;
    };
    /// @param factors     OpenGL's own, of this projection, in the order in which they act; four at most
    /// @param told        one of each
    /// @param clipFromEye the projection's matrix
    void setFactors(const std::vector<matrices::MatrixFactor> &factors, const std::vector<Told> &told,
                    const geometry::Projection &projection, const glm::dmat4 &clipFromEye, const MatrixView &view);

    /// How much of every factor acts, percent.
    void setAll(int percent);
    /// The same of each, in the order of the factors.
    QList<int> percents() const;
    void setPercents(const QList<int> &percents);

private:
    void showProduct();

    struct Row {
        QWidget *line;
        QLabel *letter;
        QSlider *slider;
        QLabel *percent;
    };
    std::array<Row, 4> m_rows{};
    MatrixModel *m_model;
    QLabel *m_said;
    QLabel *m_extent;
    FactorDrawing *m_drawing;
    std::vector<matrices::MatrixFactor> m_factors;
    geometry::Projection m_projection;
    glm::dmat4 m_clipFromEye{1.0};
};

} // namespace unprojector::gui
