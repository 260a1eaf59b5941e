#pragma once

#include "core/landmarks/landmark.h"

#include <QAbstractTableModel>
#include <QStringList>

#include <vector>

namespace unprojector::gui {

class ScanSeries;

/// The scans of a series, one a row: its name, the number of placed landmarks, and which ones; then the
/// measures of the protocol.
class SeriesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Scan, Placed, FirstLandmark };

    explicit SeriesModel(ScanSeries &series, QObject *parent = nullptr);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QVariant text(const QModelIndex &index) const;
    /// The measure of a column; null for another column.
    const landmarks::KeptMeasure *measureOf(int column) const;

    ScanSeries &m_series;
    QStringList m_names;
    std::vector<landmarks::KeptMeasure> m_measures;
    int m_rows = 0;
};

} // namespace unprojector::gui
