#pragma once

#include "core/unproject/answers.h"
#include "gui/document/kept_pick.h"
#include "gui/text/number_text.h"
#include "gui/widgets/coordinates_model.h"

#include <glm/mat3x3.hpp>

#include <array>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// The largest error of a vector's coordinates after a linear map, from the uncertainty of each.
geometry::Components<3> mapped(const glm::dmat3 &map, const geometry::Components<3> &uncertainty);

/// A pick in one space: a row for each of x, y, z; on the background, rows for the ray's near and
/// far points. Its columns are the two methods and their difference, single precision, and the
/// ray's hit on the mesh itself.
class ComparisonModel : public CoordinatesModel {
    Q_OBJECT
public:
    enum Column { Formula, Matrix, Difference, Ulps, MatrixInFloat, FloatDifference, Ray, RayDifference, ColumnCount };
    enum class Space { World, Eye, Object };

    using CoordinatesModel::CoordinatesModel;

    /// Sets the pick; without one there are no rows.
    void setPick(const KeptPick &kept);
    /// The space of the rows; the background has no object: it is then in world space.
    void setSpace(Space space);
    Space space() const { return m_space; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    std::vector<double> pointAt(const QModelIndex &index) const override;
    QString pointNameAt(const QModelIndex &index) const override;

private:
    struct Row {
        QString name;
        std::array<std::optional<double>, unproject::kMethods.size()> by; ///< each method's coordinate
        std::optional<double> ray;                                        ///< of the point on the mesh
        double ulp = 0.0;              ///< spacing of doubles at the point's largest component
        double uncertainty = 0.0;      ///< of the coordinate
        double rayUncertainty = 0.0;   ///< of `ray`
        geometry::Components<3> point; ///< the whole point, by the formula
    };
    /// A point on the mesh and its uncertainty, in the space of the rows.
    struct MeshPoint {
        geometry::Components<3> at;
        geometry::Components<3> uncertainty;
    };
    void setRows();
    template <typename OfPoint>
    void addRows(const QString &name, const unproject::Answers<OfPoint> &point,
                 const geometry::Components<3> &uncertainty, const std::optional<MeshPoint> &onMesh = {});
    void addObjectRows(const unproject::Pick &pick, const std::optional<MeshPoint> &onMesh);

    std::optional<double> value(const Row &row, int column) const;
    /// The uncertainty of a cell; for a method's answer, plus its difference from the formula's.
    double uncertainty(const Row &row, int column) const;

    KeptPick m_kept;
    Space m_space = Space::World;
    std::vector<Row> m_rows;
};

} // namespace unprojector::gui
