#pragma once

#include "gui/document/scene_document.h"

#include <QPoint>

#include <optional>

namespace unprojector::gui {

/// The pixel at which keys do what the mouse does at the pointer: the one last clicked or moved to,
/// at first the centre of the viewport.
class Crosshair {
public:
    /// @param document  outlives it
    explicit Crosshair(const SceneDocument &document) : m_document(document) {}

    geometry::DevicePixel pixel() const;
    /// The pixel's centre.
    geometry::WidgetPoint position() const;
    /// The pixel to draw while keys are used.
    std::optional<geometry::DevicePixel> shown() const { return m_isShown ? std::optional(pixel()) : std::nullopt; }

    /// Moves it to the pixel under a position; ignores positions outside the view.
    void put(const geometry::WidgetPoint &position);
    /// Moves it by device pixels, x to the right and y down, up to the view's edge.
    void move(const QPoint &way);
    /// Returns to the centre.
    void reset() { m_pixel.reset(); }
    /// @return whether this changes the drawing
    bool setShown(bool isShown);

private:
    const SceneDocument &m_document;
    std::optional<geometry::DevicePixel> m_pixel; ///< the last position
    bool m_isShown = false;
};

} // namespace unprojector::gui
