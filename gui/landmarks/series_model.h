#pragma once

#include <QAbstractTableModel>
#include <QStringList>

namespace unprojector::gui {

class ScanSeries;

/// The scans of a series, one a row: its name, the number of placed landmarks, and which ones.
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

    ScanSeries &m_series;
    QStringList m_names;
    int m_rows = 0;
};

} // namespace unprojector::gui
