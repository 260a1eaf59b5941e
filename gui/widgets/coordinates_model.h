#pragma once

#include <QAbstractTableModel>
#include <QString>

#include <vector>

namespace unprojector::gui {

/// The coordinates of a point, one row each for x, y, z: the model of a CoordinatesTable.
class CoordinatesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    /// The number of leading certain characters of a coordinate; the rest lies below the
    /// uncertainty.
    static constexpr int kCertainLengthRole = Qt::UserRole;
    /// The double itself; for certain digits only, the rounded one.
    static constexpr int kValueRole = Qt::UserRole + 1;

    using QAbstractTableModel::QAbstractTableModel;

    /// The point that a cell belongs to, by the method of its column: x, y, z; empty without an
    /// answer.
    virtual std::vector<double> pointAt(const QModelIndex &index) const = 0;
    /// The variable name of that point in code: "world", "worldDifference".
    virtual QString pointNameAt(const QModelIndex &index) const = 0;

    /// The text of a cell to copy: all digits, or the certain ones where only those are shown.
    virtual QString copied(const QModelIndex &index) const;
    /// The whole table in that form, tab-separated.
    QString text() const;
};

} // namespace unprojector::gui
