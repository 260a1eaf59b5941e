#include "gui/panels/point_model.h"

#include <QStringList>

namespace unprojector::gui {
namespace {

int coordinatesIn(PointModel::Space space)
{
    switch (space) {
    case PointModel::Space::Clip: return 4;
    case PointModel::Space::Widget: return 2;
    case PointModel::Space::Object:
    case PointModel::Space::World:
    case PointModel::Space::Eye:
    case PointModel::Space::Ndc:
    case PointModel::Space::Window: return 3;
    }
    Q_UNREACHABLE();
}

} // namespace

PointModel::PointModel(Space space, QObject *parent)
    : NumberGridModel(parent), m_space(space), m_coordinates(coordinatesIn(space))
{
    clearPoint();
}

void PointModel::clearPoint()
{
    setCoordinates({});
}

void PointModel::setCoordinates(const Coordinates &coordinates)
{
    setNumbers(1, 4, Numbers(coordinates.begin(), coordinates.end()), Digits::Double);
}

QString PointModel::name() const
{
    switch (m_space) {
    case Space::Object: return tr("object");
    case Space::World: return tr("world");
    case Space::Eye: return tr("eye");
    case Space::Clip: return tr("clip");
    case Space::Ndc: return tr("NDC");
    case Space::Window: return tr("window");
    case Space::Widget: return tr("widget");
    }
    Q_UNREACHABLE();
}

QString PointModel::fullText() const
{
    if (!index(0, 0).data(kValueRole).isValid())
        return QStringLiteral("–");
    QStringList coordinates;
    for (int i = 0; i < m_coordinates; ++i)
        coordinates << NumberGridModel::fullText(0, i);
    return QStringLiteral("(%1)").arg(coordinates.join(QStringLiteral(", ")));
}

QVariant PointModel::data(const QModelIndex &index, int role) const
{
    if (index.isValid() && index.column() >= m_coordinates)
        return {};
    return NumberGridModel::data(index, role);
}

QString PointModel::toolTip(int, int column) const
{
    const QChar axis = QStringLiteral("xyzw")[column];
    const QString number = NumberGridModel::fullText(0, column);
    switch (m_space) {
    case Space::Object: return tr("%1 = %2\nin the object's own units").arg(axis, number);
    case Space::World: return tr("%1 = %2\nin world units").arg(axis, number);
    case Space::Eye:
        return column == 2 ? tr("z = %1\nin world units; the eye looks along −z").arg(number)
                           : tr("%1 = %2\nin world units, from the eye").arg(axis, number);
    case Space::Clip:
        return column == 3 ? tr("w = %1\nwhat x, y and z are divided by").arg(number)
                           : tr("%1 = %2\nhomogeneous; inside the view volume from −w to w").arg(axis, number);
    case Space::Ndc: return tr("%1 = %2\ninside the view volume from −1 to 1").arg(axis, number);
    case Space::Window:
        return column == 2 ? tr("depth = %1\nin the depth range").arg(number)
                           : tr("%1 = %2\nin device pixels from the bottom-left corner, y up").arg(axis, number);
    case Space::Widget: return tr("%1 = %2\nin logical pixels from the top-left corner, y down").arg(axis, number);
    }
    Q_UNREACHABLE();
}

} // namespace unprojector::gui
