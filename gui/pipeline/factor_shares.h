#pragma once

#include "core/pipeline/matrix_factors.h"
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

/// Sliders for the share of each factor of a projection, from nothing to all of it; the product of
/// these parts, and the view volume transformed by it. The sliders keep their values while the
/// projection changes and has the same factors.
class FactorShares : public QWidget {
    Q_OBJECT
public:
    explicit FactorShares(QWidget *parent = nullptr);

    /// A factor's letter and explanation.
    struct Told {
        QString letter;
        QString text;
    };
    /// @param factors     OpenGL's own, of this projection, in the order in which they act; at most
    /// four
    /// @param told        one for each
    /// @param clipFromEye the projection's matrix
    void setFactors(const std::vector<pipeline::MatrixFactor> &factors, const std::vector<Told> &told,
                    const geometry::Projection &projection, const glm::dmat4 &clipFromEye, const MatrixView &view);

    /// Sets the share of every factor, percent.
    void setAll(int percent);
    /// The share of each factor, in order, percent.
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
    std::vector<pipeline::MatrixFactor> m_factors;
    geometry::Projection m_projection;
    glm::dmat4 m_clipFromEye{1.0};
};

} // namespace unprojector::gui
