#include "gui/panels/comparison_model.h"

#include "gui/text/number_text.h"

#include <cmath>

namespace unprojector::gui {
namespace {

constexpr int kDoubleDigits = 16;
constexpr int kFloatDigits = 8;

/// Tenths while they tell something, whole numbers after that, powers of ten where digits would be noise.
QString ulpsText(double ulps)
{
    const double size = std::abs(ulps);
    if (size >= 1e6)
        return significantText(ulps, 2);
    return significantText(size < 10.0 ? std::round(ulps * 10.0) / 10.0 : std::round(ulps), 6);
}

} // namespace

ComparisonModel::ComparisonModel(QObject *parent) : QAbstractTableModel(parent)
{
    setPick(std::nullopt);
}

template <typename Space>
void ComparisonModel::addRows(const QString &space, const Answers<Space> &point, std::optional<double> certaintyRadius)
{
    const auto component = [](const Result<Point<Space>> &p, int axis) {
        return p ? std::optional((*p)[axis]) : std::nullopt;
    };
    for (int axis = 0; axis < 3; ++axis) {
        Row row;
        row.name = tr("%1 %2").arg(space, QStringLiteral("xyz")[axis]);
        for (const Method method : kMethods)
            row.by[static_cast<std::size_t>(method)] = component(point[method], axis);
        if (const Result<Point<Space>> &formula = point[Method::Formula]) {
            row.ulp = ulpOfLargest(*formula);
            row.decimals = decimalsFor(*formula, kDoubleDigits);
        }
        row.certain = certaintyRadius ? std::min(row.decimals, certainDecimals(*certaintyRadius)) : row.decimals;
        m_rows.push_back(std::move(row));
    }
}

void ComparisonModel::setPick(const std::optional<Pick> &pick)
{
    beginResetModel();
    m_rows.clear();
    if (pick && pick->hit()) {
        addRows(tr("World"), pick->point.world, pick->certainty.radius());
        addRows(tr("Eye"), pick->point.eye, pick->certainty.radius());
    } else if (pick) {
        addRows(tr("Near"), pick->rayNear.world, std::nullopt);
        addRows(tr("Far"), pick->rayFar.world, std::nullopt);
    } else {
        // The rows stand before the first click too, so that the panel keeps its shape.
        for (const QString &space : {tr("World"), tr("Eye")}) {
            for (const QChar axis : {u'x', u'y', u'z'}) {
                Row row;
                row.name = tr("%1 %2").arg(space, axis);
                m_rows.push_back(std::move(row));
            }
        }
    }
    endResetModel();
}

int ComparisonModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ComparisonModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

std::optional<double> ComparisonModel::by(Method method, const Row &row)
{
    return row.by[static_cast<std::size_t>(method)];
}

std::optional<double> ComparisonModel::value(const Row &row, int column) const
{
    const auto difference = [&row](Method method) {
        const std::optional<double> formula = by(Method::Formula, row), other = by(method, row);
        return formula && other ? std::optional(*formula - *other) : std::nullopt;
    };
    switch (column) {
    case Formula: return by(Method::Formula, row);
    case Matrix: return by(Method::Matrix, row);
    case Difference: return difference(Method::Matrix);
    case Ulps: {
        const std::optional<double> d = difference(Method::Matrix);
        return d ? std::optional(*d / row.ulp) : std::nullopt;
    }
    case MatrixInFloat: return by(Method::MatrixInFloat, row);
    case FloatDifference: return difference(Method::MatrixInFloat);
    default: return std::nullopt;
    }
}

QString ComparisonModel::coordinateText(const Row &row, int column) const
{
    const int dropped = column == MatrixInFloat ? kDoubleDigits - kFloatDigits : 0;
    return fixedText(*value(row, column), std::max(0, row.decimals - dropped));
}

QVariant ComparisonModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row &row = m_rows[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    const std::optional<double> v = value(row, column);
    const bool isCoordinate = column == Formula || column == Matrix || column == MatrixInFloat;
    switch (role) {
    case Qt::DisplayRole:
        if (!v)
            return by(Method::Formula, row) || by(Method::Matrix, row) ? tr("none") : QStringLiteral("–");
        if (isCoordinate)
            return coordinateText(row, column);
        if (column == Ulps)
            return ulpsText(*v);
        return significantText(*v, 2);
    case kCertainLengthRole:
        if (v && isCoordinate) {
            const QString text = coordinateText(row, column);
            const qsizetype point = text.indexOf(u'.');
            const qsizetype length = point < 0 ? text.size() : point + (row.certain > 0 ? row.certain + 1 : 0);
            return static_cast<int>(std::min(length, text.size()));
        }
        return {};
    case kValueRole: return v ? QVariant(*v) : QVariant();
    case Qt::ToolTipRole:
        if (v && isCoordinate)
            return tr("%1\nDigits in grey are below what the depth buffer and the pixel can tell.")
                .arg(shortestText(*v));
        return v ? QVariant(shortestText(*v)) : QVariant();
    case Qt::TextAlignmentRole: return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    default: return {};
    }
}

QVariant ComparisonModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical) {
        if (role == Qt::DisplayRole && section < rowCount())
            return m_rows[static_cast<std::size_t>(section)].name;
        return QAbstractTableModel::headerData(section, orientation, role);
    }
    if (role == Qt::DisplayRole) {
        switch (section) {
        case Formula: return tr("Formula");
        case Matrix: return tr("Matrix inverse");
        case Difference: return tr("Difference");
        case Ulps: return tr("ulp");
        case MatrixInFloat: return tr("Matrix in float");
        case FloatDifference: return tr("Float off by");
        default: return {};
        }
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case Formula: return tr("By the closed-form formulas (9) to (12), in double; world units");
        case Matrix: return tr("By the inverse of projection × view, in double, as gluUnProject does; world units");
        case Difference: return tr("Formula minus matrix inverse; world units");
        case Ulps: return tr("The difference in units in the last place of the point's largest component");
        case MatrixInFloat: return tr("The matrix inverse done in single precision, as many programs do");
        case FloatDifference: return tr("Formula minus the single-precision result; world units");
        default: return {};
        }
    }
    return QAbstractTableModel::headerData(section, orientation, role);
}

QStringList ComparisonModel::pointNames()
{
    return {tr("World"), tr("Eye"), tr("Near"), tr("Far")};
}

QString ComparisonModel::text() const
{
    QString text;
    for (int column = 0; column < ColumnCount; ++column)
        text += u'\t' + headerData(column, Qt::Horizontal).toString();
    for (int row = 0; row < rowCount(); ++row) {
        text += u'\n' + headerData(row, Qt::Vertical).toString();
        for (int column = 0; column < ColumnCount; ++column) {
            const QVariant v = data(index(row, column), kValueRole);
            text += u'\t' + (v.isValid() ? shortestText(v.toDouble()) : QString());
        }
    }
    return text + u'\n';
}

} // namespace unprojector::gui
