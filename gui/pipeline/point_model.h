#pragma once

#include "core/geometry/api_conventions.h"
#include "core/geometry/result.h"
#include "core/geometry/spaces.h"
#include "core/pipeline/pipeline.h"
#include "gui/pipeline/matrix_view.h"
#include "gui/widgets/number_grid_model.h"

#include <array>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// One point of the pipeline: x, y, z and w in a line. w is 1 in every space but clip, and on the
/// way back before the division; a widget position has only x and y.
class PointModel : public NumberGridModel {
    Q_OBJECT
public:
    /// The spaces of the panel, in forward order.
    enum class Space { Object, World, Eye, Clip, Ndc, Window, Widget };
    static constexpr int kSpaces = 7;

    explicit PointModel(Space space, QObject *parent = nullptr);

    template <class Tag>
    void setPoint(const geometry::Result<geometry::Point<Tag>> &point)
    {
        if (!point) {
            clearPoint();
            return;
        }
        Coordinates coordinates;
        for (int i = 0; i < Tag::kDimension; ++i)
            coordinates[static_cast<std::size_t>(i)] = (*point)[i];
        if (Tag::kDimension == 3)
            coordinates[3] = 1.0;
        setCoordinates(coordinates);
    }
    /// Replaces the clip point on the way back: the eye point before the division by its w'.
    void setUndivided(const std::optional<glm::dvec4> &point);
    /// Clears the point: a dash for each coordinate.
    void clearPoint();
    void setView(const MatrixView &view);
    void setDirection(pipeline::PipelineDirection direction);
    /// Sets the API of the coordinates, for their tooltips.
    void setApi(geometry::Api api) { m_api = api; }

    Space space() const { return m_space; }
    /// The number of coordinates in the space.
    std::size_t ownCount() const { return static_cast<std::size_t>(m_own); }
    /// "world"
    static QString nameOf(Space space);
    /// The name; for the numbers before the division on the way back "eye · w′".
    QString name() const;
    /// The cell of a coordinate: 0 for x, 3 for w.
    QModelIndex indexOf(int coordinate) const;
    /// The coordinates in the space, without an implied w of 1. Empty without a point.
    std::vector<double> coordinates() const;
    /// "(1, 2.5, 3)" with all digits; "–" without a point.
    QString fullText() const;
    Copyable copyable() const override;

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    /// Emits `typed` for a user's text for one coordinate, or for all of the space at once, and
    /// doesn't change the point.
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    bool isTypable() const override { return !isUndivided(); }
    void typeAll(const QString &text) override { emit typed(0, text); }

signals:
    /// @param coordinate  0 for x, 3 for w
    void typed(int coordinate, const QString &text);

protected:
    QString label(int row, int column) const override;
    QString toolTip(int row, int column) const override;

private:
    using Coordinates = std::array<std::optional<double>, 4>;
    void setCoordinates(const Coordinates &coordinates);
    void show();
    /// Returns whether these are the four numbers before the division on the way back.
    bool isUndivided() const;

    Space m_space;
    int m_own;   ///< number of coordinates in this space
    int m_shown; ///< with w
    Coordinates m_coordinates;
    MatrixView m_view;
    geometry::Api m_api = geometry::Api::OpenGl;
    pipeline::PipelineDirection m_direction = pipeline::PipelineDirection::Forward;
};

} // namespace unprojector::gui
