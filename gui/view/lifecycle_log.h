#pragma once

#include "gui/view/lifecycle_event.h"

#include <QAbstractTableModel>
#include <QElapsedTimer>

#include <deque>

namespace unprojector::gui {

/// The steps of a view's life in the order they happened. Steps of OnDraw, one right after the other, are one row.
class LifecycleLog : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Time, Step, StandsFor, Took, ColumnCount };
    /// Where there are more rows, the oldest go.
    static constexpr int kMostRows = 2000;

    explicit LifecycleLog(QObject *parent = nullptr);

    void append(const LifecycleEvent &event);
    /// Empties the log. Its clock runs on.
    void clear();

    /// The rows from `first` to `last`, one a line, tab-separated.
    QString text(int first, int last) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Row {
        LifecycleEvent event; ///< the last of those that it stands for
        double firstSeconds = 0.0;
        double lastSeconds = 0.0;
        int count = 1;
        int standIns = 0; ///< of these pictures, those with coarse models
        double totalMilliseconds = 0.0;
    };

    QElapsedTimer m_clock; ///< since the first step
    std::deque<Row> m_rows;
};

} // namespace unprojector::gui
