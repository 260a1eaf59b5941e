#include "gui/click/comparison_model.h"

#include "core/unproject/object_from_world.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace ray;
using namespace unproject;

namespace {

/// The number with tenths while they are meaningful, then whole, finally with two digits.
QString ulpsText(double ulps)
{
    const double size = std::abs(ulps);
    constexpr double kFiveDigits = 99999.5;
    if (size >= kFiveDigits)
        return writtenText(ulps, 2);
    return significantText(size < 10.0 ? std::round(ulps * 10.0) / 10.0 : std::round(ulps), 6);
}

bool isCoordinate(int column)
{
    return column == ComparisonModel::Formula || column == ComparisonModel::Matrix
           || column == ComparisonModel::MatrixInFloat || column == ComparisonModel::Ray;
}

WorldPoint worldPoint(const Components<3> &at)
{
    return {at.x, at.y, at.z};
}

} // namespace

Components<3> mapped(const glm::dmat3 &map, const Components<3> &uncertainty)
{
    Components<3> result;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            result[row] += std::abs(map[column][row]) * uncertainty[column];
    }
    return result;
}

void ComparisonModel::setPick(const KeptPick &kept)
{
    beginResetModel();
    m_kept = kept;
    setRows();
    endResetModel();
}

void ComparisonModel::setSpace(Space space)
{
    if (space == m_space)
        return;
    beginResetModel();
    m_space = space;
    setRows();
    endResetModel();
}

template <typename OfPoint>
void ComparisonModel::addRows(const QString &name, const Answers<OfPoint> &point, const Components<3> &uncertainty,
                              const std::optional<MeshPoint> &onMesh)
{
    for (int axis = 0; axis < 3; ++axis) {
        Row row;
        row.name = (name.isEmpty() ? QString() : name + u' ') + QChar(u'x' + axis);
        for (const Method method : kMethods) {
            if (const Result<Point<OfPoint>> &answer = point[method])
                row.by[static_cast<std::size_t>(method)] = (*answer)[axis];
        }
        if (const Result<Point<OfPoint>> &formula = point[Method::Formula]) {
            row.ulp = ulpOfLargest(*formula);
            row.point = *formula;
        }
        row.uncertainty = uncertainty[axis];
        if (onMesh) {
            row.ray = onMesh->at[axis];
            row.rayUncertainty = onMesh->uncertainty[axis];
        }
        m_rows.push_back(std::move(row));
    }
}

void ComparisonModel::addObjectRows(const Pick &pick, const std::optional<MeshPoint> &onMesh)
{
    const auto point =
        Answers<ObjectSpace>::of([&](Method method) { return objectPointOf(pick, method, m_kept.placement); });
    const glm::dmat3 map = glm::inverse(glm::dmat3(m_kept.placement.rounded()));
    std::optional<MeshPoint> inObject;
    if (onMesh) {
        if (const Result<ObjectPoint> at = objectFromWorld(m_kept.placement, worldPoint(onMesh->at)))
            inObject = MeshPoint{*at, mapped(map, onMesh->uncertainty)};
    }
    addRows({}, point, mapped(map, pick.uncertainty.world), inObject);
}

void ComparisonModel::setRows()
{
    m_rows.clear();
    if (!m_kept.pick)
        return;
    const Pick &pick = *m_kept.pick;
    if (!pick.hit()) {
        // The pixel's centre and the planes' depths are exact.
        const auto add = [this](const auto &enter, const auto &leave) {
            addRows(tr("Near"), enter, {});
            addRows(tr("Far"), leave, {});
        };
        if (m_space == Space::Eye)
            add(pick.rayNear.eye, pick.rayFar.eye);
        else
            add(pick.rayNear.world, pick.rayFar.world);
        return;
    }
    std::optional<MeshPoint> onMesh;
    if (m_kept.ray.state == PickedRay::State::Answered && m_kept.ray.met)
        onMesh = MeshPoint{m_kept.ray.met->hit.world, m_kept.ray.met->hit.uncertainty};
    switch (m_space) {
    case Space::World: addRows({}, pick.point.world, pick.uncertainty.world, onMesh); break;
    case Space::Eye:
        if (const Result<EyeFrame> frame = eyeFrame(pick.setup.camera()); onMesh && frame) {
            onMesh->uncertainty = mapped(glm::dmat3(eyeFromWorld(*frame)), onMesh->uncertainty);
            onMesh->at = eyeFromWorld(*frame, worldPoint(onMesh->at));
        }
        addRows({}, pick.point.eye, pick.uncertainty.eye, onMesh);
        break;
    case Space::Object: addObjectRows(pick, onMesh); break;
    }
}

int ComparisonModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ComparisonModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

std::optional<double> ComparisonModel::value(const Row &row, int column) const
{
    const auto by = [&row](Method method) { return row.by[static_cast<std::size_t>(method)]; };
    const auto differenceTo = [&](const std::optional<double> &other) {
        const std::optional<double> formula = by(Method::Formula);
        return formula && other ? std::optional(*formula - *other) : std::nullopt;
    };
    switch (column) {
    case Formula: return by(Method::Formula);
    case Matrix: return by(Method::Matrix);
    case Difference: return differenceTo(by(Method::Matrix));
    case Ulps: {
        const std::optional<double> d = differenceTo(by(Method::Matrix));
        return d ? std::optional(*d / row.ulp) : std::nullopt;
    }
    case MatrixInFloat: return by(Method::MatrixInFloat);
    case FloatDifference: return differenceTo(by(Method::MatrixInFloat));
    case Ray: return row.ray;
    case RayDifference: return differenceTo(row.ray);
    default: return std::nullopt;
    }
}

double ComparisonModel::uncertainty(const Row &row, int column) const
{
    if (column == Ray)
        return row.rayUncertainty;
    const std::optional<double> formula = value(row, Formula), own = value(row, column);
    return isCoordinate(column) && formula && own ? row.uncertainty + std::abs(*formula - *own) : row.uncertainty;
}

QVariant ComparisonModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row &row = m_rows[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    const std::optional<double> v = value(row, column);
    // All columns have the same decimals; each has its own certain digits.
    const auto notation = [&] {
        return notationWithin(row.point, *v, column == Ray ? row.rayUncertainty : row.uncertainty);
    };
    switch (role) {
    case Qt::DisplayRole:
        if (!v)
            return column >= Ray ? QStringLiteral("–") : tr("none");
        if (isCoordinate(column))
            return notation().text(*v);
        return column == Ulps ? ulpsText(*v) : significantText(*v, 2);
    case kCertainLengthRole:
        return v && isCoordinate(column)
                   ? QVariant(static_cast<int>(notation().certainLength(*v, uncertainty(row, column))))
                   : QVariant();
    case kValueRole: return v ? QVariant(*v) : QVariant();
    case Qt::ToolTipRole:
        if (!v)
            return {};
        if (!isCoordinate(column) || uncertainty(row, column) == 0.0)
            return shortestText(*v);
        return tr("%1 ± %2\nGrey digits are smaller than the uncertainty.")
            .arg(shortestText(*v), boundText(uncertainty(row, column)));
    case Qt::TextAlignmentRole: return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    default: return {};
    }
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
    QString point = m_space == Space::Eye ? QStringLiteral("eye") : QStringLiteral("world");
    if (!m_kept.pick->hit())
        point = index.row() < 3 ? QStringLiteral("rayNear") : QStringLiteral("rayFar");
    else if (m_space == Space::Object)
        point = QStringLiteral("object");
    switch (index.column()) {
    case Difference: return point + QStringLiteral("Difference");
    case Ulps: return point + QStringLiteral("DifferenceInUlps");
    case MatrixInFloat: return point + QStringLiteral("InFloat");
    case FloatDifference: return point + QStringLiteral("FloatDifference");
    case Ray: return point + QStringLiteral("OnMesh");
    case RayDifference: return point + QStringLiteral("RayDifference");
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
        case Formula: return tr("Formula");
        case Matrix: return tr("Matrix");
        case Difference: return tr("Difference");
        case Ulps: return tr("in ulp");
        case MatrixInFloat: return tr("Float");
        case FloatDifference: return tr("Formula − float");
        case Ray: return tr("Exact hit");
        case RayDifference: return tr("Formula − hit");
        default: return {};
        }
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case Formula: return tr("Closed-form formulas (9) to (12) in double precision");
        case Matrix: return tr("Inverse of projection × view in double precision, as in gluUnProject");
        case Difference: return tr("Formula minus matrix inverse");
        case Ulps: return tr("The difference in units in the last place of the point's largest component");
        case MatrixInFloat: return tr("The inverted matrix computed in single precision, as in many programs");
        case FloatDifference: return tr("Formula minus the single-precision result");
        case Ray:
            return tr("Where the ray through the pixel's centre meets the mesh itself, in double, without the depth "
                      "buffer");
        case RayDifference: return tr("Formula minus exact hit");
        default: return {};
        }
    }
    return QAbstractTableModel::headerData(section, orientation, role);
}

} // namespace unprojector::gui
