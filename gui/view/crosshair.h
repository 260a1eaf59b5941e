#pragma once

#include "gui/document/scene_document.h"

#include <QPoint>

#include <optional>

namespace unprojector::gui {

/// The pixel at which keys do what the mouse does at the pointer: the one last clicked or moved to, at first the one in the
/// middle of the viewport.
class Crosshair {
public:
    /// @param document  outlives it
    explicit Crosshair(const SceneDocument &document) : m_document(document) {}

    geometry::DevicePixel pixel() const;
    /// The pixel's centre.
    geometry::WidgetPoint position() const;
    /// The pixel while keys are used, to be drawn.
    std::optional<geometry::DevicePixel> shown() const { return m_isShown ? std::optional(pixel()) : std::nullopt; }

    /// Puts it onto the pixel under a position; outside the view it stays.
    void put(const geometry::WidgetPoint &position);
    /// Moves it by device pixels, x to the right and y down, as far as the view's edge.
    void move(const QPoint &way);
    /// Back to the middle.
    void reset() { m_pixel.reset(); }
    /// @return whether this changes what is drawn
    bool setShown(bool isShown);

private:
    const SceneDocument &m_document;
    std::optional<geometry::DevicePixel> m_pixel; ///< where it was put
    bool m_isShown = false;
};

} // namespace unprojector::gui
