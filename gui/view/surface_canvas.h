#pragma once

#include "gui/view/surface_place.h"

#include <QColor>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>

#include <memory>
#include <optional>

namespace unprojector::gui {

/// A framebuffer for a surface that is not as large as its widget: everything is drawn into it as onto a widget of its size,
/// and then it is shown where its SurfacePlace is. All calls need the OpenGL context current.
class SurfaceCanvas : protected QOpenGLExtraFunctions {
public:
    /// The surface's size; nothing: that of the widget, and the canvas is not used.
    std::optional<geometry::Surface> fixedSurface;

    void initialize() { initializeOpenGLFunctions(); }
    void release() { m_pixels.reset(); }

    /// Binds the canvas, for drawing.
    /// @pre there is a fixed surface
    /// @return false when OpenGL gives no such framebuffer; then nothing is bound
    bool begin();
    /// Puts the canvas onto the widget's framebuffer, which is bound then.
    /// @param around  the colour beside it
    void show(unsigned widgetFramebuffer, const geometry::Surface &widget, const SurfacePlace &place,
              const QColor &around);

private:
    std::unique_ptr<QOpenGLFramebufferObject> m_pixels;
};

} // namespace unprojector::gui
