#pragma once

#include "core/geometry/viewport.h"

#include <QRect>

namespace unprojector::gui {

/// The placement of a surface on a widget: pixel on pixel if it fits, else scaled down, and always
/// centred. Only this class converts positions between both.
class SurfacePlace {
public:
    /// @param widget   the surface of the widget itself, see surfaceFromWidget
    /// @param surface  the shown surface; another pixel ratio is allowed
    /// @pre both are valid
    SurfacePlace(const geometry::Surface &widget, const geometry::Surface &surface);

    /// Returns whether the surface is the widget's own: then positions stay the same.
    bool isWidget() const { return m_widget == m_surface; }
    /// The surface's rectangle on the widget, device pixels, origin top-left.
    const QRect &rectangle() const { return m_rectangle; }
    /// Device pixels of the widget for one of the surface, at most 1.
    double scale() const;

    /// A position on the widget converted to one on the surface, both in logical pixels. Positions
    /// beside the surface are outside it.
    geometry::WidgetPoint onSurface(const geometry::WidgetPoint &onWidget) const;
    geometry::WidgetPoint onWidget(const geometry::WidgetPoint &onSurface) const;

private:
    geometry::Surface m_widget, m_surface;
    QRect m_rectangle;
};

} // namespace unprojector::gui
