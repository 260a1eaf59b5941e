#pragma once

#include "gui/view/surface_place.h"

#include <QColor>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>

#include <memory>
#include <optional>

namespace unprojector::gui {

/// A framebuffer for a surface whose size differs from the widget's: everything is drawn into it as
/// onto a widget of that size, then shown at its SurfacePlace. All calls need the OpenGL context
/// current.
class SurfaceCanvas : protected QOpenGLExtraFunctions {
public:
    /// The surface's size; nothing: the widget's, and the canvas is not used.
    std::optional<geometry::Surface> fixedSurface;

    void initialize() { initializeOpenGLFunctions(); }
    void release() { m_pixels.reset(); }

    /// Binds the canvas for drawing.
    /// @pre there is a fixed surface
    /// @return false if OpenGL cannot create such a framebuffer; then nothing is bound
    bool begin();
    /// Copies the canvas to the widget's framebuffer and leaves that bound.
    /// @param around  the colour beside it
    void show(unsigned widgetFramebuffer, const geometry::Surface &widget, const SurfacePlace &place,
              const QColor &around);

private:
    std::unique_ptr<QOpenGLFramebufferObject> m_pixels;
};

} // namespace unprojector::gui
