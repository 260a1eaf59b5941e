#pragma once

#include "core/pipeline/pipeline.h"
#include "gui/pipeline/matrix_view.h"
#include "gui/widgets/number_grid_model.h"

namespace unprojector::gui {

/// The matrix of one stage: four by four, or its memory. A tooltip names the entry by the formula's
/// symbols.
class MatrixModel : public NumberGridModel {
    Q_OBJECT
public:
    explicit MatrixModel(pipeline::PipelineStage stage, QObject *parent = nullptr);

    /// @param isNamed  whether the formulas' symbols apply to its entries
    /// @param isSkewed  the projection is a frustum with a skew
    void setMatrix(const glm::dmat4 &matrix, pipeline::PipelineDirection direction, geometry::ProjectionKind kind,
                   bool isNamed = true, bool isSkewed = false);
    void setView(const MatrixView &view);
    /// Overrides the stage's variable name.
    void setVariableName(const QString &name) { m_variableName = name; }

    pipeline::PipelineStage stage() const { return m_stage; }
    const MatrixView &view() const { return m_view; }
    /// The matrix for column vectors.
    const glm::dmat4 &matrix() const { return m_matrix; }

    /// The cell of a row and column of the matrix for column vectors.
    QModelIndex indexOf(int mathRow, int mathColumn) const;

    /// The row of a cell in the matrix for column vectors.
    int mathRowOf(const QModelIndex &cell) const { return memoryIndex(cell.row(), cell.column()) % 4; }

    /// The variable name of the matrix in code: "eyeFromWorld".
    QString variableName() const;
    /// The matrix for the clipboard, in the layout and digits shown.
    QString copyText(pipeline::MatrixSyntax syntax) const;

protected:
    QString label(int row, int column) const override;
    QString toolTip(int row, int column) const override;

private:
    void show();
    /// The memory index of a cell: m[index].
    int memoryIndex(int row, int column) const;

    pipeline::PipelineStage m_stage;
    pipeline::PipelineDirection m_direction = pipeline::PipelineDirection::Forward;
    geometry::ProjectionKind m_kind = geometry::ProjectionKind::Perspective;
    bool m_isNamed = true, m_isSkewed = false;
    glm::dmat4 m_matrix{1.0};
    MatrixView m_view;
    QString m_variableName;
};

} // namespace unprojector::gui
