#pragma once

#include "core/scene/scene.h"

#include <QAbstractTableModel>

#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// The scene's objects, one a row: name, whether it is shown, number of triangles. Names are edited in place, checking hides
/// and shows, dragging a row puts the object elsewhere in the list; all of it is the document's.
class ObjectsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Triangles, ColumnCount };

    explicit ObjectsModel(SceneDocument &document, QObject *parent = nullptr);

    /// The row that the object of a row before the last reset has now, -1 where it went.
    int rowAfterReset(int row) const;

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
    /// What was typed is no name for an object, and why.
    void nameRefused(const QString &reason);
    /// What was typed is the object's name now.
    void nameAccepted();

private:
    QString toolTip(const scene::SceneObject &object) const;

    SceneDocument &m_document;
    std::vector<scene::SceneObject> m_listed; ///< as the rows show them
    std::vector<scene::SceneObject> m_before; ///< the last reset
};

} // namespace unprojector::gui
