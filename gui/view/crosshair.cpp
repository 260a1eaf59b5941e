#include "gui/view/crosshair.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

DevicePixel Crosshair::pixel() const
{
    const auto &[surface, viewport, depthRange, projection, view] = m_document.setup();
    if (m_pixel && m_pixel->i < surface.widthPixels && m_pixel->j < surface.heightPixels)
        return *m_pixel;
    const DevicePoint middle = deviceFromWindow(
        surface, WindowPoint(viewport.x + viewport.width / 2.0, viewport.y + viewport.height / 2.0, 0.0));
    // A viewport may extend beyond the view.
    const auto inside = [](double place, int count) {
        return static_cast<int>(std::clamp(std::floor(place), 0.0, count - 1.0));
    };
    return {inside(middle.x, surface.widthPixels), inside(middle.y, surface.heightPixels)};
}

WidgetPoint Crosshair::position() const
{
    return widgetFromDevice(m_document.setup().surface, pixelCenter(pixel()));
}

void Crosshair::put(const WidgetPoint &position)
{
    if (const Result<DevicePixel> pixel = devicePixelFromWidget(m_document.setup().surface, position))
        m_pixel = *pixel;
}

void Crosshair::move(const QPoint &way)
{
    const Surface &surface = m_document.setup().surface;
    const DevicePixel from = pixel();
    m_pixel = {std::clamp(from.i + way.x(), 0, surface.widthPixels - 1),
               std::clamp(from.j + way.y(), 0, surface.heightPixels - 1)};
}

bool Crosshair::setShown(bool isShown)
{
    return std::exchange(m_isShown, isShown) != isShown;
}

} // namespace unprojector::gui
