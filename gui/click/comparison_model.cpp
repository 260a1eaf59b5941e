#include "gui/click/comparison_model.h"

#include "gui/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

constexpr int kDoubleDigits = 16;
constexpr int kFloatDigits = 8;
constexpr int kThousandths = -3; ///< the place that is told in narrow columns too: a survey is of millimetres

/// Tenths while they tell something, whole numbers after that, powers of ten where digits would be noise: six characters.
QString ulpsText(double ulps)
{
    const double size = std::abs(ulps);
    constexpr double kFiveDigits = 99999.5;
    if (size >= kFiveDigits)
        return significantText(ulps, 1);
    return significantText(size < 10.0 ? std::round(ulps * 10.0) / 10.0 : std::round(ulps), 6);
}

/// All that is certain, or as much of it as the column has room for: "5412349.52…".
QString fittingText(double value, double uncertainty)
{
    QString text = certainText(value, uncertainty);
    if (text.size() > ComparisonModel::kCertainRoom && !text.contains(u'e')
        && text.indexOf(u'.') < ComparisonModel::kCertainRoom - 1)
        return text.left(ComparisonModel::kCertainRoom - 1) + QStringLiteral("…");
    for (int digits = ComparisonModel::kCertainRoom - 1; text.size() > ComparisonModel::kCertainRoom && digits > 0;
         --digits)
        text = significantText(value, digits);
    return text;
}

/// A coordinate as a column shows it.
struct Shown {
    QString text;
    qsizetype certainLength;
    bool isCut = false; ///< its first digits are left out
};

/// All digits that there is room for. Where those would end before the thousandths that are certain, the first ones, which
/// stand under Certain, are left out instead: what is compared is behind them.
/// @param formula   what stands under Certain; a number that differs from it in the digits left out keeps them
/// @param capacity  the column's room
Shown shownIn(const Notation &notation, double value, double formula, double uncertainty, int capacity)
{
    Shown whole{notation.text(value), notation.certainLength(value, uncertainty)};
    const int place = std::max(uncertainty > 0.0 ? certainPlace(uncertainty) : kThousandths, kThousandths);
    if (notation.isScientific || place >= 0 || notation.lastPlace(value) <= place || !std::isfinite(value))
        return whole;
    const QString digits = fixedText(std::abs(value), -place);
    const QString before = std::signbit(value) ? QStringLiteral("-…") : QStringLiteral("…");
    const qsizetype kept = capacity - before.size();
    constexpr qsizetype kPoint = 1;
    const qsizetype ofWhole = kept - kPoint + place; // digits before the point
    if (ofWhole < 1 || digits.size() <= kept)
        return whole;
    // The sign is shown; the digits that are left out are those of the formula.
    const QString digitsOfFormula = fixedText(std::abs(formula), -place);
    if (digits.size() != digitsOfFormula.size() || digits.chopped(kept) != digitsOfFormula.chopped(kept))
        return whole;
    return {before + digits.right(kept), capacity, true};
}

bool isCoordinate(int column)
{
    return column == ComparisonModel::Formula || column == ComparisonModel::Matrix
           || column == ComparisonModel::MatrixInFloat;
}

} // namespace

ComparisonModel::ComparisonModel(QObject *parent) : CoordinatesModel(parent)
{
    setPick(std::nullopt);
}

template <typename Space>
void ComparisonModel::addRows(const QString &space, const Answers<Space> &point, const Components<3> &uncertainty)
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
            row.point = *formula;
        }
        row.uncertainty = uncertainty[axis];
        m_rows.push_back(std::move(row));
    }
}

void ComparisonModel::setPick(const std::optional<Pick> &pick)
{
    beginResetModel();
    m_rows.clear();
    m_isRay = pick && !pick->hit();
    if (pick && pick->hit()) {
        addRows(tr("World"), pick->point.world, pick->uncertainty.world);
        addRows(tr("Eye"), pick->point.eye, pick->uncertainty.eye);
    } else if (pick) {
        // The pixel's centre and the planes' depths are exact.
        addRows(tr("Near"), pick->rayNear.world, {});
        addRows(tr("Far"), pick->rayFar.world, {});
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

void ComparisonModel::setCapacity(int characters)
{
    if (characters == m_capacity)
        return;
    m_capacity = characters;
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
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
    case Certain: {
        const std::optional<double> formula = by(Method::Formula, row);
        return formula ? std::optional(certainText(*formula, row.uncertainty).toDouble()) : std::nullopt;
    }
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

Notation ComparisonModel::notation(const Row &row, int column) const
{
    return notationOf(row.point, value(row, column).value_or(0.0),
                      column == MatrixInFloat ? kFloatDigits : kDoubleDigits, m_capacity);
}

QString ComparisonModel::toolTip(const Row &row, int column) const
{
    QString number = shortestText(*value(row, column));
    if (column == Certain)
        return tr("%1 ± %2\nRounded to what is certain of this coordinate of the point at the pixel's centre")
            .arg(certainText(*by(Method::Formula, row), row.uncertainty), boundText(row.uncertainty));
    if (isCoordinate(column))
        return tr("%1\nGrey digits are below the last certain place, where the depth buffer and the drawing tell "
                  "nothing. "
                  "Rounded to that place, the number is the one under Certain.")
            .arg(number);
    return number;
}

QVariant ComparisonModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row &row = m_rows[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    const std::optional<double> v = value(row, column);
    const auto shown = [&] {
        const Notation whole = notation(row, column);
        if (column == MatrixInFloat) // it has no digits to leave out
            return Shown{whole.text(*v), whole.certainLength(*v, row.uncertainty)};
        return shownIn(whole, *v, by(Method::Formula, row).value_or(*v), row.uncertainty, m_capacity);
    };
    switch (role) {
    case Qt::DisplayRole:
        if (!v)
            return by(Method::Formula, row) || by(Method::Matrix, row) ? tr("none") : QStringLiteral("–");
        if (column == Certain)
            return fittingText(*by(Method::Formula, row), row.uncertainty);
        if (isCoordinate(column))
            return shown().text;
        if (column == Ulps)
            return ulpsText(*v);
        return significantText(*v, 2);
    case kCertainLengthRole:
        return v && isCoordinate(column) ? QVariant(static_cast<int>(shown().certainLength)) : QVariant();
    case kValueRole: return v ? QVariant(*v) : QVariant();
    case Qt::ToolTipRole:
        if (!v)
            return {};
        if (isCoordinate(column) && shown().isCut)
            return tr("%1\n… stands for the first digits, which are those under Certain; the window is too narrow for "
                      "all.")
                .arg(shortestText(*v));
        return toolTip(row, column);
    case Qt::TextAlignmentRole: return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    default: return {};
    }
}

QString ComparisonModel::copied(const QModelIndex &index) const
{
    const Row &row = m_rows[static_cast<std::size_t>(index.row())];
    const std::optional<double> formula = by(Method::Formula, row);
    return index.column() == Certain && formula ? certainText(*formula, row.uncertainty)
                                                : CoordinatesModel::copied(index);
}

std::vector<double> ComparisonModel::pointAt(const QModelIndex &index) const
{
    std::vector<double> point;
    const int first = index.row() - index.row() % 3;
    for (int row = first; row < first + 3; ++row) {
        if (const std::optional<double> v = value(m_rows[static_cast<std::size_t>(row)], index.column()))
            point.push_back(*v);
    }
    return point;
}

QString ComparisonModel::pointNameAt(const QModelIndex &index) const
{
    const bool isFirst = index.row() < 3;
    QString point = m_isRay ? (isFirst ? QStringLiteral("rayNear") : QStringLiteral("rayFar"))
                            : (isFirst ? QStringLiteral("world") : QStringLiteral("eye"));
    switch (index.column()) {
    case Difference: return point + QStringLiteral("Difference");
    case Ulps: return point + QStringLiteral("DifferenceInUlps");
    case MatrixInFloat: return point + QStringLiteral("InFloat");
    case FloatDifference: return point + QStringLiteral("FloatDifference");
    default: return point;
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
        case Certain: return tr("Certain");
        case Formula: return tr("Formula");
        case Matrix: return tr("Matrix");
        case Difference: return tr("Difference");
        case Ulps: return tr("ulp");
        case MatrixInFloat: return tr("In float");
        case FloatDifference: return tr("Off by");
        default: return {};
        }
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case Certain:
            return tr("What is certain of the point at the pixel's centre, each coordinate by itself; world units");
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

} // namespace unprojector::gui
