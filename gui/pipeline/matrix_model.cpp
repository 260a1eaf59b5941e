#include "gui/pipeline/matrix_model.h"

#include "core/pipeline/matrix_entry_name.h"

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;
namespace {

constexpr int kMemoryRows = 8;

} // namespace

MatrixModel::MatrixModel(PipelineStage stage, QObject *parent) : NumberGridModel(parent), m_stage(stage)
{
    show();
}

void MatrixModel::setMatrix(const glm::dmat4 &matrix, PipelineDirection direction, ProjectionKind kind, bool isNamed,
                            bool isSkewed)
{
    m_isNamed = isNamed;
    m_isSkewed = isSkewed;
    m_direction = direction;
    m_kind = kind;
    if (matrix == m_matrix)
        return;
    m_matrix = matrix;
    show();
}

void MatrixModel::setView(const MatrixView &view)
{
    if (view == m_view)
        return;
    m_view = view;
    show();
}

int MatrixModel::memoryIndex(int row, int column) const
{
    if (m_view.isMemoryOrder)
        return column * kMemoryRows + row;
    return m_view.layout == MatrixLayout::Column ? column * 4 + row : row * 4 + column;
}

QModelIndex MatrixModel::indexOf(int mathRow, int mathColumn) const
{
    if (m_view.isMemoryOrder) {
        const int place = mathColumn * 4 + mathRow;
        return index(place % kMemoryRows, place / kMemoryRows);
    }
    return m_view.layout == MatrixLayout::Column ? index(mathRow, mathColumn) : index(mathColumn, mathRow);
}

void MatrixModel::show()
{
    const int rows = m_view.isMemoryOrder ? kMemoryRows : 4;
    const int columns = m_view.isMemoryOrder ? 2 : 4;
    const std::array<double, 16> m = memoryOrder(m_matrix);
    Numbers numbers;
    numbers.reserve(m.size());
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            numbers.emplace_back(m[static_cast<std::size_t>(memoryIndex(row, column))]);
    }
    setNumbers(rows, columns, std::move(numbers), m_view.digits, m_view.isWhole);
}

QString MatrixModel::variableName() const
{
    if (!m_variableName.isEmpty())
        return m_variableName;
    const bool forward = m_direction == PipelineDirection::Forward;
    switch (m_stage) {
    case PipelineStage::ModelMatrix:
        return forward ? QStringLiteral("worldFromObject") : QStringLiteral("objectFromWorld");
    case PipelineStage::ViewMatrix: return forward ? QStringLiteral("eyeFromWorld") : QStringLiteral("worldFromEye");
    case PipelineStage::ProjectionMatrix:
        return forward ? QStringLiteral("clipFromEye") : QStringLiteral("eyeFromClip");
    case PipelineStage::ViewportMatrix:
        return forward ? QStringLiteral("windowFromNdc") : QStringLiteral("ndcFromWindow");
    case PipelineStage::ModelviewMatrix:
        return forward ? QStringLiteral("eyeFromObject") : QStringLiteral("objectFromEye");
    case PipelineStage::WholeMatrix:
        return forward ? QStringLiteral("windowFromObject") : QStringLiteral("objectFromWindow");
    }
    Q_UNREACHABLE();
}

QString MatrixModel::copyText(MatrixSyntax syntax) const
{
    return QString::fromStdString(
        formatted(m_matrix, {syntax, m_view.layout, m_view.digits}, variableName().toStdString()));
}

QString MatrixModel::label(int row, int column) const
{
    return m_view.isMemoryOrder ? QStringLiteral("m[%1]").arg(memoryIndex(row, column)) : QString();
}

QString MatrixModel::toolTip(int row, int column) const
{
    const int index = memoryIndex(row, column);
    const bool isColumns = m_view.layout == MatrixLayout::Column;
    const int mathRow = index % 4, mathColumn = index / 4;
    const std::string_view symbol =
        m_isNamed ? matrixEntryName(m_stage, m_direction, m_kind, mathRow, mathColumn, m_isSkewed) : std::string_view();
    const QString name = QString::fromUtf8(symbol.data(), static_cast<qsizetype>(symbol.size()));
    const bool isConstant = name == u"0" || name == u"1" || name == u"−1";
    const QString number = fullText(row, column);
    const QString place = tr("row %1, column %2, m[%3]")
                              .arg((isColumns ? mathRow : mathColumn) + 1)
                              .arg((isColumns ? mathColumn : mathRow) + 1)
                              .arg(index);
    if (isConstant)
        return tr("%1, always\n%2").arg(name, place);
    if (name.isEmpty())
        return QStringLiteral("%1\n%2").arg(number, place);
    return QStringLiteral("%1 = %2\n%3").arg(name, number, place);
}

} // namespace unprojector::gui
