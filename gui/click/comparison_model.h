#pragma once

#include "core/unproject/pick.h"
#include "gui/text/number_text.h"
#include "gui/widgets/coordinates_model.h"

#include <array>

#include <optional>
#include <vector>

namespace unprojector::gui {
using namespace unproject;

/// A pick as a table: a row for each of x, y, z of a point, first in world, then in eye space (on the background: of
/// the ray's near and far points in world space); what is certain of it, the two methods, their difference, and what
/// float would give.
class ComparisonModel : public CoordinatesModel {
    Q_OBJECT
public:
    enum Column { Certain, Formula, Matrix, Difference, Ulps, MatrixInFloat, FloatDifference, ColumnCount };
    /// The most characters of the certain column: "-0.12345678".
    static constexpr int kCertainRoom = 11;

    explicit ComparisonModel(QObject *parent = nullptr);

    void setPick(const std::optional<Pick> &pick);
    /// Characters that the columns of the methods have room for; longer numbers are rounded.
    void setCapacity(int characters);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    /// The points that rows are named by, also those that are not there now, for whoever reserves room for their names.
    static QStringList pointNames();

    QString copied(const QModelIndex &index) const override;
    std::vector<double> pointAt(const QModelIndex &index) const override;
    QString pointNameAt(const QModelIndex &index) const override;

private:
    struct Row {
        QString name;
        std::array<std::optional<double>, kMethods.size()> by; ///< each method's coordinate
        double ulp = 0.0;                                      ///< spacing of doubles at the point's largest component
        double uncertainty = 0.0;                              ///< of the coordinate
        Components<3> point;                                   ///< all of it, by the formula
    };
    template <typename Space>
    void addRows(const QString &space, const Answers<Space> &point, const Components<3> &uncertainty);

    static std::optional<double> by(Method method, const Row &row);
    std::optional<double> value(const Row &row, int column) const;
    Notation notation(const Row &row, int column) const;
    QString toolTip(const Row &row, int column) const;

    std::vector<Row> m_rows;
    bool m_isRay = false;
    int m_capacity = 18;
};

} // namespace unprojector::gui
