#pragma once

#include "core/geometry/setup.h"

#include <QAbstractTableModel>

#include <array>
#include <optional>

namespace unprojector::gui {

/// The window's four corner pixels, the centre pixel and the one under the pointer, in widget,
/// device, window and NDC coordinates. A row describes a click on that pixel: the widget position
/// and the device pixel name its upper left corner, the window and NDC positions its centre, where
/// OpenGL samples. The pointer's row has the pointer's exact widget position.
class CornersModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Row { TopLeft, TopRight, BottomLeft, BottomRight, Centre, Pointer, RowCount };
    enum Column { Widget, Device, Window, Ndc, ColumnCount };
    static constexpr int kValueRole = Qt::UserRole; ///< QPointF, with all digits

    explicit CornersModel(QObject *parent = nullptr);

    /// @pre the setup is valid
    void setSetup(const geometry::Setup &setup);
    /// Sets the pointer's position. For nothing, or a position outside the window, the row is
    /// empty.
    void setPointer(const std::optional<geometry::WidgetPoint> &position);
    /// The centre of the pointer's pixel, with the depth of the near plane.
    std::optional<geometry::WindowPoint> pointerWindow() const;

    /// All rows with all digits, tab-separated, x and y a column each.
    QString text() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Position {
        geometry::WidgetPoint widget;
        geometry::DevicePixel pixel;
        geometry::WindowPoint window;
        geometry::NdcPoint ndc;
    };
    Position position(const geometry::WidgetPoint &widget, const geometry::DevicePixel &pixel) const;
    void findPointer();
    QVariant value(const Position &position, int column) const;

    geometry::Setup m_geometry;
    std::array<std::optional<Position>, RowCount> m_rows;
    std::optional<geometry::WidgetPoint> m_pointer;
};

} // namespace unprojector::gui
