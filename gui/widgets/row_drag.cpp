#include "gui/widgets/row_drag.h"

#include <QMimeData>

namespace unprojector::gui {

QMimeData *draggedRow(const QModelIndexList &indexes, const QString &type)
{
    if (indexes.isEmpty())
        return nullptr;
    auto *data = new QMimeData;
    data->setData(type, QByteArray::number(indexes.first().row()));
    return data;
}

std::optional<RowMove> droppedRow(const QMimeData &data, Qt::DropAction action, int row, const QModelIndex &parent,
                                  int rows, const QString &type)
{
    if (action != Qt::MoveAction || !data.hasFormat(type))
        return std::nullopt;
    const int from = data.data(type).toInt();
    // Inserts before that row in the present order; a drop onto a row means before it, beside the
    // rows after the last.
    int to = row >= 0 ? row : parent.isValid() ? parent.row() : rows;
    if (to > from)
        --to; // the row itself is removed from there
    if (from < 0 || from >= rows || to < 0 || to >= rows)
        return std::nullopt;
    return RowMove{static_cast<std::size_t>(from), static_cast<std::size_t>(to)};
}

} // namespace unprojector::gui
