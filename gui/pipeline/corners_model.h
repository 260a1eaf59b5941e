#pragma once

#include "core/geometry/picture.h"

#include <QAbstractTableModel>

#include <array>
#include <optional>

namespace unprojector::gui {
using namespace geometry;

/// The window's four corner pixels, the pixel at its centre and the one under the pointer, in widget, device, window and
/// NDC coordinates. A row is what a click on that pixel stands for: the widget position and the device pixel name its
/// upper left corner, the window and NDC positions its centre, where OpenGL samples. The pointer's widget position is
/// the pointer's own.
class CornersModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Row { TopLeft, TopRight, BottomLeft, BottomRight, Centre, Pointer, RowCount };
    enum Column { Widget, Device, Window, Ndc, ColumnCount };
    static constexpr int kValueRole = Qt::UserRole; ///< QPointF, with all digits

    explicit CornersModel(QObject *parent = nullptr);

    /// @pre the geometry is valid
    void setPicture(const Picture &geometry);
    /// Nothing, or a position outside the window: the row is empty.
    void setPointer(const std::optional<WidgetPoint> &position);
    /// The centre of the pointer's pixel, with the depth of the near plane.
    std::optional<WindowPoint> pointerWindow() const;

    /// All rows with all digits, tab-separated, x and y a column each.
    QString text() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Position {
        WidgetPoint widget;
        DevicePixel pixel;
        WindowPoint window;
        NdcPoint ndc;
    };
    Position position(const WidgetPoint &widget, const DevicePixel &pixel) const;
    void findPointer();
    QVariant value(const Position &position, int column) const;

    Picture m_geometry;
    std::array<std::optional<Position>, RowCount> m_rows;
    std::optional<WidgetPoint> m_pointer;
};

} // namespace unprojector::gui
