#include "gui/objects/objects_model.h"

#include "gui/document/object_names.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/text/bundled_names.h"
#include "gui/widgets/row_drag.h"

#include <QDir>
#include <QFont>
#include <QGuiApplication>
#include <QIODevice>
#include <QLocale>
#include <QPalette>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace scene;

namespace {

const QString kRowType = QStringLiteral("application/x-unprojector-object-row");

} // namespace

ObjectsModel::ObjectsModel(SceneDocument &document, QObject *parent)
    : QAbstractTableModel(parent), m_document(document), m_listed(document.objects())
{
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Objects) {
            beginResetModel();
            m_before = std::exchange(m_listed, m_document.objects());
            endResetModel();
        } else if (changes & (Change::Names | Change::Visibility | Change::Placement)) {
            m_listed = m_document.objects();
            if (!m_listed.empty())
                emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        }
    });
}

int ObjectsModel::rowAfterReset(int row) const
{
    const auto index = static_cast<std::size_t>(row);
    if (row < 0 || index >= m_before.size())
        return -1;
    const std::optional<std::size_t> now = indexAfter(m_before, index, m_listed);
    return now ? static_cast<int>(*now) : -1;
}

int ObjectsModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_listed.size());
}

int ObjectsModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString ObjectsModel::toolTip(const SceneObject &object) const
{
    const QString file = QString::fromStdU16String(object.file.u16string());
    QStringList lines{shownObjectName(object.name, m_listed)};
    lines << (file.isEmpty() ? tr("comes with the program") : QDir::toNativeSeparators(file));
    if (object.isHidden)
        lines << tr("hidden: neither drawn nor clicked");
    // A name may look like HTML: it is shown literally.
    return QStringLiteral("<p style='white-space:pre-wrap'>%1</p>")
        .arg(lines.join(u'\n').toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")));
}

QVariant ObjectsModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const SceneObject &object = m_listed[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        if (index.column() == Triangles)
            return QLocale().toString(static_cast<qulonglong>(object.model->triangleCount()));
        return shownObjectName(object.name, m_listed);
    case Qt::EditRole:
        return index.column() == Name ? QVariant(readName(object.name, m_listed))
                                      : QVariant(static_cast<qulonglong>(object.model->triangleCount()));
    case Qt::CheckStateRole:
        return index.column() == Name ? QVariant(object.isHidden ? Qt::Unchecked : Qt::Checked) : QVariant();
    case Qt::TextAlignmentRole:
        return index.column() == Triangles ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ForegroundRole:
        return object.isHidden ? QVariant(QGuiApplication::palette().brush(QPalette::PlaceholderText)) : QVariant();
    case Qt::ToolTipRole: return toolTip(object);
    default: return {};
    }
}

QVariant ObjectsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::DisplayRole)
        return section == Name ? tr("Object") : tr("Triangles");
    if (role == Qt::TextAlignmentRole && section == Triangles)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

Qt::ItemFlags ObjectsModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return Qt::ItemIsDropEnabled; // between two rows
    const Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsDragEnabled;
    return index.column() == Name ? flags | Qt::ItemIsEditable | Qt::ItemIsUserCheckable : flags;
}

bool ObjectsModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || index.row() >= rowCount() || index.column() != Name)
        return false;
    const auto place = static_cast<std::size_t>(index.row());
    if (role == Qt::CheckStateRole)
        return setObjectHidden(m_document, place, value.toInt() != Qt::Checked).hasValue();
    if (role != Qt::EditRole)
        return false;
    const QString name = value.toString().trimmed();
    // An unchanged text is not a new name.
    const std::string &own = m_document.objects()[place].name;
    switch (renameObject(m_document, place,
                         name == readName(own, m_document.objects()) ? QString::fromStdString(own) : name)) {
    case NameFault::None: emit nameAccepted(); return true;
    case NameFault::Empty: emit nameRefused(tr("An object needs a name. The old name is kept.")); return false;
    case NameFault::Taken:
        emit nameRefused(tr("Another object is already called “%1”. Choose another name.").arg(name));
        return false;
    }
    return false;
}

QStringList ObjectsModel::mimeTypes() const
{
    return {kRowType};
}

QMimeData *ObjectsModel::mimeData(const QModelIndexList &indexes) const
{
    return draggedRow(indexes, kRowType);
}

bool ObjectsModel::dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int, const QModelIndex &parent)
{
    const std::optional<RowMove> move = droppedRow(*data, action, row, parent, rowCount(), kRowType);
    return move && moveObject(m_document, move->from, move->to).hasValue();
}

} // namespace unprojector::gui
