#pragma once

#include "core/geometry/result.h"
#include "core/geometry/spaces.h"
#include "gui/panels/number_grid_model.h"

namespace unprojector::gui {
using namespace geometry;

/// One point of the pipeline: a row of four, of which a point with fewer coordinates leaves the last ones blank.
class PointModel : public NumberGridModel {
    Q_OBJECT
public:
    /// The points of the panel, as the way forward meets them.
    enum class Space { Object, World, Eye, Clip, Ndc, Window, Widget };
    static constexpr int kSpaces = 7;

    explicit PointModel(Space space, QObject *parent = nullptr);

    template <class Tag>
    void setPoint(const Result<Point<Tag>> &point)
    {
        if (!point) {
            clearPoint();
            return;
        }
        Coordinates coordinates;
        for (int i = 0; i < m_coordinates; ++i)
            coordinates[static_cast<std::size_t>(i)] = (*point)[i];
        setCoordinates(coordinates);
    }
    /// No point: a dash for each coordinate.
    void clearPoint();

    Space space() const { return m_space; }
    /// "world"
    QString name() const;
    /// "(1, 2.5, 3)" with all digits; "–" without a point.
    QString fullText() const;

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

protected:
    QString toolTip(int row, int column) const override;

private:
    using Coordinates = std::array<std::optional<double>, 4>;
    void setCoordinates(const Coordinates &coordinates);

    Space m_space;
    int m_coordinates; ///< of a point in this space
};

} // namespace unprojector::gui
