#include "gui/pipeline/point_model.h"

#include "gui/text/api_text.h"

#include <QStringList>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;

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
    : NumberGridModel(parent), m_space(space), m_own(coordinatesIn(space)),
      m_shown(space == Space::Widget ? coordinatesIn(space) : 4)
{
    show();
}

void PointModel::clearPoint()
{
    setCoordinates({});
}

void PointModel::setUndivided(const std::optional<glm::dvec4> &point)
{
    if (point)
        setCoordinates({point->x, point->y, point->z, point->w});
    else
        clearPoint();
}

void PointModel::setCoordinates(const Coordinates &coordinates)
{
    m_coordinates = coordinates;
    show();
}

void PointModel::setView(const MatrixView &view)
{
    m_view = view;
    show();
}

void PointModel::setDirection(PipelineDirection direction)
{
    m_direction = direction;
}

void PointModel::show()
{
    setNumbers(1, m_shown, Numbers(m_coordinates.begin(), m_coordinates.begin() + m_shown), m_view.digits,
               m_view.isWhole);
}

bool PointModel::isUndivided() const
{
    return m_space == Space::Clip && m_direction == PipelineDirection::Backward;
}

QModelIndex PointModel::indexOf(int coordinate) const
{
    return index(0, coordinate);
}

QString PointModel::label(int, int column) const
{
    const QChar axis = QStringLiteral("xyzw")[column];
    return isUndivided() ? axis + QStringLiteral("′") : QString(axis);
}

QString PointModel::name() const
{
    return isUndivided() ? tr("eye · w′") : nameOf(m_space);
}

QString PointModel::nameOf(Space space)
{
    switch (space) {
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

std::vector<double> PointModel::coordinates() const
{
    std::vector<double> values;
    for (int i = 0; i < m_own; ++i) {
        if (const std::optional<double> &value = m_coordinates[static_cast<std::size_t>(i)])
            values.push_back(*value);
    }
    return values;
}

Qt::ItemFlags PointModel::flags(const QModelIndex &index) const
{
    const bool isOwn = index.isValid() && index.column() < m_own;
    const Qt::ItemFlags flags = NumberGridModel::flags(index);
    return isOwn && isTypable() ? flags | Qt::ItemIsEditable : flags;
}

bool PointModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable))
        return false;
    const QString text = value.toString().trimmed();
    if (text == data(index, Qt::EditRole).toString()) // the text is unchanged
        return false;
    emit typed(index.column(), text);
    return true;
}

Copyable PointModel::copyable() const
{
    const auto name = [this] {
        switch (m_space) {
        case Space::Object: return QStringLiteral("object");
        case Space::World: return QStringLiteral("world");
        case Space::Eye: return QStringLiteral("eye");
        case Space::Clip: return isUndivided() ? QStringLiteral("undividedEye") : QStringLiteral("clip");
        case Space::Ndc: return QStringLiteral("ndc");
        case Space::Window: return QStringLiteral("window");
        case Space::Widget: return QStringLiteral("widget");
        }
        Q_UNREACHABLE();
    };
    return {name(), coordinates()};
}

QString PointModel::fullText() const
{
    QStringList texts;
    for (const double value : coordinates())
        texts << QString::fromStdString(numberText(value, Digits::Double));
    return texts.isEmpty() ? QStringLiteral("–") : QStringLiteral("(%1)").arg(texts.join(QStringLiteral(", ")));
}

QString PointModel::toolTip(int row, int column) const
{
    const QString number = NumberGridModel::fullText(row, column);
    const QString axis = label(row, column);
    if (isUndivided())
        return column == 3 ? tr("%1 = %2\nwhat x′, y′ and z′ are divided by").arg(axis, number)
                           : tr("%1 = %2\nof the eye point before the division by its own w′").arg(axis, number);
    if (column >= m_own)
        return tr("w = %1\nof a point that needs no division").arg(number);
    const bool isOpenGl = m_api == Api::OpenGl || m_space == Space::Object || m_space == Space::Widget;
    if (!isOpenGl) // the convention's own terms
        return QStringLiteral("%1 = %2\n%3: %4")
            .arg(axis, number, QString::fromUtf8(conventionsOf(m_api).name), apiText(m_api));
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
