#include "gui/landmarks/landmarks_model.h"

#include "core/base/expression.h"
#include "gui/document/object_names.h"
#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"
#include "gui/text/landmark_text.h"
#include "gui/text/typed_numbers.h"
#include "gui/widgets/number_delegate.h"
#include "gui/widgets/row_drag.h"

#include <QFont>
#include <QGuiApplication>
#include <QIODevice>
#include <QPalette>

#include <algorithm>
#include <limits>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

using landmarks::Landmark;

const QString kRowType = QStringLiteral("application/x-unprojector-point-row");

int axisOf(int column)
{
    return column - LandmarksModel::X;
}

bool isCoordinate(int column)
{
    return column >= LandmarksModel::X && column <= LandmarksModel::Z;
}

} // namespace

LandmarksModel::LandmarksModel(SceneDocument &document, QObject *parent)
    : QAbstractTableModel(parent), m_document(document), m_landmarks(document.landmarks())
{
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (!(changes & Change::Landmarks))
            return;
        if (m_landmarks.size() != m_document.landmarks().size()) {
            beginResetModel();
            m_landmarks = m_document.landmarks();
            endResetModel();
            return;
        }
        // A drag changes one landmark: rows without visible changes are not redrawn.
        std::vector<Landmark> before = std::exchange(m_landmarks, m_document.landmarks());
        for (std::size_t i = 0; i < m_landmarks.size(); ++i) {
            if (before[i] != m_landmarks[i])
                emit dataChanged(index(static_cast<int>(i), 0), index(static_cast<int>(i), ColumnCount - 1));
        }
    });
}

const Landmark &LandmarksModel::point(const QModelIndex &index) const
{
    return m_landmarks[static_cast<std::size_t>(index.row())];
}

int LandmarksModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_landmarks.size());
}

int LandmarksModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString LandmarksModel::coordinateText(const Landmark &landmark, int axis) const
{
    if (!landmark.world && axis == 0 && landmark.absence != landmarks::Absence::NotPlaced)
        return heldByText(landmark); // in a column that is always in sight
    return landmark.world
               ? landmarkNotation(landmark, axis, kCoordinateRoom, kMostCoordinateRoom).text((*landmark.world)[axis])
               : QString(QChar(0x2013));
}

QVariant LandmarksModel::certainLength(const Landmark &landmark, int axis) const
{
    if (!landmark.world)
        return {};
    if (!landmark.uncertainty)
        return 0; // the uncertainty is unknown
    return static_cast<int>(landmarkNotation(landmark, axis, kCoordinateRoom, kMostCoordinateRoom)
                                .certainLength((*landmark.world)[axis], (*landmark.uncertainty)[axis]));
}

QVariant LandmarksModel::text(const QModelIndex &index) const
{
    const Landmark &landmark = this->point(index);
    switch (index.column()) {
    case Number: return index.row() + 1;
    case Name: return shownName(landmark.name);
    case X:
    case Y:
    case Z: return coordinateText(landmark, axisOf(index.column()));
    case PlusMinus: return plusMinusText(landmark);
    case Object: return shownObjectName(landmark.object, m_document.objects());
    case HeldBy: return heldByText(landmark);
    case Note: return shownName(landmark.note);
    default: return {};
    }
}

QString LandmarksModel::toolTip(const QModelIndex &index) const
{
    const Landmark &landmark = this->point(index);
    if (isCoordinate(index.column())) {
        if (!landmark.world)
            return heldByExplanation(landmark);
        const int axis = axisOf(index.column());
        const QString value = writtenText((*landmark.world)[axis]);
        return landmark.uncertainty ? tr("%1 ± %2, world units").arg(value, boundText((*landmark.uncertainty)[axis]))
                                    : tr("%1, world units; uncertainty unknown").arg(value);
    }
    switch (index.column()) {
    case Name: return landmark.isHidden ? tr("%1, hidden").arg(shownName(landmark.name)) : shownName(landmark.name);
    case PlusMinus: {
        if (!landmark.world)
            return {};
        const QString edge = landmarkEdgeText(landmark);
        return (landmark.uncertainty
                    ? tr("Uncertainty in world units: √(±x² + ±y² + ±z²), from the ± of each coordinate")
                    : tr("The uncertainty is unknown, so all digits are grey"))
               + (edge.isEmpty() ? QString() : u'\n' + edge);
    }
    case HeldBy: return heldByExplanation(landmark);
    case Note: return QString::fromStdString(landmark.note);
    default: return text(index).toString();
    }
}

QVariant LandmarksModel::sortKey(const QModelIndex &index) const
{
    const Landmark &landmark = this->point(index);
    if (isCoordinate(index.column())) // those without a position come last
        return landmark.world ? (*landmark.world)[axisOf(index.column())] : std::numeric_limits<double>::infinity();
    if (index.column() == PlusMinus)
        return landmark.world && landmark.uncertainty ? length(*landmark.uncertainty)
                                                      : std::numeric_limits<double>::infinity();
    return text(index);
}

QVariant LandmarksModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Landmark &landmark = this->point(index);
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole: return text(index);
    case Qt::EditRole:
        if (isCoordinate(column))
            return landmark.world ? writtenText((*landmark.world)[axisOf(column)]) : QString();
        if (column == Name || column == Note)
            return QString::fromStdString(column == Name ? landmark.name : landmark.note);
        return text(index);
    case Qt::CheckStateRole:
        return column == Name ? QVariant(landmark.isHidden ? Qt::Unchecked : Qt::Checked) : QVariant();
    case Qt::DecorationRole:
        return column == Name && landmark.color
                   ? QVariant(QColor(landmark.color->r, landmark.color->g, landmark.color->b))
                   : QVariant();
    case Qt::TextAlignmentRole:
        return column == Number || isCoordinate(column) || column == PlusMinus
                   ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                   : QVariant();
    case Qt::ForegroundRole:
        return landmark.isHidden || !landmark.isPlaced()
                   ? QVariant(QGuiApplication::palette().brush(QPalette::PlaceholderText))
                   : QVariant();
    case Qt::ToolTipRole: return plainToolTip(toolTip(index));
    case kCertainLengthRole: return isCoordinate(column) ? certainLength(landmark, axisOf(column)) : QVariant();
    case NumberDelegate::kTextsRole:
        return column == PlusMinus ? QVariant(QStringList(plusMinusText(landmark))) : QVariant();
    case kSortRole: return sortKey(index);
    default: return {};
    }
}

QVariant LandmarksModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return section == Number || isCoordinate(section) || section == PlusMinus
                   ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                   : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const bool isTip = role == Qt::ToolTipRole;
    switch (section) {
    case Number: return isTip ? tr("Number in the list, and in files without names") : QStringLiteral("№");
    case Name: return tr("Name");
    case X: return isTip ? tr("World x; grey digits are smaller than the uncertainty") : QStringLiteral("x");
    case Y: return isTip ? tr("World y; grey digits are smaller than the uncertainty") : QStringLiteral("y");
    case Z: return isTip ? tr("World z; grey digits are smaller than the uncertainty") : QStringLiteral("z");
    case PlusMinus:
        return isTip ? tr("Uncertainty, world units: half a pixel to the side, and the click's uncertainty. The "
                          "Comparison panel and the map show only the latter")
                     : QStringLiteral("±");
    case Object: return isTip ? tr("Object under the landmark") : tr("Object");
    case HeldBy: return isTip ? tr("Triangle, edge or vertex that holds the landmark") : tr("Held by");
    case Note: return tr("Note");
    default: return {};
    }
}

Qt::ItemFlags LandmarksModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return Qt::ItemIsDropEnabled; // between two rows
    const Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsDragEnabled;
    if (index.column() == Name)
        return flags | Qt::ItemIsEditable | Qt::ItemIsUserCheckable;
    return isCoordinate(index.column()) || index.column() == Note ? flags | Qt::ItemIsEditable : flags;
}

bool LandmarksModel::setCoordinate(std::size_t index, int axis, const QString &typed)
{
    const Landmark &landmark = m_landmarks[index];
    WorldPoint to = landmark.world.value_or(WorldPoint());
    if (const std::optional<std::vector<double>> all = typedNumbers(typed, 3)) {
        to = WorldPoint(all->at(0), all->at(1), all->at(2));
    } else {
        const base::Expected<double, base::ExpressionError> value = base::evaluate(typed.toStdString());
        if (!value) {
            emit refused(errorText(value.error(), typed));
            return false;
        }
        if (!landmark.world) {
            emit refused(tr(
                "This landmark is not placed yet. Type all three coordinates, as “1 2 3”, or place it in the view."));
            return false;
        }
        to[axis] = *value;
    }
    emit accepted();
    return m_document.sceneLandmarks().moveTo(index, to).hasValue();
}

bool LandmarksModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || index.row() >= rowCount())
        return false;
    const auto place = static_cast<std::size_t>(index.row());
    if (role == Qt::CheckStateRole && index.column() == Name)
        return m_document.sceneLandmarks().setHidden({place}, value.toInt() != Qt::Checked).hasValue();
    if (role != Qt::EditRole)
        return false;
    const QString typed = value.toString();
    if (typed == data(index, Qt::EditRole).toString()) { // unchanged text keeps the anchor
        emit accepted();
        return true;
    }
    if (isCoordinate(index.column()))
        return setCoordinate(place, axisOf(index.column()), typed);
    emit accepted();
    if (index.column() == Name)
        return m_document.sceneLandmarks().rename(place, typed).hasValue();
    return index.column() == Note && m_document.sceneLandmarks().setNote(place, typed).hasValue();
}

QStringList LandmarksModel::mimeTypes() const
{
    return {kRowType};
}

QMimeData *LandmarksModel::mimeData(const QModelIndexList &indexes) const
{
    return draggedRow(indexes, kRowType);
}

bool LandmarksModel::dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int, const QModelIndex &parent)
{
    const std::optional<RowMove> move = droppedRow(*data, action, row, parent, rowCount(), kRowType);
    return move && m_document.sceneLandmarks().reorder(move->from, move->to).hasValue();
}

} // namespace unprojector::gui
