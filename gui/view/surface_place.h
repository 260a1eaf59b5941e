#pragma once

#include "core/geometry/viewport.h"

#include <QRect>

namespace unprojector::gui {

/// Where a surface is shown on a widget: pixel on pixel where the widget has room for it, else scaled down, and always in
/// the middle. Positions go from one to the other here and nowhere else.
class SurfacePlace {
public:
    /// @param widget   the surface of the widget itself, see surfaceFromWidget
    /// @param surface  what is shown on it; another pixel ratio is allowed
    /// @pre both are valid
    SurfacePlace(const geometry::Surface &widget, const geometry::Surface &surface);

    /// Whether the surface is the widget's own: then positions stay as they are.
    bool isWidget() const { return m_widget == m_surface; }
    /// What the surface takes of the widget, device pixels, origin top-left.
    const QRect &rectangle() const { return m_rectangle; }
    /// Device pixels of the widget to one of the surface, at most 1.
    double scale() const;

    /// A position on the widget as one on the surface, both in logical pixels. Beside the surface it lies outside of it.
    geometry::WidgetPoint onSurface(const geometry::WidgetPoint &onWidget) const;
    geometry::WidgetPoint onWidget(const geometry::WidgetPoint &onSurface) const;

private:
    geometry::Surface m_widget, m_surface;
    QRect m_rectangle;
};

} // namespace unprojector::gui
