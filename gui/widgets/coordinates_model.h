#pragma once

#include <QAbstractTableModel>
#include <QString>

#include <vector>

namespace unprojector::gui {

/// Coordinates, a row for each of x, y, z of a point: what a CoordinatesTable shows.
class CoordinatesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    /// Number of leading characters of a coordinate that are certain; the rest is below what is known of it.
    static constexpr int kCertainLengthRole = Qt::UserRole;
    /// The double itself; of what is certain the rounded one.
    static constexpr int kValueRole = Qt::UserRole + 1;

    using QAbstractTableModel::QAbstractTableModel;

    /// The point that a cell belongs to, by the method of its column: x, y, z as far as there is an answer.
    virtual std::vector<double> pointAt(const QModelIndex &index) const = 0;
    /// What that point is called in code: "world", "worldDifference".
    virtual QString pointNameAt(const QModelIndex &index) const = 0;

    /// A cell as it is copied: all digits; of what is certain those that are.
    virtual QString copied(const QModelIndex &index) const;
    /// The whole table so, tab-separated.
    QString text() const;
};

} // namespace unprojector::gui
