#include "gui/click/ray_model.h"

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;
using namespace ray;
namespace {

bool isPoint(int column)
{
    return column == RayModel::Met || column == RayModel::Taken;
}

} // namespace

RayModel::RayModel(QObject *parent) : CoordinatesModel(parent) {}

void RayModel::setRay(const Pick *pick, const PickedRay *ray)
{
    m_points = {};
    m_snap = ray ? ray->snap : Snap::Surface;
    if (pick && ray && ray->met) {
        const SceneHit &met = ray->met->hit;
        m_points[Met] = Point{met.world, met.uncertainty};
        if (met.triangle)
            m_points[Normal] = Point{met.triangle->normal, {}};
        if (m_snap == Snap::Surface)
            m_points[Taken] = Point{met.vertex.world, met.vertex.uncertainty};
    }
    if (pick && ray && ray->taken && m_snap != Snap::Surface) {
        const SceneHit &taken = ray->taken->hit;
        m_points[Taken] = Point{m_snap == Snap::Vertex ? taken.vertex.world : taken.world, taken.uncertainty};
        if (taken.triangle)
            m_points[Normal] = Point{taken.triangle->normal, {}};
    }
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    emit headerDataChanged(Qt::Horizontal, Taken, Taken);
}

int RayModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : 3;
}

int RayModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant RayModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const std::optional<Point> &point = this->point(index.column());
    const double value = point ? point->at[index.row()] : 0.0;
    const double uncertainty = point ? point->uncertainty[index.row()] : 0.0;
    const auto notation = [&] { return notationWithin(point->at, value, uncertainty); };
    switch (role) {
    case Qt::DisplayRole:
        if (!point)
            return QStringLiteral("–");
        if (isPoint(index.column()))
            return notation().text(value);
        return fixedText(value, 5);
    case kCertainLengthRole:
        return point && isPoint(index.column())
                   ? QVariant(static_cast<int>(notation().certainLength(value, uncertainty)))
                   : QVariant();
    case kValueRole: return point ? QVariant(value) : QVariant();
    case Qt::ToolTipRole:
        if (!point)
            return {};
        return isPoint(index.column()) ? tr("%1 ± %2").arg(shortestText(value), readableText(uncertainty))
                                       : shortestText(value);
    case Qt::TextAlignmentRole: return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    default: return {};
    }
}

QString RayModel::toolTip(int column) const
{
    switch (column) {
    case Met:
        return tr(
            "Where the ray through the pixel's centre meets the mesh itself, in double, without the depth buffer; "
            "world units");
    case Normal: return tr("The normal of the triangle, of length 1, world space");
    default: break;
    }
    switch (m_snap) {
    case Snap::Surface: return tr("The nearest corner of the triangle; world units");
    case Snap::Vertex: return tr("The vertex that the click takes; world units");
    case Snap::Edge: return tr("The point of an edge that the click takes; world units");
    case Snap::Face: return tr("The point of the face that the click takes; world units");
    }
    Q_UNREACHABLE();
}

QVariant RayModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical && role == Qt::DisplayRole && section >= 0 && section < rowCount())
        return QString(QChar(u'x' + section));
    if (orientation == Qt::Horizontal && role == Qt::DisplayRole) {
        switch (section) {
        case Met: return tr("Exact hit");
        case Normal: return tr("Normal");
        case Taken: return m_snap == Snap::Edge ? tr("On edge") : m_snap == Snap::Face ? tr("On face") : tr("Vertex");
        default: return {};
        }
    }
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole)
        return toolTip(section);
    return CoordinatesModel::headerData(section, orientation, role);
}

std::vector<double> RayModel::pointAt(const QModelIndex &index) const
{
    const std::optional<Point> &point = this->point(index.column());
    return point ? std::vector<double>{point->at[0], point->at[1], point->at[2]} : std::vector<double>();
}

QString RayModel::pointNameAt(const QModelIndex &index) const
{
    switch (index.column()) {
    case Met: return QStringLiteral("rayOnMesh");
    case Normal: return QStringLiteral("normal");
    default: break;
    }
    switch (m_snap) {
    case Snap::Edge: return QStringLiteral("edgePoint");
    case Snap::Face: return QStringLiteral("facePoint");
    case Snap::Surface:
    case Snap::Vertex: break;
    }
    return QStringLiteral("vertex");
}

} // namespace unprojector::gui
