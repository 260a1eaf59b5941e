#include "gui/view/surface_place.h"

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;

SurfacePlace::SurfacePlace(const Surface &widget, const Surface &surface) : m_widget(widget), m_surface(surface)
{
    m_rectangle = {0, 0, widget.widthPixels, widget.heightPixels};
    if (isWidget())
        return;
    const double across = static_cast<double>(widget.widthPixels) / surface.widthPixels;
    const double down = static_cast<double>(widget.heightPixels) / surface.heightPixels;
    const double scale = std::min({1.0, across, down});
    const auto scaled = [scale](int pixels) { return std::max(1, static_cast<int>(std::lround(pixels * scale))); };
    const int width = scaled(surface.widthPixels), height = scaled(surface.heightPixels);
    m_rectangle = {(widget.widthPixels - width) / 2, (widget.heightPixels - height) / 2, width, height};
}

double SurfacePlace::scale() const
{
    return static_cast<double>(m_rectangle.width()) / m_surface.widthPixels;
}

WidgetPoint SurfacePlace::onSurface(const WidgetPoint &onWidget) const
{
    if (isWidget())
        return onWidget;
    const DevicePoint device = deviceFromWidget(m_widget, onWidget);
    return widgetFromDevice(
        m_surface, DevicePoint((device.x - m_rectangle.left()) * m_surface.widthPixels / m_rectangle.width(),
                               (device.y - m_rectangle.top()) * m_surface.heightPixels / m_rectangle.height()));
}

WidgetPoint SurfacePlace::onWidget(const WidgetPoint &onSurface) const
{
    if (isWidget())
        return onSurface;
    const DevicePoint device = deviceFromWidget(m_surface, onSurface);
    return widgetFromDevice(m_widget,
                            DevicePoint(m_rectangle.left() + device.x * m_rectangle.width() / m_surface.widthPixels,
                                        m_rectangle.top() + device.y * m_rectangle.height() / m_surface.heightPixels));
}

} // namespace unprojector::gui
