#pragma once

#include "core/scene/scene.h"

#include <QAbstractTableModel>

#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// The scene's objects, one a row: name, visibility, number of triangles. Names are edited in
/// place, checking hides and shows, dragging a row moves the object in the list; all changes go to
/// the document.
class ObjectsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Triangles, ColumnCount };

    explicit ObjectsModel(SceneDocument &document, QObject *parent = nullptr);

    /// The present row of an object from before the last reset, -1 if it was removed.
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
    /// Emitted when the typed text is no valid name, with the reason.
    void nameRefused(const QString &reason);
    /// Emitted when the typed name was accepted.
    void nameAccepted();

private:
    QString toolTip(const scene::SceneObject &object) const;

    SceneDocument &m_document;
    std::vector<scene::SceneObject> m_listed; ///< as the rows show them
    std::vector<scene::SceneObject> m_before; ///< before the last reset
};

} // namespace unprojector::gui
