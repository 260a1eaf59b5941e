#pragma once

#include "core/landmarks/out_of_place.h"
#include "gui/landmarks/series_shapes.h"

#include <QAbstractTableModel>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

/// The landmarks of a series by how far they are from where the other scans put them, the worst
/// first.
class DeviationsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Scan, Landmark, Distance, Spreads, Outcome, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// @param scans  names of the files
    void show(landmarks::Deviations deviations, QStringList names, QStringList scans,
              std::vector<landmarks::Pair> pairs);
    const landmarks::Deviation &at(int row) const { return m_deviations.worstFirst[static_cast<std::size_t>(row)]; }
    QString landmarkName(std::size_t landmark) const { return m_names.value(static_cast<qsizetype>(landmark)); }
    const landmarks::Deviations &deviations() const { return m_deviations; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override { return parent.isValid() ? 0 : ColumnCount; }
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString outcomeOf(const landmarks::Deviation &deviation) const;

    landmarks::Deviations m_deviations;
    QStringList m_names, m_scans;
    std::vector<landmarks::Pair> m_pairs;
};

} // namespace unprojector::gui
