#pragma once

#include "core/landmarks/landmark.h"
#include "gui/widgets/coordinates_model.h"

#include <QAbstractTableModel>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// The placed points, one a row: number, name, where it is in the world and how far each coordinate can be off, its object, by
/// what it is held there, its note. Names, notes and coordinates are edited in place; checking hides and shows; dragging a row
/// puts the point elsewhere in the list. All of it is the document's.
class LandmarksModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Name, X, Y, Z, PlusMinus, Object, HeldBy, Note, ColumnCount };
    /// As CoordinatesModel has it, for what draws it: how many characters of a coordinate are certain.
    static constexpr int kCertainLengthRole = CoordinatesModel::kCertainLengthRole;
    /// What a row is sorted by.
    static constexpr int kSortRole = CoordinatesModel::kValueRole;
    /// Characters of a coordinate as a rule, with its sign: "-123.456".
    static constexpr int kCoordinateRoom = 8;
    /// The most of one that has more certain digits than that.
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
    /// What was typed is no coordinate, and why.
    void refused(const QString &reason);
    /// What was typed counts.
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
