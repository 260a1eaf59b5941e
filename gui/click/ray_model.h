#pragma once

#include "gui/document/picked_ray.h"
#include "gui/text/number_text.h"
#include "gui/widgets/coordinates_model.h"

#include <array>
#include <optional>

namespace unprojector::gui {

/// The hit of a click's ray on the meshes as a table: x, y and z, world space, of the point, of the
/// surface's normal, and of the nearest vertex or the snapped point.
class RayModel : public CoordinatesModel {
    Q_OBJECT
public:
    enum Column { Met, Normal, Taken, ColumnCount };

    explicit RayModel(QObject *parent = nullptr);

    /// @param pick, ray  null: there is no pick
    void setRay(const unproject::Pick *pick, const PickedRay *ray);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    std::vector<double> pointAt(const QModelIndex &index) const override;
    QString pointNameAt(const QModelIndex &index) const override;

private:
    struct Point {
        geometry::Components<3> at;
        geometry::Components<3> uncertainty; ///< meaningful for a point
    };
    const std::optional<Point> &point(int column) const { return m_points[static_cast<std::size_t>(column)]; }
    QString toolTip(int column) const;

    std::array<std::optional<Point>, ColumnCount> m_points;
    ray::Snap m_snap = ray::Snap::Surface;
};

} // namespace unprojector::gui
