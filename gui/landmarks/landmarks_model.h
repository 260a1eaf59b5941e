#pragma once

#include "core/landmarks/landmark.h"
#include "gui/widgets/coordinates_model.h"

#include <QAbstractTableModel>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// The landmarks, one a row: number, name, world position and uncertainty of each coordinate,
/// object, anchor, note. Names, notes and coordinates are edited in place; checking hides and
/// shows; dragging a row moves the landmark in the list. All changes go to the document.
class LandmarksModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Name, X, Y, Z, PlusMinus, Object, HeldBy, Note, ColumnCount };
    /// The number of certain characters of a coordinate, for its delegate, as in CoordinatesModel.
    static constexpr int kCertainLengthRole = CoordinatesModel::kCertainLengthRole;
    /// The sort key of a row.
    static constexpr int kSortRole = CoordinatesModel::kValueRole;
    /// The usual number of characters of a coordinate, with its sign: "-123.456".
    static constexpr int kCoordinateRoom = 8;
    /// The largest number of characters, for a coordinate with more certain digits.
    static constexpr int kMostCoordinateRoom = 13;

    explicit LandmarksModel(SceneDocument &document, QObject *parent = nullptr);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    QStringList mimeTypes() const override;
    QMimeData *mimeData(const QModelIndexList &indexes) const override;
    bool dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int column,
                      const QModelIndex &parent) override;

signals:
    /// Emitted when the typed text is no coordinate, with the reason.
    void refused(const QString &reason);
    /// Emitted when the typed text was accepted.
    void accepted();

private:
    const landmarks::Landmark &point(const QModelIndex &index) const;
    QString coordinateText(const landmarks::Landmark &landmark, int axis) const;
    QVariant certainLength(const landmarks::Landmark &landmark, int axis) const;
    QVariant text(const QModelIndex &index) const;
    QString toolTip(const QModelIndex &index) const;
    QVariant sortKey(const QModelIndex &index) const;
    bool setCoordinate(std::size_t index, int axis, const QString &typed);

    SceneDocument &m_document;
    std::vector<landmarks::Landmark> m_landmarks; ///< as the rows show them
};

} // namespace unprojector::gui
