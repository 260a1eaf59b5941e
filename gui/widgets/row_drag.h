#pragma once

#include <QModelIndex>
#include <QString>

#include <cstddef>
#include <optional>

class QMimeData;

namespace unprojector::gui {

/// A row of a list that the user drags to another position in it.
struct RowMove {
    std::size_t from = 0;
    std::size_t to = 0; ///< its index afterwards
};

/// The first row of the selection, for QAbstractItemModel::mimeData; null if nothing is selected.
/// @param type  of the list's own rows: "application/x-…"
QMimeData *draggedRow(const QModelIndexList &indexes, const QString &type);

/// The move of a drop, by the arguments of QAbstractItemModel::dropMimeData; nothing if it is no
/// row of this list.
/// @param rows  how many the list has
std::optional<RowMove> droppedRow(const QMimeData &data, Qt::DropAction action, int row, const QModelIndex &parent,
                                  int rows, const QString &type);

} // namespace unprojector::gui
